/// Application controller: creates the store and the parts of the page, and connects them. It decides nothing that `state` can decide.

import {openClipboard} from "../blocks/interaction/clipboard.ts"
import {openBrowserStorage, storageInMemory} from "../browser/browser_storage.ts"
import {isBoardGuest, isEmbedded, takeRunInAddress} from "../browser/browser_window.ts"
import {ownName, takeClassCode} from "../browser/preferences.ts"
import {openProgramStore, type ProgramStore} from "../browser/program_store.ts"
import {fetchReader, fetchWorlds} from "../browser/remote_resources.ts"
import type {PageOfClass} from "../classroom/page_of_class.ts"
import type {AppController} from "../page/app_context.ts"
import {openNumberDragging} from "../preview/number_dragging.ts"
import {openSpeaker} from "../room/sound_synthesis.ts"
import {openRoomTests} from "../rooms/room_tests.ts"
import {firstArrangement, withView} from "../state/arrangement.ts"
import type {PageState} from "../state/page_state.ts"
import {noRobots} from "../state/robots.ts"
import {createStore, type Store} from "../state/store.ts"
import {openClassMode} from "./class_mode.ts"
import {openColourScheme} from "./colour_scheme.ts"
import {openCompletions} from "./completion_requests.ts"
import {openDiagramMount} from "./diagram_mount.ts"
import {documentCommands} from "./document_commands.ts"
import {openDocumentEditor} from "./document_editor.ts"
import {fileCommands, roomCommands} from "./file_commands.ts"
import {lessonEditorCommands, resumeDraft, storeDrafts} from "./lesson_writing.ts"
import {
  lessonCommands,
  restrictToolbox,
  resumeLesson,
  storedLessons,
  storeLessons,
  withLessonFiles,
} from "./lessons.ts"
import {myProgramCommands} from "./my_programs.ts"
import {pageCommands} from "./page_commands.ts"
import {noParts, type PageParts} from "./page_parts.ts"
import {openProgramLoader, type ProgramLoader} from "./program_loader.ts"
import {type ProgramRequests, programRequests} from "./program_requests.ts"
import {fileOpening} from "./recordings.ts"
import {connectService, effectHandler, runProgram, sendAlive, storeAccess} from "./runs.ts"
import {mountBlocks, mountRoom, mountSource, mountWorldEditor} from "./view_mounts.ts"
import {keySections, openViewUpdates} from "./views.ts"
import {watchKeys, watchPrinting, watchWindow} from "./window_events.ts"

export function openController(): AppController {
  const parts = noParts()
  // Before the first program is opened, which clears the fragment of the address.
  const classCode = takeClassCode(window)
  const runsAtOnce = takeRunInAddress()
  const storage = isEmbedded() ? storageInMemory() : openBrowserStorage(window)
  const programStore = openProgramStore(storage.shared, storage.tab)
  const completions = openCompletions(message => parts.service?.send(message))
  const store = openStore(parts, programStore, storedLessons(storage))
  const editor = openDocumentEditor(store, parts)
  const loader = withLessonFiles(store, openProgramLoader(store, parts, programStore, editor))
  const requests = programRequests(store, loader, programStore)
  const commands = documentCommands(store, parts, editor)
  const colours = openColourScheme(store, parts)

  store.onFrame(editor.showBlocks)
  store.onFrame(
    openViewUpdates(parts, editor.typing.waits, store.redraw, colours.apply, programStore.setPreferences),
  )
  store.onFrame(state => state.worldEditor !== null && parts.worldEditor?.draw(state.worldEditor))

  const diagram = openDiagramMount(store, parts)
  store.onFrame(diagram.update)

  const files = fileOpening(store, loader)
  const mounts = {store, parts, editor, commands, numbers: openNumberDragging(store, editor.flush)}
  const controller: AppController = {
    store,
    mountBlocks: host =>
      mountBlocks(host, mounts, programStore, openClipboard(storage.shared), colours.tone()),
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
    newProgram: loader.newProgram,
    openFile: files.openFile,
    openRecording: files.openRecording,
    roomTests: openRoomTests(store, editor.flush),
    undo: commands.undo,
    redo: commands.redo,
    format: commands.format,
    showProgram: commands.showProgram,
    applyFix: commands.applyFix,
    keys: keySections,
    ...fileCommands(store, editor, loader),
    ...roomCommands(store, parts),
    ...pageCommands(store, parts),
  }
  storeLessons(store, storage)
  storeDrafts(store, storage)
  restrictToolbox(store, parts)
  watchWindow(store, files.opened, requests)
  watchPrinting(store, parts, editor, colours)
  watchKeys(store, controller)
  sendAlive(store, parts)
  storeAccess(store)
  const classMode = openClassMode(() =>
    loadClass({
      store,
      loader,
      editor,
      parts,
      shelf: programStore,
      storage,
      code: classCode,
      reveal: controller.showFinding,
    }),
  )
  connectService(store, parts, completions, classMode.announced)
  const canStore = isEmbedded() || storage.isPersistent
  loadResources(store, parts, loader, requests, canStore, first => {
    if (first !== "chosen") {
      resumeLesson(store, loader, storage)
      resumeDraft(store, storage)
    }
    if (first === "linked" && runsAtOnce && store.now.robots.held === null) controller.run()
    classMode.programOpened()
    if (isBoardGuest())
      void import("../classroom/board_guest.ts").then(({openBoardGuest}) =>
        openBoardGuest(store, parts, loader, editor),
      )
  })
  return controller
}

/// Loads class mode. A page in another site takes no part in a class.
function loadClass(page: PageOfClass): void {
  if (isEmbedded()) return
  void import("../classroom/classroom.tsx").then(({openClassroom}) => openClassroom(page))
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

/// Origin of the first program: the learner chose it before programs could be read, a link contains it, or another one.
type FirstProgram = "chosen" | "linked" | "other"

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
    else if (reader !== null) void requests.openFirst().then(linked => ready(linked ? "linked" : "other"))
    else store.dispatch({kind: "notice", notice: {kind: "no-reader"}})
  })
  void fetchWorlds().then(w => w.kind === "there" && store.dispatch({kind: "worlds-listed", worlds: w.value}))
}
