/// Hints for the open step, computed from the learner's program and its last run: which check they are about, and which of the lesson's hints
/// still tell something. Pure; the panel words and shows them.

import type {Declared} from "../state/messages.ts"
import type {Check, LessonChecks} from "./lesson.ts"

export type Hint =
  | {readonly kind: "text" | "piece"; readonly text: string}
  /// A function is defined, and nothing uses it.
  | {readonly kind: "not-run"; readonly name: string}

export interface StepHints {
  /// The id of the check that they are about.
  readonly check: string
  readonly hints: readonly Hint[]
}

/// What hints need to know of the program: its text, and its own names with the types that the compiler found.
export interface HintedProgram {
  readonly text: string
  readonly declared: readonly Declared[]
}

/// The hints of the first check that the last run has missed, or else of the first that is not done; `null` when no check has any.
export function hintsOf(
  checks: readonly Check[],
  told: LessonChecks | null,
  program: HintedProgram,
): StepHints | null {
  const stateOf = (check: Check) => told?.checks.find(one => one.id === check.id)?.state ?? "open"
  const hasRun = told !== null && told.run !== null
  const open = checks.filter(check => stateOf(check) !== "done")
  const missed = hasRun ? open.filter(check => stateOf(check) === "missed") : []
  for (const check of [...missed, ...open]) {
    const unused = hasRun ? unusedFunctions(program) : []
    const hints = [
      ...unused.map((name): Hint => ({kind: "not-run", name})),
      ...lessonHints(check).filter(hint => hint.kind !== "piece" || !isInProgram(hint.text, program.text)),
    ]
    if (hints.length > 0) return {check: check.id, hints}
  }
  return null
}

/// A question, a pointer, a piece to take; a lesson may leave out the first sizes.
function lessonHints({hints}: Check): readonly (Hint & {readonly text: string})[] {
  return hints
    .map((text, i) => ({kind: i === 2 ? ("piece" as const) : ("text" as const), text}))
    .filter(hint => hint.text !== "")
}

/// Whether every line of a piece stands in the program already, apart from spaces.
export function isInProgram(piece: string, program: string): boolean {
  const bare = (text: string) => text.replace(/\s+/g, "")
  const lines = program.split("\n").map(bare)
  return piece
    .split("\n")
    .map(bare)
    .filter(line => line !== "")
    .every(wanted => lines.some(line => line.includes(wanted)))
}

/// The functions of the program that no other definition mentions, `main` apart.
export function unusedFunctions({text, declared}: HintedProgram): readonly string[] {
  const definitions = text.split(/\n(?=\S)/)
  return declared
    .filter(({name, type}) => name !== "main" && /->|\bTask\b/.test(type))
    .map(({name}) => name)
    .filter(name => {
      const own = new RegExp(`^${escaped(name)}(?![\\w'])`)
      const mention = new RegExp(`(?<![\\w'])${escaped(name)}(?![\\w'])`)
      return !definitions.some(one => !own.test(one) && !one.startsWith("--") && mention.test(one))
    })
}

const escaped = (name: string): string => name.replace(/[.*+?^${}()|[\]\\]/g, "\\$&")
