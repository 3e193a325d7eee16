/// Joins the parts: the store, the blocks, the Haskell pane, the room and the rim. Decides nothing that `state`
/// could decide.

import type {Desk} from "./page/desk.ts"
import {words} from "./page/words.ts"
import {openSpeaker} from "./room/sounds.ts"
import {openRoom, type RoomView} from "./room/view.ts"
import {download, fileName, pickFile} from "./run/files.ts"
import {fetchExample, fetchExamples, fetchWorlds} from "./run/library.ts"
import {openSession, type Session} from "./run/session.ts"
import {openShelf} from "./run/storage.ts"
import {watchDark, watchKeys, watchSize} from "./run/window.ts"
import {openSource, type SourcePane} from "./source/pane.ts"
import type {Order, PageState} from "./state/page.ts"
import {type Finding, innermostBlock, textOf} from "./state/program.ts"
import {glowing} from "./state/room.ts"
import {isActive} from "./state/run.ts"
import {openStore, type Store} from "./store.ts"

export type {Desk}

/// Nothing here until the parts are joined.
export function openDesk(address: string): Desk {
  const shelf = openShelf(window.localStorage)
  const speaker = openSpeaker()
  let session: Session | null = null
  let source: SourcePane | null = null
  let room: RoomView | null = null

  const perform = (order: Order) => {
    if (order.kind === "play") speaker.play(order.sound)
    else session?.send(order.message)
  }
  const store: Store = openStore(perform, shelf.liking())

  let drawn: PageState | null = null
  let glow = ""
  let systemDark = false
  store.onFrame((state, now) => {
    const before = drawn
    drawn = state
    if (source !== null) {
      if (before?.program !== state.program) source.setProgram(state.program)
      if (before?.findings !== state.findings)
        source.mark([...state.findings.blocks, ...state.findings.compiler, ...state.findings.run])
      if (before?.selected !== state.selected || before?.program !== state.program)
        source.link(state.selected === null ? null : textOf(state.program.spans, state.selected))
      const names = isActive(state.run) ? glowing(state.room) : []
      if (names.join(" ") !== glow) {
        glow = names.join(" ")
        source.glow(state.program.definitions.filter(d => names.includes(d.name)))
      }
    }
    if (before?.theme !== state.theme) paint()
    if (before !== null && likingOf(before) !== likingOf(state)) shelf.setLiking(JSON.parse(likingOf(state)))
    if (room?.draw(state.room, now)) store.redraw()
  })

  const paint = () => {
    const {theme} = store.now
    const dark = theme === "dark" || (theme === "auto" && systemDark)
    document.documentElement.dataset.theme = dark ? "dark" : "light"
    room?.recolour()
  }
  watchDark(dark => {
    systemDark = dark
    paint()
  })
  watchSize(size => store.dispatch({kind: "size", size}))
  watchKeys({
    space() {
      if (!isActive(store.now.run)) return false
      store.dispatch({kind: "stop-pressed"})
      return true
    },
    run: () => store.dispatch({kind: "run-pressed"}),
    undo: () => undefined,
    redo: () => undefined,
    save: () => undefined,
  })

  session = openSession(address, {
    heard: message => store.dispatch({kind: "heard", message}),
    lost: () => store.dispatch({kind: "link-lost"}),
    garbled: message => console.warn(`Rosy's service sent something this page does not know: ${message}`),
  })

  const openText = (name: string, text: string, welcome: boolean) => {
    const project = JSON.parse(text) as {name: string; haskell: string; world: string}
    store.dispatch({
      kind: "opened",
      opened: {
        name: project.name,
        world: project.world,
        program: {text: project.haskell, spans: [], definitions: [], families: {}},
        findings: [],
        welcome,
      },
    })
    void name
  }

  const openExample = async (name: string, welcome: boolean) => {
    const answer = await fetchExample(name)
    if (answer.kind === "failed") store.dispatch({kind: "notice", notice: {kind: "example-missing", name}})
    else openText(name, answer.value, welcome)
  }

  void fetchWorlds().then(w => w.kind === "there" && store.dispatch({kind: "worlds-listed", worlds: w.value}))
  void openExample(new URLSearchParams(window.location.search).get("example") ?? "accelerateAndPlay", true)

  return {
    store,
    mountBlocks(host) {
      void host
    },
    mountSource(host) {
      source = openSource(host, {
        label: words.haskellPane,
        placeholder: words.emptyHaskell,
        cursorMoved(offset) {
          const block = innermostBlock(store.now.program.spans, {start: offset, end: offset})
          if (block !== store.now.selected) store.dispatch({kind: "selected", block})
        },
      })
      drawn = null
      store.redraw()
    },
    mountRoom(canvas) {
      room = openRoom(canvas, () => store.redraw())
    },
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
    openKept() {},
    kept: () => shelf.kept(),
    newProgram() {},
    openFile: () => pickFile(".rosy,.json", (name, text) => openText(name, text, false)),
    saveFile: () => download(fileName(store.now.name, "rosy"), store.now.program.text, "application/json"),
    saveHaskell: () => download(fileName(store.now.name, "hs"), store.now.program.text, "text/plain"),
    undo() {},
    redo() {},
    show(finding: Finding) {
      if (finding.range !== null) source?.reveal(finding.range)
    },
  }
}

/// What is remembered of how the learner likes the page, as text.
function likingOf({theme, muted, view, layout}: PageState): string {
  return JSON.stringify({theme, muted, view, layout})
}
