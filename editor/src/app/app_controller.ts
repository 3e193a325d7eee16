/// Application controller: creates the store and the parts of the page, and connects them. It decides nothing that `state` can decide.

import {isBoardGuest, isEmbedded, takeRunInAddress} from "../browser/browser_window.ts"
import {ownName, takeClassCode} from "../browser/preferences.ts"
import {fetchReader, fetchWorlds} from "../browser/remote_resources.ts"
import {createStore, type Store} from "../browser/store.ts"
import type {PageOfClass} from "../classroom/pupil/page_of_class.ts"
import {openClassMode} from "../controller/class_mode.ts"
import {openDemonstration} from "../controller/demonstration.ts"
import {type ColourScheme, openColourScheme} from "../controller/document/colour_scheme.ts"
import {openCompletions} from "../controller/document/completion_requests.ts"
import {documentCommands} from "../controller/document/document_commands.ts"
import {type DocumentEditor, openDocumentEditor} from "../controller/document/document_editor.ts"
import {noParts, type PageParts} from "../controller/document/page_parts.ts"
import {lessonEditorCommands, resumeDraft, storeDrafts} from "../controller/lessons/lesson_writing.ts"
import {
  lessonCommands,
  restrictToolbox,
  resumeLesson,
  storedLessons,
  storeLessons,
  withLessonFiles,
} from "../controller/lessons/lessons.ts"
import {pageCommands} from "../controller/page_commands.ts"
import {type FirstProgram, type ProgramRequests, programRequests} from "../controller/program_requests.ts"
import {openBackpack} from "../controller/programs/backpack.ts"
import {fileCommands, roomCommands} from "../controller/programs/file_commands.ts"
import {myProgramCommands} from "../controller/programs/my_programs.ts"
import {openProgramLoader, type ProgramLoader} from "../controller/programs/program_loader.ts"
import {fileOpening} from "../controller/programs/recordings.ts"
import {connectService, effectHandler, runProgram, sendAlive, storeAccess} from "../controller/runs.ts"
import {openDiagramMount} from "../controller/views/diagram_mount.ts"
import {mountBlocks, mountRoom, mountSource, mountWorldEditor} from "../controller/views/view_mounts.ts"
import {keySections, openViewUpdates} from "../controller/views/views.ts"
import {watchKeys, watchPrinting, watchWindow} from "../controller/window_events.ts"
import {openNumberDragging} from "../features/preview/number_dragging.ts"
import {openRoomTests} from "../jobs/room_tests.ts"
import {firstArrangement, withView} from "../state/arrangement.ts"
import {awaitsProgram, type PageState} from "../state/page_state.ts"
import {noRobots} from "../state/robots.ts"
import {openBackpackStore} from "../storage/backpack_store.ts"
import {openBrowserStorage, storageInMemory} from "../storage/browser_storage.ts"
import {openProgramStore, type ProgramStore} from "../storage/program_store.ts"
import type {AppController} from "../ui/app_context.ts"
import {openClipboard} from "../views/blocks/interaction/clipboard.ts"
import {openSpeaker} from "../views/room/sound_synthesis.ts"
import {words} from "../words/index.ts"

export function openController(): AppController {
  const parts = noParts()
  // Before the first program is opened, which clears the fragment of the address.
  const classCode = takeClassCode(window)
  const runsAtOnce = takeRunInAddress()
  const storage = isEmbedded() ? storageInMemory() : openBrowserStorage(window)
  const programStore = openProgramStore(storage.shared, storage.tab, gone =>
    store.dispatch({kind: "notice", notice: {kind: "made-way", gone}}),
  )
  const completions = openCompletions(message => parts.service?.send(message))
  const store = openStore(parts, programStore, storedLessons(storage))
  const editor = openDocumentEditor(store, parts)
  const loader = withLessonFiles(store, openProgramLoader(store, parts, programStore, editor))
  const requests = programRequests(store, parts, loader, programStore)
  const commands = documentCommands(store, parts, editor)
  const colours = openColourScheme(store, parts)

  updateViews(store, parts, editor, colours, programStore)
  const diagram = openDiagramMount(store, parts, editor)
  store.onFrame(diagram.update)

  const files = fileOpening(store, loader)
  const backpack = openBackpack(store, parts, editor, commands, openBackpackStore(storage.shared))
  const mounts = {store, parts, editor, commands, numbers: openNumberDragging(store, editor.flush)}
  const controller: AppController = {
    store,
    mountBlocks: host =>
      mountBlocks(host, mounts, programStore, openClipboard(storage.shared), backpack, colours.tone()),
    mountSource: host => mountSource(host, mounts, completions, loader.textEdited),
    mountWorldEditor: canvas => mountWorldEditor(canvas, mounts),
    mountRoom: canvas => mountRoom(canvas, mounts),
    mountDiagram: diagram.mount,
    diagram: diagram.commands,
    run: () => runProgram(store, editor),
    ...lessonCommands(store, loader),
    lessonEditor: lessonEditorCommands(store, loader, editor),
    openExample: name => void requests.openExample(name),
    ...myProgramCommands(store, loader, programStore),
    backpack,
    newProgram: loader.newProgram,
    demonstrate: demonstrationIn(store, loader, editor),
    openFile: files.openFile,
    openText: loader.openFile,
    openRecording: files.openRecording,
    roomTests: openRoomTests(store, editor.flush),
    undo: commands.undo,
    redo: commands.redo,
    format: commands.format,
    showProgram: commands.showProgram,
    applyFix: commands.applyFix,
    repairCharacters: commands.repairCharacters,
    keys: keySections,
    ...fileCommands(store, parts, editor, loader, colours),
    ...roomCommands(store, parts),
    ...pageCommands(store, parts),
  }
  storeLessons(store, storage)
  storeDrafts(store, storage)
  restrictToolbox(store, parts)
  watchWindow(store, files, requests)
  watchPrinting(store, parts, editor, colours)
  watchKeys(store, controller)
  sendAlive(store, parts)
  storeAccess(store)
  const page: PageOfClass = {
    store,
    loader,
    editor,
    parts,
    programStore,
    storage,
    code: classCode,
    reveal: controller.showFinding,
  }
  const classMode = openClassMode(() => loadClass(page))
  connectService(store, parts, completions, classMode.announced)
  const canStore = isEmbedded() || storage.isPersistent
  loadResources(store, parts, loader, requests, canStore, first => {
    if (first !== "chosen") resumeLessons(page)
    if (first === "linked" && runsAtOnce && store.now.robots.held === null) controller.run()
    classMode.programOpened()
    if (isBoardGuest()) loadBoardGuest(page)
  })
  return controller
}

/// Brings the views up to date in each frame.
function updateViews(
  store: Store,
  parts: PageParts,
  editor: DocumentEditor,
  colours: ColourScheme,
  programStore: ProgramStore,
): void {
  store.onFrame(editor.showBlocks)
  store.onFrame(
    openViewUpdates(parts, editor.typing.waits, store.redraw, colours.apply, programStore.setPreferences),
  )
  store.onFrame(state => state.worldEditor !== null && parts.worldEditor?.draw(state.worldEditor))
  noteVisit(store, programStore)
}

/// The question how to begin is asked until something was begun.
function noteVisit(store: Store, programStore: ProgramStore): void {
  let isNoted = false
  store.onFrame(state => {
    if (isNoted || state.welcoming || awaitsProgram(state)) return
    isNoted = true
    programStore.setVisited()
  })
}

function demonstrationIn(store: Store, loader: ProgramLoader, editor: DocumentEditor): () => void {
  return openDemonstration(store, {
    show: text => loader.openText(`${words.welcome.demonstration}.hs`, text),
    run: () => runProgram(store, editor),
  })
}

/// Loads class mode. A page in another site takes no part in a class.
function loadClass(page: PageOfClass): void {
  if (isEmbedded()) return
  void import("../classroom/pupil/classroom.tsx").then(({openClassroom}) => openClassroom(page))
}

/// Loads what the teacher's board does with a pupil's program that it shows.
function loadBoardGuest({store, parts, loader, editor}: PageOfClass): void {
  void import("../classroom/sharing/board_guest.ts").then(({openBoardGuest}) =>
    openBoardGuest(store, parts, loader, editor),
  )
}

/// Goes on with the lesson and the draft that this tab had open.
function resumeLessons({store, loader, storage}: PageOfClass): void {
  resumeLesson(store, loader, storage)
  resumeDraft(store, storage)
}

/// The blocks and the room; on the teacher's board the text as well, because a line of it can be chosen.
const embeddedArrangement = () => (isBoardGuest() ? firstArrangement : withView(firstArrangement, "blocks"))

function openStore(parts: PageParts, programStore: ProgramStore, lessons: Pick<PageState, "lessons">): Store {
  const embedded = isEmbedded()
  const store: Store = createStore(
    effectHandler(parts, openSpeaker(), event => store.dispatch(event)),
    {
      ...programStore.preferences(),
      ...lessons,
      ...(embedded ? {embedded, arrangement: embeddedArrangement()} : {}),
      robots: {...noRobots, who: ownName()},
    },
  )
  return store
}

function loadResources(
  store: Store,
  parts: PageParts,
  loader: ProgramLoader,
  requests: ProgramRequests,
  canStore: boolean,
  opened: (first: FirstProgram) => void,
): void {
  const ready = (first: FirstProgram) => {
    loader.allowEditing()
    opened(first)
    if (!canStore) store.dispatch({kind: "notice", notice: {kind: "no-storage"}})
  }
  void fetchReader().then(reader => {
    parts.reader = reader
    if (reader !== null && loader.openDeferred()) ready("chosen")
    else if (reader !== null) void requests.openFirst().then(ready)
    else store.dispatch({kind: "notice", notice: {kind: "no-reader"}})
  })
  void fetchWorlds().then(w => w.kind === "there" && store.dispatch({kind: "worlds-listed", worlds: w.value}))
}
