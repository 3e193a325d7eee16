/// Commands of the lessons: their list, opening one, its steps and programs, and the progress in the browser's storage.

import {newProject, saveProject} from "@rosy/codegen"
import {fetchChallenges, fetchLesson, fetchLessons} from "../../browser/remote_resources.ts"
import {fragmentOf} from "../../browser/share_link.ts"
import type {Store} from "../../browser/store.ts"
import {draftsKey, readDrafts} from "../../lesson_files/draft_storage.ts"
import type {Lesson} from "../../lesson_files/lesson.ts"
import {isLessonFile, type RefusedLesson, readLessonFile, version} from "../../lesson_files/lesson_file.ts"
import {readProgress, writeProgress} from "../../lesson_files/progress.ts"
import {type Arrangement, afterLesson, duringLesson} from "../../state/arrangement.ts"
import {
  firstOpenStep,
  type LessonEvent,
  type LessonsState,
  noLessons,
  programAt,
} from "../../state/lesson_state.ts"
import type {Notice, PageState} from "../../state/page_state.ts"
import {tryToStore} from "../../storage/browser_storage.ts"
import type {AppController} from "../../ui/app_context.ts"
import {aboutRobot, usualRobot} from "../../worlds/world.ts"
import type {PageParts} from "../document/page_parts.ts"
import type {Origin, ProgramLoader} from "../programs/program_loader.ts"

type LessonCommands = Pick<
  AppController,
  "openLessons" | "openChallenges" | "openLesson" | "lessonLink" | "goToStep" | "restartStep" | "leaveLesson"
>

const progressKey = "rosy.lessons"
/// The lesson that this tab had open, over a reload: its name, and its text if it came from a file or a link.
const openKey = "rosy.lesson"
const openFileKey = "rosy.lesson.file"

export function lessonCommands(store: Store, loader: ProgramLoader): LessonCommands {
  const dispatch = (event: LessonEvent) => store.dispatch({kind: "lesson", event})
  const request = (of: "list" | "challenges", fetchList: typeof fetchLessons) => {
    if (store.now.lessons[of].kind === "there") return
    dispatch({kind: "listed", of, list: {kind: "asked"}})
    void fetchList(document.documentElement.lang).then(answer =>
      dispatch({
        kind: "listed",
        of,
        list: answer.kind === "there" ? {kind: "there", lessons: answer.value} : {kind: "failed"},
      }),
    )
  }
  return {
    openLessons() {
      store.dispatch({kind: "dialog", dialog: "lessons"})
      request("list", fetchLessons)
    },
    openChallenges() {
      store.dispatch({kind: "dialog", dialog: "challenges"})
      request("challenges", fetchChallenges)
    },
    openLesson(name) {
      const isCurrent = loader.requests.choose()
      void fetchLesson(name, document.documentElement.lang).then(answer => {
        if (!isCurrent()) return
        if (answer.kind === "failed")
          return store.dispatch({kind: "notice", notice: {kind: "lesson-missing", name}})
        show(store, loader, answer.value)
      })
    },
    lessonLink: async file => `${window.location.origin}/${await fragmentOf(file, "lesson")}`,
    goToStep(to) {
      const {open} = store.now.lessons
      const step = open?.lesson.steps[to]
      if (open === null || step === undefined || to === open.at) return
      dispatch({kind: "stepped", to, runs: store.now.runs})
      if (step.program !== null) openProgram(loader, open.lesson, to)
      // Opening a program chooses the room again; the service receives the step to check afterwards.
      if (step.program !== null) dispatch({kind: "stepped", to, runs: store.now.runs})
    },
    restartStep() {
      const {open} = store.now.lessons
      if (open === null) return
      openProgram(loader, open.lesson, open.at)
      dispatch({kind: "stepped", to: open.at, runs: store.now.runs})
    },
    leaveLesson() {
      dispatch({kind: "closed"})
      arrange(store, afterLesson(store.now.arrangement))
    },
  }
}

/// Only when something changes: the arrangement is stored.
function arrange(store: Store, arrangement: Arrangement): void {
  if (arrangement !== store.now.arrangement) store.dispatch({kind: "arranged", arrangement})
}

function show(store: Store, loader: ProgramLoader, lesson: Lesson, origin: Origin = {}): void {
  arrange(store, duringLesson(store.now.arrangement, window.innerWidth))
  showLesson(store, loader, lesson, firstOpenStep(lesson, store.now.lessons.progress), true, origin)
}

/// Opens a lesson from a file or a link; false, with a notice that calls it by `name`, for one that cannot be read.
export function openLessonText(
  store: Store,
  loader: ProgramLoader,
  name: string,
  text: string,
  origin: Origin = {},
): boolean {
  const read = readLessonFile(text, document.documentElement.lang)
  if (read.kind === "lesson") show(store, loader, read.lesson, origin)
  else refuseLesson(store, name, read)
  return read.kind === "lesson"
}

/// Says why a text is not opened as a lesson; `name` is what the notice calls it.
export function refuseLesson(store: Pick<Store, "dispatch">, name: string, why: RefusedLesson): void {
  const notice: Notice =
    why.kind === "newer"
      ? {kind: "newer-lesson", name, version: why.version, newest: version}
      : {kind: "damaged-lesson", name, at: why.at}
  store.dispatch({kind: "notice", notice})
}

/// The loader, which opens a file with a lesson as a lesson.
export function withLessonFiles(store: Store, loader: ProgramLoader): ProgramLoader {
  return {
    ...loader,
    openFile(name, file) {
      if (file.kind === "text" && isLessonFile(file.text)) openLessonText(store, loader, name, file.text)
      else loader.openFile(name, file)
    },
  }
}

function openProgram(loader: ProgramLoader, lesson: Lesson, at: number, origin: Origin = {}): void {
  const project = {...newProject(lesson.title), haskell: programAt(lesson, at), world: lesson.room}
  loader.openText(lesson.title, saveProject(project), {...origin, inLesson: true})
}

/// Keeps the progress, and opens the lesson again that was open before a reload.
export function storeLessons(store: Store, storage: {readonly shared: Storage; readonly tab: Storage}): void {
  let kept = store.now.lessons
  store.onFrame(({lessons}) => {
    if (lessons.progress !== kept.progress) {
      // Another tab may have finished a lesson meanwhile. What has lost lessons is the progress of another learner.
      const hasLost = Object.keys(kept.progress).some(name => lessons.progress[name] === undefined)
      const others = hasLost ? {} : readProgress(storage.shared.getItem(progressKey))
      const progress = writeProgress({...others, ...lessons.progress})
      if (!tryToStore(storage.shared, progressKey, progress))
        store.dispatch({kind: "notice", notice: {kind: "progress-not-saved"}})
    }
    const [open, before] = [lessonOf(lessons), lessonOf(kept)]
    if (open?.name !== before?.name) {
      for (const [key, text] of [
        [openKey, open?.name],
        [openFileKey, open?.file],
      ] as const)
        if (text == null) storage.tab.removeItem(key)
        else tryToStore(storage.tab, key, text)
    }
    kept = lessons
  })
}

/// The open lesson, unless it is the trial of a draft.
const lessonOf = ({open, writing}: LessonsState): Lesson | undefined =>
  writing === null ? open?.lesson : undefined

/// Opens the lesson again that this tab had open. Its program is opened as well, unless the learner's own version of it is open.
export function resumeLesson(store: Store, loader: ProgramLoader, storage: {readonly tab: Storage}): void {
  const name = storage.tab.getItem(openKey)
  if (name === null || store.now.lessons.open !== null) return
  void storedLesson(name, storage.tab.getItem(openFileKey)).then(lesson => {
    if (lesson === null || !loader.requests.isFirstWanted() || store.now.lessons.open !== null) return
    const at = firstOpenStep(lesson, store.now.lessons.progress)
    const {worldName} = store.now
    const isItsRoom = typeof worldName === "object" && worldName?.name === lesson.room.name
    showLesson(store, loader, lesson, at, !isItsRoom, {isFirst: true})
  })
}

/// Shows a lesson at a step, with the program that the page shows or, with `opensProgram`, the one that the step begins with.
export function showLesson(
  store: Store,
  loader: ProgramLoader,
  lesson: Lesson,
  at: number,
  opensProgram: boolean,
  origin: Origin = {},
): void {
  if (opensProgram) openProgram(loader, lesson, at, origin)
  store.dispatch({kind: "lesson", event: {kind: "opened", lesson, at, runs: store.now.runs}})
}

/// `null` when it can be had no more.
async function storedLesson(name: string, file: string | null): Promise<Lesson | null> {
  const language = document.documentElement.lang
  if (file !== null) {
    const read = readLessonFile(file, language)
    return read.kind === "lesson" ? read.lesson : null
  }
  const answer = await fetchLesson(name, language)
  return answer.kind === "failed" ? null : answer.value
}

export function storedLessons(storage: {readonly shared: Storage}): Pick<PageState, "lessons"> {
  const progress = readProgress(storage.shared.getItem(progressKey))
  return {lessons: {...noLessons, progress, drafts: readDrafts(storage.shared.getItem(draftsKey))}}
}

/// The toolbox shows what the open lesson allows and the simulated robot has.
export function restrictToolbox(store: Store, parts: PageParts): void {
  let shown: readonly string[] | null = null
  let shownRobot = usualRobot
  store.onFrame(({lessons, room, robots}) => {
    const wanted = lessons.open?.lesson.toolbox ?? null
    const robot = robots.held === null && room.world !== null ? room.world.robot : usualRobot
    if ((wanted === shown && robot === shownRobot) || parts.blocks === null) return
    shown = wanted
    shownRobot = robot
    parts.blocks.restrict(wanted, aboutRobot(robot).lacks)
  })
}
