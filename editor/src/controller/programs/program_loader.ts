/// Loader of programs: makes a text from a file, an example, a link or the program store the open document, restores its undo steps and the reading position
/// after a reload, and writes the open document as a project file. Where the text comes from is decided in `program_requests.ts`.

import {hashOf, newProject} from "@rosy/codegen"
import {isLiterate, literateToHaskell} from "@rosy/codegen/literate"
import type {Reader} from "@rosy/codegen/reader"
import {type TextFile, withoutMark} from "@rosy/codegen/text-file"
import {takeBlockPicture} from "../../browser/block_picture.ts"
import {addressFragment, exampleInAddress, setExampleInAddress} from "../../browser/browser_window.ts"
import {noticeOf} from "../../browser/local_files.ts"
import type {Store} from "../../browser/store.ts"
import {type Document, emptyHistory, type History} from "../../program/history.ts"
import {awaitsProgram, type Notice, type ReplacedRoom} from "../../state/page_state.ts"
import type {ProgramStore} from "../../storage/program_store.ts"
import type {ReadingPosition} from "../../storage/stored_values.ts"
import {offerRepair} from "../document/character_repair.ts"
import {
  emptyProject,
  isForeign,
  isWorldFile,
  longestProgram,
  type OpenedProject,
  readHaskell,
  readProject,
  writeHaskell,
  writeProject,
} from "../document/document_conversion.ts"
import type {DocumentEditor} from "../document/document_editor.ts"
import type {PageParts} from "../document/page_parts.ts"
import {parseHistory} from "../document/undo_storage.ts"
import {openAutosave} from "./autosave.ts"
import {deferOpening} from "./opening_deferral.ts"
import {orderRequests, type RequestOrder} from "./request_order.ts"

/// Where a program comes from.
export interface Origin {
  /// The first program of a new learner.
  readonly welcome?: boolean
  /// There was no program on this page before.
  readonly isFirstVisit?: boolean
  /// Its entry in the program store.
  readonly id?: string | null
  /// It belongs to the lesson that is open or being opened.
  readonly inLesson?: boolean
  /// It was open before the page was reloaded.
  readonly reloaded?: boolean
  /// A file from the learner's disk.
  readonly isFile?: boolean
  /// The first program of the page, not chosen in a dialog.
  readonly isFirst?: boolean
}

export interface ProgramLoader {
  /// Opens the text of a project file, or of Haskell if `name` ends with `.hs`.
  openText(name: string, text: string, origin?: Origin): void
  /// Calls `heard` before another program takes the place of the open one.
  onOpening(heard: () => void): void
  /// Opens a program or a room from the learner's disk.
  openFile(name: string, file: TextFile): void
  newProgram(): void
  /// The entry of the open program in the program store; `null` if it has none.
  storedId(): string | null
  /// Stores the open program now.
  store(): void
  /// The open document as the text of a project file, and as Haskell.
  projectText(): string
  haskell(): string
  /// Opens what was chosen before programs could be read. The result tells whether a program is open then.
  openDeferred(): boolean
  readonly requests: RequestOrder
  /// Stores the open program before a change of the text reaches the document.
  textEdited(): void
  allowEditing(): void
}

/// Identifies the program that the address names or contains; `null` for the learner's own.
export function programInAddress(): string | null {
  return exampleInAddress() ?? (addressFragment() === "" ? null : hashOf(addressFragment()))
}

export function openProgramLoader(
  store: Store,
  parts: PageParts,
  stored: ProgramStore,
  editor: DocumentEditor,
): ProgramLoader {
  let project = newProject("")
  const requests = orderRequests()
  const openings: (() => void)[] = []
  const notify = (notice: Notice) => store.dispatch({kind: "notice", notice})
  const projectText = () => {
    const {document, name, worldName, diagram} = store.now
    return writeProject(project, document, name, worldName, diagram.places)
  }
  const roomOf = (id: string | null) => (id === null ? null : stored.replacedRoom(id))
  const autosave = openAutosave(store, stored, {
    projectText,
    picture: () => takeBlockPicture(parts.blocksHost),
    settle: editor.flush,
    readingPosition: () => readingPosition(store, parts),
    becameOwn() {
      stored.setLeft(programInAddress())
      setExampleInAddress(null)
    },
    follow(text) {
      const opening = parts.reader === null ? null : readProject(parts.reader, text)
      if (opening?.kind !== "opened") return false
      const {document, world} = opening.opened
      project = opening.opened.project
      editor.typing.forget()
      store.dispatch({
        kind: "followed",
        name: project.name,
        world,
        replacedRoom: roomOf(autosave.place()),
        document,
        places: project.layout.diagram ?? {},
        at: performance.now(),
      })
      editor.showText()
      return true
    },
  })
  const show = (opened: OpenedProject, origin: Origin) => {
    const {id = null, reloaded = false, inLesson = false} = origin
    for (const heard of openings) heard()
    // A program that the learner chose and that is still being loaded is opened after the page's own first one.
    if (origin.isFirst !== true) requests.choose()
    autosave.opened(id, reloaded)
    setExampleInAddress(null)
    editor.typing.forget()
    project = opened.project
    const history = reloaded ? storedHistory(parts, stored, opened.document) : emptyHistory
    store.dispatch({kind: "opened", opened: openingOf(opened, origin, history, roomOf(id))})
    editor.showText()
    allowEditing(parts)
    if (!reloaded || !restoreReadingPosition(store, parts, stored, editor)) {
      editor.showBlocks()
      parts.blocks?.goToStart(inLesson)
      parts.room?.whole()
    }
  }
  const deferral = deferOpening(() => parts.reader)
  const openText = (name: string, text: string, origin: Origin = {}) =>
    deferral.open(reader => {
      const {opened, notice} = readProgram(reader, name, text, (origin.id ?? null) !== null)
      if (opened !== undefined) show(opened, origin)
      if (notice !== undefined) notify(notice)
      else if (opened !== undefined && origin.isFile === true) {
        const {text} = opened.document.program
        offerRepair(store, name, text, [{start: 0, end: text.length}])
      }
    })
  return {
    openText,
    onOpening: heard => openings.push(heard),
    openFile: fileOpener(store, openText),
    newProgram: () => deferral.open(reader => show(emptyProject(reader), {})),
    openDeferred() {
      deferral.release()
      return !awaitsProgram(store.now)
    },
    storedId: autosave.place,
    store: autosave.flush,
    projectText,
    haskell: () => writeHaskell(project, store.now.document),
    requests,
    textEdited: autosave.edited,
    allowEditing: () => allowEditing(parts),
  }
}

/// A program as the page takes it up.
function openingOf(
  {project, world, document, isNew}: OpenedProject,
  {welcome = false, isFirstVisit = false, inLesson = false, isFirst = false}: Origin,
  history: History,
  replacedRoom: ReplacedRoom | null,
) {
  const {name} = project
  const places = project.layout.diagram ?? {}
  return {
    name,
    places,
    world,
    document,
    history,
    welcome,
    isFirstVisit,
    isNew,
    inLesson,
    isFirst,
    replacedRoom,
  }
}

/// Opens programs and rooms from the learner's disk.
function fileOpener(store: Store, openText: ProgramLoader["openText"]): ProgramLoader["openFile"] {
  const notify = (notice: Notice) => store.dispatch({kind: "notice", notice})
  const openLiterate = (name: string, text: string) => {
    const haskell = literateToHaskell(withoutMark(text))
    if (haskell === null) return notify({kind: "not-program", name})
    openText(name.replace(/\.lhs$/i, ".hs"), haskell, {isFile: true})
  }
  return (path, file) => {
    // An accent that is a character of its own looks the same and is not found.
    const name = path.slice(path.lastIndexOf("/") + 1).normalize("NFC")
    if (file.kind !== "text") return notify(noticeOf(name, file))
    const {text} = file
    if (withoutMark(text).trim() === "") return notify({kind: "empty-file", name})
    if (store.now.worldEditor !== null || isWorldFile(name, text))
      store.dispatch({kind: "world-file-read", name, text})
    else if (isLiterate(name)) openLiterate(name, text)
    else if (isForeign(name, text)) notify({kind: "not-program", name})
    else openText(name, text, {isFile: true})
  }
}

/// The undo steps that were stored for the program before a reload.
function storedHistory({reader}: PageParts, stored: ProgramStore, document: Document): History {
  const steps = stored.undoSteps()
  const kept = reader === null || steps === null ? null : parseHistory(reader, steps, document)
  return kept ?? emptyHistory
}

interface ReadProgram {
  readonly opened?: OpenedProject
  readonly notice?: Notice
}

/// A program in the program store is opened at any size: it is the learner's already.
function readProgram(reader: Reader, name: string, text: string, isStored: boolean): ReadProgram {
  const isTooLarge = (haskell: string) => !isStored && haskell.length > longestProgram
  const tooLarge: ReadProgram = {notice: {kind: "too-large", name}}
  if (/\.hs$/i.test(name))
    return isTooLarge(text) ? tooLarge : {opened: readHaskell(reader, name.replace(/\.hs$/i, ""), text)}
  const opening = readProject(reader, text, isTooLarge)
  if (opening === null) return tooLarge
  const problem = opening.kind === "opened" ? opening.notice : opening
  return {
    ...(opening.kind === "opened" ? {opened: opening.opened} : {}),
    ...(problem === undefined
      ? {}
      : {notice: {kind: "unreadable-file", name, message: problem.message, hint: problem.hint}}),
  }
}

function readingPosition(store: Store, {source, blocks}: PageParts): ReadingPosition | null {
  if (source === null || blocks === null || store.now.document.view === null) return null
  return {text: hashOf(store.now.document.program.text), ...source.position(), ...blocks.place()}
}

/// Whether a position was stored for the program as it is.
function restoreReadingPosition(
  store: Store,
  parts: PageParts,
  stored: ProgramStore,
  editor: DocumentEditor,
): boolean {
  const position = stored.readingPosition()
  if (position === null || position.text !== hashOf(store.now.document.program.text)) return false
  parts.source?.goTo(position)
  editor.showBlocks()
  parts.blocks?.goTo(position)
  return true
}

/// Before the first program is open nothing can be edited.
function allowEditing({source, blocksHost}: PageParts): void {
  source?.setEditable(true)
  if (blocksHost !== null) blocksHost.inert = false
}
