/// The way out of a command conflict: what `simulate` runs, with a priority for the function that is overridden.
///
/// Input: the workspace and the names of the two functions. Output: the change of the text; `undefined` where both do not stand beside each other.

import type {ConflictNames} from "../../api.ts"
import type {SavedWorkspace} from "../../serialized_blocks.ts"
import {words} from "../../words/index.ts"
import {commandConflicts, conflictBetween, problemsOfConflict} from "./command_conflicts.ts"
import {inferWorkspace} from "./workspace_inference.ts"

/// Replaces a part of a program's text. Offsets count UTF-16 units.
export interface ConflictFix {
  readonly title: string
  readonly start: number
  readonly end: number
  readonly text: string
}

/// What a run has shown, as warnings for the blocks; none when the functions are not in conflict.
export function conflictShown(workspace: SavedWorkspace, names: ConflictNames) {
  const conflict = conflictBetween(inferWorkspace(workspace), names)
  return conflict === undefined ? [] : problemsOfConflict(conflict)
}

/// The way out of a conflict, if there still is one. `main` is the place of its definition in the text.
export function conflictFix(
  workspace: SavedWorkspace,
  names: ConflictNames,
  text: string,
  main: {readonly start: number; readonly end: number},
): ConflictFix | undefined {
  const inferred = inferWorkspace(workspace)
  const isFound = commandConflicts(inferred).some(
    c => c.command === names.command && c.winner.name === names.winner && c.loser.name === names.loser,
  )
  if (!isFound && conflictBetween(inferred, names) === undefined) return undefined
  // All that follows `simulate` is its argument: no other program has conflicts.
  const definition = text.slice(main.start, main.end)
  const argument = /\bsimulate\b\s*(?:\$\s*)?(?=[^\s$])(?![\s\S]*\bsimulate\b)/.exec(definition)
  if (argument === null) return undefined
  const start = main.start + argument.index + argument[0].length
  const end = main.start + definition.trimEnd().length
  const rewritten = withPriority(text.slice(start, end), names.loser, names.winner)
  return rewritten === undefined
    ? undefined
    : {title: words.conflicts.goesFirst(names.loser), start, end, text: rewritten}
}

/// The first goes before the second for a second after its last command: long enough to see, short enough to go on.
function withPriority(argument: string, first: string, second: string): string | undefined {
  const parts = tupleParts(argument)
  const [one, other] = [first, second].map(name => parts.findIndex(part => occurrence(name).test(part)))
  if (one === undefined || other === undefined || one < 0 || other < 0) return undefined
  if (one === other) {
    const inner = parts.length > 1 ? withPriority(parts[one] ?? "", first, second) : undefined
    return inner === undefined ? undefined : tuple(parts.with(one, inner))
  }
  const both = `priority 1 ${asArgument(parts[one])} ${asArgument(parts[other])}`
  return tuple(parts.with(other, both).filter((_, i) => i !== one))
}

const tuple = (parts: readonly string[]) => `(${parts.join(", ")})`

/// A name of the program in a text, not as a part of another name.
const occurrence = (name: string) => new RegExp(`(?<![\\w'.])${name}(?![\\w'])`)

function asArgument(text = ""): string {
  return /^[\w.']+$/.test(text) || tupleParts(text).length > 1 ? text : `(${text})`
}

/// The parts of a tuple's text; a text that is no tuple is one part.
function tupleParts(text: string): string[] {
  const whole = text.trim()
  if (!/^\(.*\)$/s.test(whole)) return [whole]
  const parts = [""]
  let depth = 0
  for (const [i, c] of [...whole].entries()) {
    if (c === ")" || c === "]" || c === "}") depth--
    if (depth === 0 && i > 0 && i < whole.length - 1) return [whole]
    if (depth === 1 && c === ",") parts.push("")
    else if (depth > 0) parts.push(`${parts.pop()}${c}`)
    if (c === "(" || c === "[" || c === "{") depth++
  }
  return parts.map(part => part.trim())
}
