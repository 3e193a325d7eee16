/// Rehearsal of a draft: its solution and its typical wrong attempts, run and judged by the service (protocol §9.1), and what is to be said about them. Pure.

import {type DraftStep, isQuestion, type LessonDraft} from "../lesson_files/draft.ts"
import {watchedStep} from "../lesson_files/draft_file.ts"
import {mapped, readerOf} from "../wire/decode.ts"
import type {Queued} from "../wire/page/jobs.generated.ts"
import {type AttemptJudged, rehearsalAnswer} from "../wire/page/lesson_rehearsals.generated.ts"
import type {Seen} from "../wire/verdict.generated.ts"
import {batchFailure, batchProblem} from "./batch_answer.ts"

/// A program that is tried. Steps, checks and wrong attempts are counted from 1.
export type Attempt =
  | {readonly kind: "solution"; readonly step: number}
  | {readonly kind: "wrong"; readonly step: number; readonly check: number; readonly place: number}

export interface Judged extends Omit<AttemptJudged, "op" | "number" | "problems"> {
  /// Why the program could not be run to its end, in the language of the page.
  readonly problems: readonly string[]
}

export type RehearsalAnswer =
  | Queued
  | {readonly op: "failed"; readonly message: string}
  | ({readonly op: "attempt"; readonly number: number} & Judged)

export interface Rehearsal {
  /// The request as text: another one is needed when it changes.
  readonly request: string
  readonly attempts: readonly Attempt[]
  /// Ids of the checks of each step, in their order.
  readonly checks: readonly (readonly string[])[]
  /// In the order of the attempts; fewer while it goes on.
  readonly judged: readonly Judged[]
  /// Why there will be no more; `lost`: the connection was.
  readonly failure: {readonly kind: "said"; readonly message: string} | {readonly kind: "lost"} | null
}

/// Something that the teacher should know before others get the lesson.
export type RehearsalFinding =
  /// It is not known whether the lesson can be solved.
  | {readonly kind: "no-solution"}
  | {
      readonly kind: "solution-misses"
      readonly step: number
      readonly check: number
      readonly seen: Seen | null
    }
  | {readonly kind: "solution-broken"; readonly step: number; readonly problem: string}
  | {readonly kind: "wrong-passes"; readonly step: number; readonly check: number; readonly place: number}
  | {
      readonly kind: "wrong-broken"
      readonly step: number
      readonly check: number
      readonly place: number
      readonly problem: string
    }

interface Tried {
  readonly attempt: Attempt
  readonly step: DraftStep
  readonly source: string
}

/// The solution at the last step that is run, and each wrong attempt at its step.
function triedPrograms({steps, solution}: LessonDraft): readonly Tried[] {
  const last = steps.findLast(step => !isQuestion(step.kind) && step.checks.length > 0)
  const solved: readonly Tried[] =
    solution === null || last === undefined
      ? []
      : [{attempt: {kind: "solution", step: steps.indexOf(last) + 1}, step: last, source: solution}]
  const wrong = steps.flatMap((step, i) =>
    isQuestion(step.kind)
      ? []
      : step.checks.flatMap((check, j) =>
          check.wrong.map(
            (source, k): Tried => ({
              attempt: {kind: "wrong", step: i + 1, check: j + 1, place: k + 1},
              step,
              source,
            }),
          ),
        ),
  )
  return [...solved, ...wrong]
}

/// The rehearsal of a draft before its first answer.
export function rehearsalOf(draft: LessonDraft): Rehearsal {
  const tried = triedPrograms(draft)
  const attempts = tried.map(({step, source}) => ({source, step: watchedStep(step), hands: step.hands}))
  return {
    request: JSON.stringify({op: "rehearse", world: draft.room, attempts}),
    attempts: tried.map(({attempt}) => attempt),
    checks: draft.steps.map(step => step.checks.map(check => check.id)),
    judged: [],
    failure: null,
  }
}

/// Whether it is about the draft as it is now.
export const isAbout = (rehearsal: Rehearsal, draft: LessonDraft): boolean =>
  rehearsal.request === rehearsalOf(draft).request

export const isOver = ({attempts, judged, failure}: Rehearsal): boolean =>
  failure !== null || judged.length >= attempts.length

export function heard(rehearsal: Rehearsal, answer: RehearsalAnswer): Rehearsal {
  switch (answer.op) {
    case "queued":
      return rehearsal
    case "attempt":
      return {...rehearsal, judged: [...rehearsal.judged, answer]}
    case "failed":
      return {...rehearsal, failure: {kind: "said", message: answer.message}}
  }
}

/// What is not as it should be, in the order of the attempts.
export function findingsOf(rehearsal: Rehearsal): readonly RehearsalFinding[] {
  const {attempts, judged} = rehearsal
  const hasSolution = attempts.some(attempt => attempt.kind === "solution")
  return [
    ...(hasSolution ? [] : [{kind: "no-solution"} as const]),
    ...judged.flatMap((did, i) => {
      const attempt = attempts[i]
      return attempt === undefined
        ? []
        : findingsAbout(attempt, did, rehearsal.checks[attempt.step - 1] ?? [])
    }),
  ]
}

function findingsAbout(
  attempt: Attempt,
  {ended, passed, checks, problems}: Judged,
  ids: readonly string[],
): readonly RehearsalFinding[] {
  const {step} = attempt
  const isBroken = ended !== "time" && ended !== "done"
  const text = problems[0] ?? ""
  if (attempt.kind === "solution") {
    if (isBroken) return [{kind: "solution-broken", step, problem: text}]
    if (passed) return []
    return checks
      .filter(({state}) => state !== "done")
      .map(({id, seen}) => ({kind: "solution-misses", step, check: ids.indexOf(id) + 1, seen}) as const)
  }
  const {check, place} = attempt
  if (isBroken) return [{kind: "wrong-broken", step, check, place, problem: text}]
  const isMissed = checks.some(({id, state}) => id === ids[check - 1] && state !== "done")
  return isMissed ? [] : [{kind: "wrong-passes", step, check, place}]
}

/// A message of the service.
export const readAnswer = readerOf(
  mapped(rehearsalAnswer, (answer): RehearsalAnswer => {
    if (answer.op === "failed") return {op: "failed", message: batchFailure(answer)}
    return answer.op === "attempt" ? {...answer, problems: answer.problems.map(batchProblem)} : answer
  }),
)
