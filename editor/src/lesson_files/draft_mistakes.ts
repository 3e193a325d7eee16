/// What a draft still lacks before it is a lesson. Pure; `words.lessonEditor.mistakes` has the sentences.

import {readWorld} from "../worlds/world_decoder.ts"
import {specsOf} from "./check_arguments.ts"
import {
  cleaned,
  type DraftCheck,
  type DraftStep,
  isQuestion,
  type LessonDraft,
  type Translations,
} from "./draft.ts"
import {languagesOf} from "./draft_file.ts"

/// Steps, answers and checks are counted from 1.
export type DraftMistake =
  | {readonly kind: "no-title"; readonly language: string}
  | {readonly kind: "no-steps"}
  | {readonly kind: "no-step-text"; readonly step: number; readonly language: string}
  | {readonly kind: "few-answers" | "no-right" | "no-checks"; readonly step: number}
  | {
      readonly kind: "no-answer-text"
      readonly step: number
      readonly answer: number
      readonly language: string
    }
  | {readonly kind: "no-check-text"; readonly step: number; readonly check: number; readonly language: string}
  /// The check is about a place, and the room has too few goals with a place.
  | {readonly kind: "no-place"; readonly step: number; readonly check: number}
  /// The check says nothing: no text to be said, no type.
  | {readonly kind: "empty-check"; readonly step: number; readonly check: number}

/// All mistakes, in the order of the lesson.
export function mistakesOf(draft: LessonDraft): readonly DraftMistake[] {
  const started = languagesOf(draft)
  const languages = started.length === 0 ? [draft.language] : started
  const lacking = (texts: Translations) => languages.filter(language => (texts[language] ?? "") === "")
  const places = placeCount(draft)
  return [
    ...lacking(draft.title).map(language => ({kind: "no-title", language}) as const),
    ...(draft.steps.length === 0 ? [{kind: "no-steps"} as const] : []),
    ...draft.steps.flatMap((step, i) => stepMistakes(step, i + 1, places, lacking)),
  ]
}

/// The goals of the draft's room that have a place.
function placeCount({room}: LessonDraft): number {
  const read = readWorld(room)
  if (read.kind === "fault") return 0
  return read.world.goals.filter(goal => goal.kind === "reach" || goal.kind === "touch").length
}

function stepMistakes(
  step: DraftStep,
  n: number,
  places: number,
  lacking: (texts: Translations) => readonly string[],
): readonly DraftMistake[] {
  const said = lacking(step.say).map(language => ({kind: "no-step-text", step: n, language}) as const)
  if (isQuestion(step.kind)) {
    const isRight = step.answers.some(answer => answer.id === step.right)
    return [
      ...said,
      ...(step.answers.length < 2 ? [{kind: "few-answers", step: n} as const] : []),
      ...step.answers.flatMap(({text}, i) =>
        lacking(text).map(language => ({kind: "no-answer-text", step: n, answer: i + 1, language}) as const),
      ),
      ...(isRight ? [] : [{kind: "no-right", step: n} as const]),
    ]
  }
  return [
    ...said,
    ...(step.kind !== "run" && step.checks.length === 0 ? [{kind: "no-checks", step: n} as const] : []),
    ...step.checks.flatMap((check, i) => [
      ...lacking(check.text).map(
        language => ({kind: "no-check-text", step: n, check: i + 1, language}) as const,
      ),
      ...argumentMistakes(check, places).map(kind => ({kind, step: n, check: i + 1})),
    ]),
  ]
}

function argumentMistakes(check: DraftCheck, places: number): readonly ("no-place" | "empty-check")[] {
  const lists = specsOf(check.kind).filter(([, {form}]) => form.kind === "lines" || form.kind === "types")
  const isEmpty =
    lists.length > 0 && lists.every(([name]) => cleaned(check.arguments[name] ?? []).toString() === "")
  const goal = check.arguments["goal"]
  return [
    ...(typeof goal === "number" && goal >= places ? (["no-place"] as const) : []),
    ...(isEmpty ? (["empty-check"] as const) : []),
  ]
}
