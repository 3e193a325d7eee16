/// Hints for the open step, computed from the learner's program and its last run: which check they are about, which of the lesson's hints still
/// tell something, which type no function has yet, and which function nothing uses. Pure; the panel words and shows them.

import type {Check} from "../../lesson_files/lesson.ts"
import type {LessonChecks} from "../../state/messages/messages.ts"
import {decode, list, object, optional, string} from "../../wire/decode.ts"
import type {Declaration} from "../../wire/worker.generated.ts"

export type Hint =
  | {readonly kind: "text" | "piece"; readonly text: string}
  /// A function is defined, and nothing uses it.
  | {readonly kind: "not-run"; readonly name: string}
  /// The check is about a type that the program does not have: to be taken, or to be given.
  | {readonly kind: "not-taken" | "not-given"; readonly type: string}

export interface StepHints {
  /// The id of the check that they are about.
  readonly check: string
  readonly hints: readonly Hint[]
}

/// What hints need to know of the program: its text, and its own names with the types that the compiler found.
export interface HintedProgram {
  readonly text: string
  readonly declared: readonly Declaration[]
}

/// What the service checks, as far as hints need it: patterns of an event and a command, and types of a function.
export interface HintedCheck {
  readonly id: string
  readonly event: string | null
  readonly command: string | null
  readonly takes: readonly string[]
  readonly gives: readonly string[]
}

const hintedCheck = object<HintedCheck>(get => ({
  id: get("id", string),
  event: get("event", optional(string, null)),
  command: get("command", optional(string, null)),
  takes: get("takes", optional(list(string), [])),
  gives: get("gives", optional(list(string), [])),
}))

/// Those of a step's checks that can be read; the others have no hint of this kind.
export const hintedChecks = (watched: readonly unknown[]): readonly HintedCheck[] =>
  watched.flatMap(value => {
    const read = decode(hintedCheck, value)
    return read.kind === "ok" ? [read.value] : []
  })

/// The hints of the first check that the last run has missed, or else of the first that is not done; `null` when no check has any.
export function hintsOf(
  checks: readonly Check[],
  told: LessonChecks | null,
  program: HintedProgram,
  watched: readonly HintedCheck[] = [],
): StepHints | null {
  const stateOf = (check: Check) => told?.checks.find(one => one.id === check.id)?.state ?? "open"
  const hasRun = told !== null && told.run !== null
  const open = checks.filter(check => stateOf(check) !== "done")
  const missed = hasRun ? open.filter(check => stateOf(check) === "missed") : []
  for (const check of [...missed, ...open]) {
    const unused = hasRun ? unusedFunctions(program) : []
    const [question, ...others] = lessonHints(check).filter(
      hint => hint.kind !== "piece" || !isInProgram(hint.text, program.text),
    )
    const found = watched.find(one => one.id === check.id)
    const types = found === undefined ? [] : absentTypes(found, program)
    const hints = [
      ...unused.map((name): Hint => ({kind: "not-run", name})),
      // A question leaves more to think about than a type.
      ...(question === undefined ? [] : [question]),
      ...types,
      ...others,
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

/// The first type that the check needs and the program lacks; none while the program has each of them somewhere.
function absentTypes({event, command, takes, gives}: HintedCheck, program: HintedProgram): readonly Hint[] {
  const typeOf = (pattern: string | null) => (pattern === null ? [] : [pattern.split(" ")[0] ?? ""])
  const isAbsent = (type: string) => {
    const word = new RegExp(`(?<![\\w'.])${escaped(type)}(?![\\w'])`)
    return !word.test(withoutComments(program.text)) && !program.declared.some(one => word.test(one.type))
  }
  const taken = [...typeOf(event), ...takes].find(isAbsent)
  if (taken !== undefined) return [{kind: "not-taken", type: taken}]
  // A task sends commands whose types stand nowhere: `drive` a velocity.
  if (/\b(do|Task)\b|>>/.test(program.text)) return []
  const given = [...typeOf(command), ...gives].find(isAbsent)
  return given === undefined ? [] : [{kind: "not-given", type: given}]
}

const withoutComments = (text: string): string => text.replace(/\{-[\s\S]*?-\}|--.*$/gm, "")

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
