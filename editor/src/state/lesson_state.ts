/// The open lesson as a value, and the events that change it. Pure: the messages to send are part of the result.

import {type DraftEdit, editDraft, type LessonDraft} from "../lesson_files/draft.ts"
import {withDraft} from "../lesson_files/draft_storage.ts"
import type {Lesson, LessonEntry, Step} from "../lesson_files/lesson.ts"
import type {Progress} from "../lesson_files/progress.ts"
import {earnedStars, hasStars, starIds} from "../lesson_files/stars.ts"
import type {LessonChecks} from "./messages/messages.ts"

export interface OpenLesson {
  readonly lesson: Lesson
  /// The step that is shown.
  readonly at: number
  /// The answer chosen in each question, by the id of its step.
  readonly answers: {readonly [step: string]: string}
  /// The check that hints were asked for last, and how many of its hints are shown; `null` until then.
  readonly hints: {readonly check: string; readonly count: number} | null
  /// What the service says about the shown step; `null` until it has said something.
  readonly checks: LessonChecks | null
  /// The number of the last run that is judged: an earlier run says nothing about this step.
  readonly since: number
}

export type LessonList =
  | {readonly kind: "unasked"}
  | {readonly kind: "asked"}
  | {readonly kind: "there"; readonly lessons: readonly LessonEntry[]}
  | {readonly kind: "failed"}

/// All about lessons that the page knows.
export interface LessonsState {
  readonly list: LessonList
  readonly challenges: LessonList
  readonly progress: Progress
  readonly open: OpenLesson | null
  /// The lessons that are being written in this browser.
  readonly drafts: readonly LessonDraft[]
  readonly writing: Writing | null
}

/// The draft that is shown, by its name: in the lesson editor, or as the open lesson, as a pupil sees it.
export interface Writing {
  readonly name: string
  readonly mode: "editing" | "trying"
}

export const noLessons: LessonsState = {
  list: {kind: "unasked"},
  challenges: {kind: "unasked"},
  progress: {},
  open: null,
  drafts: [],
  writing: null,
}

export type LessonEvent =
  | {readonly kind: "listed"; readonly of: "list" | "challenges"; readonly list: LessonList}
  /// `runs` is the number of the newest run.
  | {readonly kind: "opened"; readonly lesson: Lesson; readonly at: number; readonly runs: number}
  | {readonly kind: "closed"}
  /// The learner's progress is another one: that of a pupil whom the class has let in.
  | {readonly kind: "progress-replaced"; readonly progress: Progress}
  | {readonly kind: "answered"; readonly answer: string}
  | {readonly kind: "stepped"; readonly to: number; readonly runs: number}
  /// `check` is the one that the hint is about.
  | {readonly kind: "hint-wanted"; readonly check: string}
  | {readonly kind: "judged"; readonly checks: LessonChecks}
  /// A draft, new or not, is shown in the editor.
  | {readonly kind: "draft-opened"; readonly draft: LessonDraft}
  | {readonly kind: "draft-edited"; readonly edit: DraftEdit}
  | {readonly kind: "draft-closed"}
  | {readonly kind: "draft-removed"; readonly name: string}
  /// The draft of the editor is shown as the lesson that it is, from its beginning. `runs` is the number of the newest run.
  | {readonly kind: "draft-tried"; readonly lesson: Lesson; readonly runs: number}

/// What the service watches from now on; `null` for nothing.
export type Watched = Step["watched"]

export interface LessonTransition {
  readonly state: LessonsState
  /// Present when another step is to be checked by the service.
  readonly watched?: Watched
}

export function currentStep(open: OpenLesson): Step | undefined {
  return open.lesson.steps[open.at]
}

export function isDone(state: LessonsState, step: Step): boolean {
  // A challenge is passed with its first star.
  const [id = step.id] = hasStars(step) ? starIds(1) : []
  return state.open !== null && (state.progress[state.open.lesson.name] ?? []).includes(id)
}

/// The step that a learner goes on with: the first that is not done, or the first of all when the lesson was finished.
export function firstOpenStep(lesson: Lesson, progress: Progress): number {
  const done = progress[lesson.name] ?? []
  const found = lesson.steps.findIndex(step => !done.includes(step.id))
  return Math.max(0, found)
}

/// The program that a lesson begins with at a step.
export function programAt(lesson: Lesson, at: number): string {
  const own = lesson.steps.slice(0, at + 1).flatMap(step => step.program ?? [])
  return own.at(-1) ?? lesson.start
}

/// What the service is to watch now.
export function watchedNow(state: LessonsState): Watched {
  return (state.open === null ? undefined : currentStep(state.open))?.watched ?? null
}

/// Seed of a run that checks judge, so that the same program gets the same verdict each time; the rehearsals of the lessons have the same
/// one (`sim-service/tests/system/test_lessons.py`). `null` where no check depends on chance.
export function judgedSeed(state: LessonsState): number | null {
  const watched = watchedNow(state)
  return watched === null || watched.checks.length === 0 ? null : 1
}

export function reduceLesson(state: LessonsState, event: LessonEvent): LessonTransition {
  const {open} = state
  switch (event.kind) {
    case "listed":
      return {state: {...state, [event.of]: event.list}}
    case "opened": {
      const {lesson, at, runs} = event
      return shown({...state, open: opened(lesson, at, runs), writing: null})
    }
    case "closed":
      return open === null ? {state} : shown(withoutLesson(state))
    case "progress-replaced":
      return {state: {...state, progress: event.progress}}
    case "answered": {
      const step = open === null ? undefined : currentStep(open)
      if (open === null || step === undefined) return {state}
      const answered = {...state, open: {...open, answers: {...open.answers, [step.id]: event.answer}}}
      // A guess cannot be wrong; the answer to a question can, and may be given again.
      const isOver = step.kind === "predict" || event.answer === step.right
      return {state: isOver ? withDone(answered, step) : answered}
    }
    case "stepped": {
      if (open === null || open.lesson.steps[event.to] === undefined) return {state}
      return shown({...state, open: {...open, at: event.to, hints: null, checks: null, since: event.runs}})
    }
    case "hint-wanted":
      return open === null
        ? {state}
        : {state: {...state, open: {...open, hints: moreHints(open, event.check)}}}
    case "judged":
      return {state: judged(state, event.checks)}
    case "draft-opened": {
      const {draft} = event
      const drafts = withDraft(state.drafts, draft)
      return shown({...state, open: null, drafts, writing: {name: draft.name, mode: "editing"}})
    }
    case "draft-edited": {
      const draft = editedDraft(state)
      return draft === null
        ? {state}
        : {state: {...state, drafts: withDraft(state.drafts, editDraft(draft, event.edit))}}
    }
    case "draft-closed":
      return shown({...withoutLesson(state), writing: null})
    case "draft-removed": {
      const drafts = state.drafts.filter(draft => draft.name !== event.name)
      const isShown = state.writing?.name === event.name
      return isShown ? shown({...state, open: null, drafts, writing: null}) : {state: {...state, drafts}}
    }
    case "draft-tried": {
      const {lesson, runs} = event
      if (state.writing === null) return {state}
      const {[lesson.name]: _, ...progress} = state.progress
      const writing = {...state.writing, mode: "trying"} as const
      return shown({...state, progress, writing, open: opened(lesson, 0, runs)})
    }
  }
}

const opened = (lesson: Lesson, at: number, runs: number): OpenLesson => ({
  lesson,
  at,
  answers: {},
  hints: null,
  checks: null,
  since: runs,
})

/// How many hints about a check are shown.
export function shownHints({hints}: OpenLesson, check: string): number {
  return hints?.check === check ? hints.count : 0
}

/// Another check begins with its first hint: those of the check before were asked for, and these were not.
function moreHints(open: OpenLesson, check: string): OpenLesson["hints"] {
  return {check, count: shownHints(open, check) + 1}
}

/// The state without an open lesson; from the trial of a draft the way leads back to the editor.
export function withoutLesson(state: LessonsState): LessonsState {
  const {open, writing} = state
  const isTrial = open !== null && writing?.mode === "trying"
  return {...state, open: null, writing: isTrial ? {...writing, mode: "editing"} : writing}
}

/// The draft that the editor shows or that is being tried.
export function editedDraft({drafts, writing}: LessonsState): LessonDraft | null {
  return drafts.find(draft => draft.name === writing?.name) ?? null
}

function shown(state: LessonsState): LessonTransition {
  return {state, watched: watchedNow(state)}
}

function judged(state: LessonsState, checks: LessonChecks): LessonsState {
  const {open} = state
  const step = open === null ? undefined : currentStep(open)
  if (open === null || step === undefined || step.watched === null) return state
  if (checks.run !== null && checks.run <= open.since) return state
  const seen = {...state, open: {...open, checks}}
  if (hasStars(step)) return withProgress(seen, starIds(earnedStars(step, checks)))
  return checks.passed ? withDone(seen, step) : seen
}

const withDone = (state: LessonsState, step: Step): LessonsState => withProgress(state, [step.id])

function withProgress(state: LessonsState, ids: readonly string[]): LessonsState {
  if (state.open === null) return state
  const {name} = state.open.lesson
  const done = state.progress[name] ?? []
  const added = ids.filter(id => !done.includes(id))
  return added.length === 0 ? state : {...state, progress: {...state.progress, [name]: [...done, ...added]}}
}
