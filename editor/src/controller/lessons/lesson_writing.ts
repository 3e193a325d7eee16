/// Commands of the lesson editor, and the drafts in the browser's storage.

import {newProject, saveProject} from "@rosy/codegen"
import {download, fileName} from "../../browser/local_files.ts"
import {fragmentOf} from "../../browser/share_link.ts"
import type {Store} from "../../browser/store.ts"
import {type LessonDraft, newDraft, writtenTitle} from "../../lesson_files/draft.ts"
import {lessonText, readDraft} from "../../lesson_files/draft_file.ts"
import {mistakesOf} from "../../lesson_files/draft_mistakes.ts"
import {draftsKey, mergeDrafts, readDrafts, writeDrafts} from "../../lesson_files/draft_storage.ts"
import {readLessonFile} from "../../lesson_files/lesson_file.ts"
import {editedDraft, type LessonEvent} from "../../state/lesson_state.ts"
import {tryToStore} from "../../storage/browser_storage.ts"
import type {LessonEditorCommands} from "../../ui/lesson_editor_commands.ts"
import {words} from "../../words/index.ts"
import type {WorldFile} from "../../worlds/world.ts"
import {writeWorld} from "../../worlds/world_encoder.ts"
import type {DocumentEditor} from "../document/document_editor.ts"
import type {ProgramLoader} from "../programs/program_loader.ts"
import {openLessonRehearsals} from "./lesson_rehearsals.ts"
import {refuseLesson} from "./lessons.ts"

/// The draft that this tab had open, over a reload.
const writingKey = "rosy.lesson.draft"

export function lessonEditorCommands(
  store: Store,
  loader: ProgramLoader,
  editor: DocumentEditor,
): LessonEditorCommands {
  const dispatch = (event: LessonEvent) => store.dispatch({kind: "lesson", event})
  const edit: LessonEditorCommands["edit"] = change => dispatch({kind: "draft-edited", edit: change})
  const now = () => editedDraft(store.now.lessons)
  const rehearsals = openLessonRehearsals(store)
  const rehearse = () => {
    const draft = now()
    if (draft !== null) rehearsals.start(draft)
  }
  const openProgram = programOpener(loader)
  const show = (draft: LessonDraft) => {
    store.dispatch({kind: "dialog", dialog: null})
    dispatch({kind: "draft-opened", draft})
  }
  return {
    edit,
    draft: now,
    begin() {
      editor.flush()
      const language = document.documentElement.lang
      show(
        newDraft(freshName(store.now.lessons.drafts), language, roomNow(store) ?? emptyRoom, program(store)),
      )
    },
    open(name) {
      const draft = store.now.lessons.drafts.find(one => one.name === name)
      if (draft !== undefined) show(draft)
    },
    openFile(text) {
      const read = readDraft(text, document.documentElement.lang)
      if (read.kind === "draft") show(read.draft)
      else refuseLesson(store, words.lessons.panel, read)
    },
    close: () => dispatch({kind: "draft-closed"}),
    remove: name => dispatch({kind: "draft-removed", name}),
    useRoom() {
      const room = roomNow(store)
      if (room !== null) edit({kind: "room", room})
    },
    useProgram(as) {
      editor.flush()
      edit({kind: as, program: program(store)})
    },
    program() {
      editor.flush()
      return program(store)
    },
    show(haskell) {
      const draft = now()
      if (draft !== null) openProgram(draft, haskell, draft.room, false)
    },
    rehearsal: rehearsals.latest,
    rehearse,
    ...trialCommands(store, loader, editor, rehearse),
    save() {
      const draft = now()
      if (draft !== null)
        download(fileName(titleOf(draft), "json"), lessonText(draft, "teacher"), "application/json")
    },
    link: async draft =>
      `${window.location.origin}/${await fragmentOf(lessonText(draft, "pupil"), "lesson")}`,
  }
}

/// Opens a program of a draft, in its lesson or beside it.
const programOpener =
  (loader: ProgramLoader) => (draft: LessonDraft, haskell: string, room: WorldFile, inLesson: boolean) => {
    const name = titleOf(draft)
    loader.openText(name, saveProject({...newProject(name), haskell, world: room}), {inLesson})
  }

/// Trials of a draft: as a pupil would have it, with its solution, and back to what was open before.
function trialCommands(
  store: Store,
  loader: ProgramLoader,
  editor: DocumentEditor,
  rehearse: () => void,
): Pick<LessonEditorCommands, "tryOut" | "trySolution" | "back"> {
  const dispatch = (event: LessonEvent) => store.dispatch({kind: "lesson", event})
  const openProgram = programOpener(loader)
  /// What was open on the page before a trial.
  let before: {readonly name: string; readonly text: string; readonly id: string | null} | null = null
  return {
    tryOut() {
      editor.flush()
      const draft = editedDraft(store.now.lessons)
      if (draft === null || mistakesOf(draft).length > 0) return
      const read = readLessonFile(lessonText(draft, "teacher"), draft.language)
      if (read.kind !== "lesson") return refuseLesson(store, titleOf(draft), read)
      const {lesson} = read
      before = {name: store.now.name, text: loader.projectText(), id: loader.storedId()}
      openProgram(draft, lesson.steps[0]?.program ?? lesson.start, lesson.room, true)
      dispatch({kind: "draft-tried", lesson, runs: store.now.runs})
      rehearse()
    },
    trySolution() {
      const {open} = store.now.lessons
      const draft = editedDraft(store.now.lessons)
      if (open === null || draft === null || draft.solution === null) return
      openProgram(draft, draft.solution, open.lesson.room, true)
      // Opening a program chooses the room again; the service receives the step to check afterwards.
      dispatch({kind: "stepped", to: open.at, runs: store.now.runs})
    },
    back() {
      const kept = before
      before = null
      if (kept === null) dispatch({kind: "closed"})
      else loader.openText(kept.name, kept.text, {id: kept.id})
    },
  }
}

const titleOf = (draft: LessonDraft): string => writtenTitle(draft) || words.lessonEditor.untitled

const program = (store: Store): string => store.now.document.program.text

function roomNow(store: Store): WorldFile | null {
  const {world} = store.now.room
  return world === null || world.open === true ? null : writeWorld(world)
}

/// In place of a room while the page has none.
const emptyRoom: WorldFile = {name: "empty", size: [6, 4], start: {x: 1, y: 2}}

/// A name that no draft has; lessons of other browsers may have it, so most of it is random.
function freshName(drafts: readonly LessonDraft[]): string {
  const name = `lesson-${Math.random().toString(36).slice(2, 8)}`
  return drafts.some(draft => draft.name === name) ? freshName(drafts) : name
}

/// Keeps the drafts, and which of them this tab shows.
export function storeDrafts(store: Store, storage: {readonly shared: Storage; readonly tab: Storage}): void {
  let kept = store.now.lessons
  store.onFrame(({lessons}) => {
    if (lessons.drafts !== kept.drafts) {
      const stored = readDrafts(storage.shared.getItem(draftsKey))
      tryToKeep(
        store,
        storage.shared,
        draftsKey,
        writeDrafts(mergeDrafts(stored, kept.drafts, lessons.drafts)),
      )
    }
    if (lessons.writing?.name !== kept.writing?.name) {
      if (lessons.writing === null) storage.tab.removeItem(writingKey)
      else tryToKeep(store, storage.tab, writingKey, lessons.writing.name)
    }
    kept = lessons
  })
}

/// Shows the draft again that this tab had open.
export function resumeDraft(store: Store, storage: {readonly tab: Storage}): void {
  const name = storage.tab.getItem(writingKey)
  const {drafts, open} = store.now.lessons
  const draft = drafts.find(one => one.name === name)
  if (draft !== undefined && open === null)
    store.dispatch({kind: "lesson", event: {kind: "draft-opened", draft}})
}

function tryToKeep(store: Store, storage: Storage, key: string, text: string): void {
  // A draft that is not kept has to be known.
  if (!tryToStore(storage, key, text)) store.dispatch({kind: "notice", notice: {kind: "not-saved", gone: []}})
}
