/// The draft of a lesson as a value, and the edits of it. Pure. `draft_file.ts` turns it into a lesson file and back.

import type {WorldFile} from "../worlds/world.ts"
import type {StepKind} from "./lesson.ts"
import type {CheckKind} from "./lesson_file.ts"

/// A text in each language that it is written in, by the language's tag.
export type Translations = {readonly [language: string]: string}

/// An argument of a check, as it stands in the file.
export type Argument = number | string | readonly string[]

export interface DraftCheck {
  readonly id: string
  readonly kind: CheckKind
  readonly arguments: {readonly [name: string]: Argument}
  readonly text: Translations
  /// A question, a pointer, a piece to take.
  readonly hints: readonly Translations[]
  /// Typical wrong attempts at the step, programs that fail this check.
  readonly wrong: readonly string[]
}

export interface DraftAnswer {
  readonly id: string
  readonly text: Translations
  readonly reply: Translations
}

export interface DraftStep {
  readonly id: string
  readonly kind: StepKind
  readonly say: Translations
  readonly after: Translations
  /// How long a run is watched; kept, without effect, while the step is a question.
  readonly seconds: number
  readonly checks: readonly DraftCheck[]
  readonly answers: readonly DraftAnswer[]
  readonly right: string | null
  /// The program that the step begins with; `null`: the program as it is.
  readonly program: string | null
  /// What hands do to the robot in a rehearsal, as the file has it; the editor has no form for it.
  readonly hands: readonly unknown[]
}

export interface LessonDraft {
  /// Tells the progress of lessons apart; stays when the title changes.
  readonly name: string
  /// The language of the texts in the fields.
  readonly language: string
  readonly title: Translations
  readonly idea: Translations
  readonly learned: Translations
  readonly room: WorldFile
  readonly start: string
  /// A program that passes the last step; `null` until there is one.
  readonly solution: string | null
  /// The words whose blocks the toolbox shows (`toolbox_words.ts`); `null`: all blocks.
  readonly toolbox: readonly string[] | null
  readonly steps: readonly DraftStep[]
}

const hintCount = 3
/// Of the format (`lesson_file.py`).
export const mostSteps = 12
export const mostChecks = 20
export const mostAnswers = 6
export const mostWrong = 20
export const longestWatch = 600
const usualWatch = 10

export const isQuestion = (kind: StepKind): boolean => kind === "predict" || kind === "investigate"

export type DraftEdit =
  | {readonly kind: "language"; readonly language: string}
  | {readonly kind: "said"; readonly field: "title" | "idea" | "learned"; readonly text: string}
  | {readonly kind: "room"; readonly room: WorldFile}
  | {readonly kind: "start"; readonly program: string}
  | {readonly kind: "solution"; readonly program: string | null}
  | {readonly kind: "toolbox"; readonly words: readonly string[] | null}
  | {readonly kind: "step-added"; readonly step: StepKind}
  | {readonly kind: "step-removed"; readonly at: number}
  | {readonly kind: "step-moved"; readonly at: number; readonly by: -1 | 1}
  | {readonly kind: "step-changed"; readonly at: number; readonly step: DraftStep}

export function newDraft(name: string, language: string, room: WorldFile, start: string): LessonDraft {
  return {
    name,
    language,
    title: {},
    idea: {},
    learned: {},
    room,
    start,
    solution: null,
    toolbox: null,
    steps: [],
  }
}

export function editDraft(draft: LessonDraft, edit: DraftEdit): LessonDraft {
  const {steps} = draft
  switch (edit.kind) {
    case "language":
      return {...draft, language: edit.language}
    case "said":
      return {...draft, [edit.field]: withText(draft[edit.field], draft.language, edit.text)}
    case "room":
      return {...draft, room: edit.room}
    case "start":
      return {...draft, start: edit.program}
    case "solution":
      return {...draft, solution: edit.program}
    case "toolbox":
      return {...draft, toolbox: edit.words}
    case "step-added":
      return steps.length >= mostSteps ? draft : {...draft, steps: [...steps, newStep(draft, edit.step)]}
    case "step-removed":
      return {...draft, steps: steps.toSpliced(edit.at, 1)}
    case "step-moved": {
      const step = steps[edit.at]
      const to = edit.at + edit.by
      if (step === undefined || to < 0 || to >= steps.length) return draft
      return {...draft, steps: steps.toSpliced(edit.at, 1).toSpliced(to, 0, step)}
    }
    case "step-changed":
      return steps[edit.at] === undefined ? draft : {...draft, steps: steps.with(edit.at, edit.step)}
  }
}

/// The text with another wording in a language; an empty one is no wording.
export function withText(texts: Translations, language: string, text: string): Translations {
  const {[language]: _, ...others} = texts
  return text.trim() === "" ? others : {...others, [language]: text}
}

function newStep(draft: LessonDraft, kind: StepKind): DraftStep {
  const step: DraftStep = {
    id: freeId("step", idsOf(draft)),
    kind,
    say: {},
    after: {},
    seconds: usualWatch,
    checks: [],
    answers: [],
    right: null,
    program: null,
    hands: [],
  }
  return isQuestion(kind) ? withAnswer(withAnswer(step)) : step
}

/// Steps and checks share their ids.
function idsOf(draft: LessonDraft): ReadonlySet<string> {
  return new Set(draft.steps.flatMap(step => [step.id, ...step.checks.map(check => check.id)]))
}

/// The first of `step-1`, `step-2`, … that is free.
function freeId(stem: string, taken: ReadonlySet<string>): string {
  let n = 1
  while (taken.has(`${stem}-${n}`)) n += 1
  return `${stem}-${n}`
}

export function withAnswer(step: DraftStep): DraftStep {
  if (step.answers.length >= mostAnswers) return step
  const id = freeId("answer", new Set(step.answers.map(answer => answer.id)))
  return {...step, answers: [...step.answers, {id, text: {}, reply: {}}]}
}

export function withoutAnswer(step: DraftStep, id: string): DraftStep {
  const answers = step.answers.filter(answer => answer.id !== id)
  return {...step, answers, right: step.right === id ? null : step.right}
}

export function withCheck(
  draft: LessonDraft,
  step: DraftStep,
  kind: CheckKind,
  initial: DraftCheck["arguments"],
): DraftStep {
  if (step.checks.length >= mostChecks) return step
  const id = freeId("check", idsOf(draft))
  return {...step, checks: [...step.checks, {id, kind, arguments: initial, text: {}, hints: [], wrong: []}]}
}

/// The check with another text for one of its hints.
export function withHint(check: DraftCheck, place: number, language: string, text: string): DraftCheck {
  const hints = Array.from({length: hintCount}, (_, i) => check.hints[i] ?? {})
  return {...check, hints: hints.with(place, withText(hints[place] ?? {}, language, text))}
}

/// How many wrong attempts the checks of a step have.
export const wrongCount = ({checks}: DraftStep): number =>
  checks.reduce((count, check) => count + check.wrong.length, 0)

/// Replaces the item with an id.
export function replaced<T extends {readonly id: string}>(
  items: readonly T[],
  id: string,
  change: (item: T) => T,
): readonly T[] {
  return items.map(item => (item.id === id ? change(item) : item))
}

/// An argument as it stands in the file: without blank lines, and without spaces around the others.
export function cleaned(value: Argument): Argument {
  return typeof value === "object" ? value.map(line => line.trim()).filter(line => line !== "") : value
}

/// The title in the language in which the lesson is written, or else in the first that there is; empty for none.
export const writtenTitle = ({title, language}: LessonDraft): string =>
  title[language] || (Object.values(title).find(text => text !== "") ?? "")
