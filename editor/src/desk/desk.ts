/// Joins the parts: the store, the blocks, the Haskell pane, the room and the rim. Decides nothing that `state`
/// could decide.

import type {SavedWorkspace} from "@rosy/codegen"
import * as codegen from "@rosy/codegen"
import {formatted, type Reader} from "@rosy/codegen/reader"
import {type BlocksView, openBlocks, sameBlocks} from "../blocks/index.ts"
import type {Desk} from "../page/desk.ts"
import {openWorldEditor, type WorldEditorView} from "../room/editorview.ts"
import {openSpeaker} from "../room/sounds.ts"
import {openRoom, type RoomView} from "../room/view.ts"
import {openClipboard} from "../run/clipboard.ts"
import {openExplanations} from "../run/explanations.ts"
import {download, downloadBlob, fileName, pickFile, watchDrops} from "../run/files.ts"
import {type Film, startFilm, takePicture} from "../run/film.ts"
import {fetchReader} from "../run/grammar.ts"
import {fetchExample, fetchExamples, fetchRooms, fetchWorlds} from "../run/library.ts"
import {chooseLanguage, keepOwnName, ownName} from "../run/liking.ts"
import {openCode} from "../run/robots.ts"
import {openSession, type Session} from "../run/session.ts"
import {openShelf, type Whereabouts} from "../run/storage.ts"
import {addressNames, wantedExample, watchDark, watchKeys, watchSight, watchSize} from "../run/window.ts"
import {openSource, type SourcePane} from "../source/pane.ts"
import {putting} from "../source/putting.ts"
import {type Fix, mended, movedFix, signatureFix, whereToGoOn} from "../state/fixes.ts"
import {drives} from "../state/helm.ts"
import {emptyHistory} from "../state/history.ts"
import {awaitsProgram, type Order} from "../state/page.ts"
import {type Finding, innermostBlock, mover} from "../state/program.ts"
import {noRobots} from "../state/robots.ts"
import {isActive} from "../state/run.ts"
import {toCsv} from "../state/values.ts"
import {openStore} from "../store.ts"
import {words} from "../words/index.ts"
import {openAutosave} from "./autosave.ts"
import {openCompletions} from "./completions.ts"
import {drawParts} from "./draw.ts"
import {keySections} from "./keys.ts"
import {merged} from "./merge.ts"
import {
  analysed,
  emptyProject,
  isForeign,
  isWorldFile,
  longestProgram,
  type OpenedProject,
  readHaskell,
  readProject,
  withBlocks,
  withText,
  writeHaskell,
  writeProject,
} from "./programs.ts"
import {renamed} from "./rename.ts"
import {snippets} from "./snippets.ts"
import {readSteps} from "./steps.ts"
import {openTyping} from "./typing.ts"

/// Milliseconds between the last change and the question to the compiler.
const checkPause = 150

/// Milliseconds between two signs that somebody watches a real robot (protocol §4, `alive`).
const watchPause = 100

/// What a newcomer finds.
const firstExample = "accelerateAndPlay"

export function openDesk(address: string): Desk {
  const shelf = openShelf(window.localStorage, window.sessionStorage)
  const speaker = openSpeaker()
  const explanations = openExplanations()
  const answers = openCompletions(message => session?.send(message))
  let session: Session | null = null
  let blocks: BlocksView | null = null
  let blocksHost: HTMLElement | null = null
  let source: SourcePane | null = null
  let room: RoomView | null = null
  let roomCanvas: HTMLCanvasElement | null = null
  let film: Film | null = null
  let worldEditor: WorldEditorView | null = null
  let reader: Reader | null = null
  let project = codegen.newProject("")
  /// The blocks as the block view has them; when the document has others, they are loaded.
  let shown: SavedWorkspace | null = null
  let systemDark = false

  let checking: ReturnType<typeof setTimeout> | undefined
  const perform = (order: Order) => {
    if (order.kind === "play") speaker.play(order.sound)
    else if (order.kind === "pick-world")
      pickFile(".json", (name, text) => store.dispatch({kind: "world-file-read", name, text}))
    else if (order.kind === "save-world")
      download(fileName(order.name, "json"), order.text, "application/json")
    else if (order.message.op === "check") {
      // While somebody types only the last text is worth a question.
      clearTimeout(checking)
      checking = setTimeout(() => session?.send(order.message), checkPause)
    } else session?.send(order.message)
  }
  const store = openStore(perform, {...shelf.liking(), robots: {...noRobots, who: ownName()}})
  const isDark = () => store.now.theme === "dark" || (store.now.theme === "auto" && systemDark)
  const projectText = () => writeProject(project, store.now.document, store.now.name, store.now.worldName)
  const autosave = openAutosave(
    store,
    shelf,
    projectText,
    () => flush(),
    () => whereabouts(),
    () => addressNames(null),
  )

  const typing = openTyping(() => flush())
  const paint = () => {
    document.documentElement.dataset.theme = isDark() ? "dark" : "light"
    blocks?.setTone(isDark() ? "dark" : "light")
    room?.recolour()
    worldEditor?.recolour()
  }
  /// Shows the text of the program as it is: at once, for what is typed before the next picture is typed into it.
  const write = () => source?.setProgram(store.now.document.program)
  /// Shows the blocks of the document as it is.
  const follow = () => {
    const {document} = store.now
    if (document.workspace === shown || blocks === null || awaitsProgram(store.now)) return
    const began = performance.now()
    shown = document.workspace
    blocks.load(shown)
    store.dispatch({kind: "analysed", before: document, document: analysed(document, blocks.inference())})
    typing.cost(performance.now() - began)
  }
  store.onFrame(follow)
  store.onFrame(
    drawParts(
      () => ({blocks, source, room}),
      typing.waits,
      () => store.redraw(),
      paint,
      liking => shelf.setLiking(liking),
    ),
  )

  store.onFrame(state => {
    if (state.worldEditor !== null) worldEditor?.draw(state.worldEditor)
  })

  /// Lets hands on the program: nobody writes or builds where the first one is about to stand.
  const lend = () => {
    source?.setEditable(true)
    if (blocksHost !== null) blocksHost.inert = false
  }
  /// How many programs were wished for: one that comes when the learner has gone on to another comes too late.
  let wishes = 0
  const show = (opened: OpenedProject, welcome: boolean, place: string | null, again = false) => {
    wishes += 1
    autosave.opened(place, again)
    addressNames(null)
    typing.forget()
    project = opened.project
    const {document, world} = opened
    const steps = again ? shelf.steps() : null
    const kept = reader === null || steps === null ? null : readSteps(reader, steps, document)
    const history = kept ?? emptyHistory
    store.dispatch({kind: "opened", opened: {name: project.name, world, document, history, welcome}})
    write()
    lend()
    if (again) goBack()
  }
  /// Where the learner is in the program.
  const whereabouts = (): Whereabouts | null => {
    if (source === null || blocks === null || store.now.document.view === null) return null
    return {text: codegen.hashOf(store.now.document.program.text), ...source.place(), ...blocks.place()}
  }
  /// Goes where the learner was before the page was loaded again.
  const goBack = () => {
    const {program} = store.now.document
    const was = shelf.place()
    if (was === null || was.text !== codegen.hashOf(program.text)) return
    source?.goTo(was)
    follow()
    blocks?.goTo(was)
  }
  const openText = (name: string, text: string, welcome: boolean, place: string | null, again = false) => {
    if (reader === null) return
    const tooLarge = (haskell: string) => {
      // What is kept here is the learner's already.
      if (place !== null || haskell.length <= longestProgram) return false
      store.dispatch({kind: "notice", notice: {kind: "too-large", name}})
      return true
    }
    if (/\.hs$/i.test(name)) {
      if (!tooLarge(text)) show(readHaskell(reader, name.replace(/\.hs$/i, ""), text), welcome, place)
      return
    }
    const opening = readProject(reader, text, tooLarge)
    if (opening === null) return
    if (opening.kind === "opened") show(opening.opened, welcome, place, again)
    else {
      const {message, hint} = opening
      store.dispatch({kind: "notice", notice: {kind: "unreadable-file", name, message, hint}})
    }
  }
  /// A file from the learner's disk: a program, or a room.
  const openAny = (name: string, text: string | null) => {
    if (text === null) store.dispatch({kind: "notice", notice: {kind: "not-text", name}})
    else if (store.now.worldEditor !== null || isWorldFile(name, text))
      store.dispatch({kind: "world-file-read", name, text})
    else if (isForeign(name, text)) store.dispatch({kind: "notice", notice: {kind: "not-program", name}})
    else openText(name, text, false, null)
  }
  const openExample = async (name: string, welcome: boolean, named = true, again = false) => {
    wishes += 1
    const wish = wishes
    const answer = await fetchExample(name)
    if (wish !== wishes) return true
    if (answer.kind === "there") {
      openText(name, answer.value, welcome, null, again)
      if (named) addressNames(name)
    } else store.dispatch({kind: "notice", notice: {kind: "example-missing", name}})
    return answer.kind === "there"
  }
  const openUsual = async () => {
    const last = shelf.current()
    if (last !== null) openText(words.yourProgram, last.text, false, last.id, true)
    else await openExample(firstExample, true, false, true)
  }
  const openFirst = async () => {
    const wanted = wantedExample()
    if (wanted === null) return openUsual()
    if (await openExample(wanted, wanted === firstExample, true, true)) return
    // A link that leads nowhere: the page is there all the same, and says so.
    const {notice} = store.now
    await openUsual()
    store.dispatch({kind: "notice", notice})
  }

  const cursorMoved = (offset: number) => {
    const block = innermostBlock(store.now.document.program.spans, {start: offset, end: offset})
    store.dispatch({kind: "selected", block, in: "haskell"})
  }
  /// Brings what was typed to the document, and so to the blocks.
  const flush = () => {
    if (reader === null) return
    const text = typing.take()
    if (text === null) return
    const began = performance.now()
    const document = withText(reader, store.now.document, text)
    store.dispatch({kind: "program-changed", document, by: "haskell", at: began})
    if (source !== null) cursorMoved(source.cursor())
    typing.cost(performance.now() - began)
  }
  /// Changes the text by a command: one step, whatever was typed before it.
  const rewrite = (text: string) => {
    if (reader === null || text === store.now.document.program.text) return
    const document = withText(reader, store.now.document, text)
    store.dispatch({kind: "program-changed", document, by: "command", at: performance.now()})
    write()
  }
  const mend = (fix: Fix) => {
    // What was typed in the meantime has moved the places that the fix is about.
    const {text} = store.now.document.program
    flush()
    const now = store.now.document.program.text
    const still = movedFix(mover(text, now), fix)
    rewrite(mended(now, still))
    source?.choose(whereToGoOn(still))
  }
  const format = () => {
    flush()
    if (reader === null) return
    const {text, left} = formatted(reader, store.now.document.program.text)
    rewrite(text)
    if (left > 0) store.dispatch({kind: "notice", notice: {kind: "not-formatted", left}})
  }
  const undo = () => {
    if (store.now.worldEditor !== null) return store.dispatch({kind: "world-edited", edit: {kind: "undo"}})
    flush()
    store.dispatch({kind: "undo-pressed"})
    // What was typed and taken back within one picture leaves the program as it was drawn; the pane has it still.
    write()
  }
  const redo = () => {
    if (store.now.worldEditor !== null) return store.dispatch({kind: "world-edited", edit: {kind: "redo"}})
    flush()
    store.dispatch({kind: "redo-pressed"})
    write()
  }
  const run = () => {
    if (awaitsProgram(store.now)) return
    flush()
    store.dispatch({kind: "run-pressed", seed: newSeed()})
  }
  const saveFile = () => download(fileName(store.now.name, "rosy"), projectText(), "application/json")

  watchDrops(openAny)
  watchDark(dark => {
    systemDark = dark
    paint()
  })
  watchSize(size => store.dispatch({kind: "size", size}))
  watchSight(() => store.dispatch({kind: "out-of-sight"}))
  // Real wheels turn only while a page that is seen and does not hang says so.
  setInterval(() => {
    if (drives(store.now) && document.visibilityState === "visible") session?.send({op: "alive"})
  }, watchPause)
  const code = openCode(window)
  const known = code.read()
  if (known !== null) store.dispatch({kind: "robots-unlocked", code: known})
  store.onFrame(({robots}) => {
    if (robots.offered?.locked === false || robots.refused !== null) code.keep(robots.code)
    if (robots.who !== ownName()) keepOwnName(robots.who)
  })
  watchKeys({
    emergency() {
      if (!drives(store.now)) return false
      store.dispatch({kind: "estop-pressed"})
      return true
    },
    space() {
      if (!isActive(store.now.run)) return false
      store.dispatch({kind: "stop-pressed"})
      return true
    },
    run() {
      if (store.now.worldEditor !== null) return
      run()
    },
    undo,
    redo,
    save: saveFile,
    help: () => store.dispatch({kind: "dialog", dialog: "keys"}),
  })
  session = openSession(address, {
    heard(message) {
      if (message.op === "completed") answers.heard(message)
      store.dispatch({kind: "heard", message})
    },
    lost: () => store.dispatch({kind: "link-lost"}),
    garbled: message => console.warn(`Rosy's service sent something this page does not know: ${message}`),
  })
  void fetchReader().then(found => {
    reader = found
    if (found !== null) void openFirst().then(lend)
    else store.dispatch({kind: "notice", notice: {kind: "no-reader"}})
  })
  void fetchWorlds().then(w => w.kind === "there" && store.dispatch({kind: "worlds-listed", worlds: w.value}))

  return {
    store,
    mountBlocks(host) {
      blocksHost = host
      host.inert = reader === null
      // Who goes to the blocks finds them as the text is: what is opened there would close when they follow.
      host.addEventListener("pointerenter", () => {
        flush()
        follow()
      })
      blocks = openBlocks(host, {
        language: codegen,
        tone: isDark() ? "dark" : "light",
        rightToLeft: document.documentElement.dir === "rtl",
        level: shelf.level() ?? "reactions",
        onLevel: level => shelf.setLevel(level),
        clipboard: openClipboard(window.localStorage),
        outside: {
          area: () => source?.area() ?? null,
          over(block, x, y) {
            const code = codegen.codeOf(block)
            const at = source?.aim(x, y) ?? null
            if (code === undefined || at === null) return source?.carry(null)
            const {text} = store.now.document.program
            source?.carry({code: code.text, at: putting(text, at, code).from, x, y})
          },
          left: () => source?.carry(null),
          dropped(block, x, y) {
            flush()
            const code = codegen.codeOf(block)
            const at = source?.aim(x, y) ?? null
            if (code === undefined || at === null) return
            const {text} = store.now.document.program
            const {from, to, insert, select} = putting(text, at, code)
            rewrite(text.slice(0, from) + insert + text.slice(to))
            source?.choose(select)
          },
        },
        history: {
          undo,
          redo,
          canUndo: () => store.now.history.past.length > 0,
          canRedo: () => store.now.history.future.length > 0,
        },
      })
      blocks.onChange(({workspace: edited, inference}) => {
        flush()
        if (reader === null || (shown !== null && sameBlocks(edited, shown))) return
        const now = store.now.document.workspace
        const workspace = shown === null || shown === now ? edited : merged(shown, edited, now)
        const document = withBlocks(reader, store.now.document, workspace, inference)
        if (document.workspace === workspace) shown = workspace
        store.dispatch({kind: "program-changed", document, by: "blocks", at: performance.now()})
        write()
      })
      blocks.onSelect(block => store.dispatch({kind: "selected", block: block ?? null, in: "blocks"}))
    },
    mountSource(host) {
      source = openSource(host, {
        label: words.haskellPane,
        description: words.haskellKeys,
        completer: {
          fitting: answers.fitting,
          snippets,
          fromToolbox: words.fromToolbox,
        },
        renamer: {
          rename(offset, old, name) {
            flush()
            const answer = renamed(store.now.document, offset, old, name)
            if (!answer.ok) return answer.why
            rewrite(answer.text)
            return null
          },
          words: {label: words.newName, rename: words.rename},
        },
        phrases: words.editor,
        longest: longestProgram,
        tooLong: () => store.dispatch({kind: "notice", notice: {kind: "too-large", name: words.pastedText}}),
        format,
        explainer: {about: explanations.about, more: words.readMore},
        cursorMoved,
        mend,
        fixHere(offset) {
          const {document, declared} = store.now
          return signatureFix(document.program, declared, offset, words.writeType)
        },
        edited: typing.typed,
      })
    },
    mountWorldEditor(canvas) {
      const view = openWorldEditor(canvas, {
        changed: () => store.redraw(),
        edited: edit => store.dispatch({kind: "world-edited", edit}),
      })
      worldEditor = view
      store.redraw()
      return () => {
        view.dispose()
        worldEditor = null
      }
    },
    mountRoom(canvas) {
      roomCanvas = canvas
      room = openRoom(canvas, {
        changed: () => store.redraw(),
        placed: teleport => store.dispatch({kind: "hand", hand: {teleport}}),
        pushed: (thing, pose) => store.dispatch({kind: "hand", hand: {move: {thing, ...pose}}}),
        holds: thing => store.dispatch({kind: "held", thing}),
        follows: follows => store.dispatch({kind: "follows", follows}),
      })
    },
    run,
    openRooms() {
      store.dispatch({kind: "dialog", dialog: "rooms"})
      if (store.now.rooms === null)
        void fetchRooms(store.now.worlds).then(rooms => store.dispatch({kind: "rooms-read", rooms}))
    },
    format,
    openGallery() {
      store.dispatch({kind: "dialog", dialog: "gallery"})
      if (store.now.gallery.kind === "there") return
      store.dispatch({kind: "gallery", gallery: {kind: "asked"}})
      void fetchExamples().then(answer =>
        store.dispatch({
          kind: "gallery",
          gallery: answer.kind === "there" ? {kind: "there", examples: answer.value} : {kind: "failed"},
        }),
      )
    },
    openExample: name => void openExample(name, false),
    openKept(id) {
      const text = shelf.read(id)
      if (text !== null) openText(words.yourProgram, text, false, id)
    },
    kept: () => shelf.kept(),
    newProgram: () => reader !== null && show(emptyProject(reader), false, null),
    openFile: () => pickFile(".rosy,.json,.hs", openAny),
    saveFile,
    saveHaskell: () =>
      download(fileName(store.now.name, "hs"), writeHaskell(project, store.now.document), "text/plain"),
    saveTable: () => download(fileName(store.now.name, "csv"), toCsv(store.now.room.recording), "text/csv"),
    zoomRoom: factor => room?.zoom(factor),
    wholeRoom: () => room?.whole(),
    savePicture() {
      if (roomCanvas === null) return
      void takePicture(roomCanvas).then(
        picture => picture !== null && downloadBlob(fileName(store.now.name, "png"), picture),
      )
    },
    film(going) {
      if (!going) return film?.stop()
      if (roomCanvas === null || film !== null) return
      film = startFilm(roomCanvas, made => {
        film = null
        store.dispatch({kind: "films", films: false})
        if (made === null) store.dispatch({kind: "notice", notice: {kind: "no-film"}})
        else downloadBlob(fileName(store.now.name, "webm"), made)
      })
      store.dispatch({kind: "films", films: film !== null})
    },
    undo,
    redo,
    keys: keySections,
    mend,
    speak(language) {
      chooseLanguage(language)
      const address = new URL(window.location.href)
      address.searchParams.delete("lang")
      // An address that stays the same is only loaded again when asked to.
      if (address.href === window.location.href) window.location.reload()
      else window.location.assign(address)
    },
    show(finding: Finding) {
      const {size, arrangement, region} = store.now
      if (size === "phone" && region === "room") store.dispatch({kind: "region", region: "blocks"})
      const blocksShown =
        size === "phone" ? store.now.region === "blocks" : !arrangement.hidden.includes("blocks")
      if (finding.range !== null) source?.reveal(finding.range)
      if (finding.block !== null) {
        store.dispatch({kind: "selected", block: finding.block, in: "blocks"})
        if (blocksShown) blocks?.select(finding.block)
      }
    },
  }
}

/// Luck for a run: any number that the service's dice take (protocol §4).
const newSeed = () => Math.floor(Math.random() * 2 ** 31)
