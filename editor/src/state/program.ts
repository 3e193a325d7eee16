/// The program as the page knows it: its text, where each block's text is, and which block a problem is about.

import type {Word} from "@rosy/codegen/reader"
import type {Fix} from "./fixes.ts"
import type {Place, Problem} from "./messages.ts"

export type BlockId = string

/// A piece of the text and the block it was printed from. Offsets in UTF-16 units; `end` is exclusive.
export interface Span {
  readonly start: number
  readonly end: number
  readonly block: BlockId
}

/// A top-level function: its name, its definition block, and its text.
export interface Definition extends Span {
  readonly name: string
}

/// What a thing is, told by colour: the same families as the blocks'.
export type Family = "event" | "state" | "command" | "memory" | "task" | "number" | "choice" | "own"

export interface Program {
  readonly text: string
  readonly spans: readonly Span[]
  readonly definitions: readonly Definition[]
  /// The family of each block whose type is known.
  readonly families: {readonly [block: BlockId]: Family}
  /// What the names in each top-level piece of the text are there for, by the syntax tree: counted from where the piece starts.
  readonly words: readonly {readonly start: number; readonly words: readonly Word[]}[]
}

export const emptyProgram: Program = {text: "", spans: [], definitions: [], families: {}, words: []}

/// A problem on the page: what it says, and the block and text it is about when it has any.
export interface Finding {
  readonly severity: "error" | "warning"
  readonly kind: string
  /// Who found it: the blocks while they were put together, the compiler, the running program.
  readonly from: "blocks" | "compiler" | "run"
  readonly message: string
  readonly hint: string
  readonly ghc: string
  /// The top-level function it is about.
  readonly function: string | null
  /// Seconds since the program started, for problems of a run.
  readonly time: number | null
  readonly inputs: readonly string[]
  readonly fixes: readonly Fix[]
  readonly block: BlockId | null
  /// Where in the program's text.
  readonly range: {readonly start: number; readonly end: number} | null
}

/// The offset of a 1-based line and column; past the end of a line or of the text it is that end.
/// protocol §1 counts characters, JavaScript counts UTF-16 units: the two differ after an emoji.
export function offsetOf(text: string, place: Place): number {
  let start = 0
  for (let line = 1; line < place.line; line += 1) {
    const newline = text.indexOf("\n", start)
    if (newline < 0) return text.length
    start = newline + 1
  }
  const newline = text.indexOf("\n", start)
  const line = text.slice(start, newline < 0 ? text.length : newline)
  const before = [...line].slice(0, Math.max(0, place.column - 1)).join("")
  return start + before.length
}

/// The block of the smallest span that covers `start` to `end`.
export function innermostBlock(
  spans: readonly Span[],
  range: {readonly start: number; readonly end: number},
): BlockId | null {
  let best: Span | null = null
  for (const span of spans) {
    if (span.start > range.start || span.end < range.end) continue
    if (best === null || span.end - span.start <= best.end - best.start) best = span
  }
  return best?.block ?? null
}

/// The whole text that a block was printed to: its widest span.
export function textOf(spans: readonly Span[], block: BlockId): {start: number; end: number} | null {
  let best: Span | null = null
  for (const span of spans)
    if (span.block === block && (best === null || span.end - span.start > best.end - best.start)) best = span
  return best === null ? null : {start: best.start, end: best.end}
}

/// Brings a problem of the service home: to the innermost block at its place, or else to the definition of the
/// function it names.
export function locate(program: Program, problem: Problem, from: "compiler" | "run"): Finding {
  const named = program.definitions.find(d => d.name === problem.function) ?? null
  const start = problem.start === null ? null : offsetOf(program.text, problem.start)
  const end = problem.end === null ? start : offsetOf(program.text, problem.end)
  const range = start === null || end === null ? null : {start, end: Math.max(start, end)}
  const block = range === null ? null : innermostBlock(program.spans, range)
  return {
    severity: problem.severity,
    kind: problem.kind,
    from,
    message: problem.message,
    hint: problem.hint,
    ghc: problem.ghc,
    function: problem.function,
    time: problem.time,
    inputs: problem.inputs,
    fixes: problem.fixes.map(({title, edits}) => ({
      title,
      edits: edits.map(e => ({
        start: offsetOf(program.text, e.start),
        end: offsetOf(program.text, e.end),
        text: e.text,
      })),
    })),
    block: block ?? named?.block ?? null,
    range: range ?? (named === null ? null : {start: named.start, end: named.end}),
  }
}

/// Where a range is after `old` became `now`: it moves with the text around it, and shrinks with what it lost.
export function movedRange(
  old: string,
  now: string,
  range: {readonly start: number; readonly end: number},
): {start: number; end: number} {
  return rangeMoved(mover(old, now), range)
}

/// The same for many ranges: comparing the texts is what costs.
export function rangeMoved(
  move: Mover,
  range: {readonly start: number; readonly end: number},
): {start: number; end: number} {
  const start = move(range.start, "before")
  return {start, end: Math.max(start, move(range.end, "before"))}
}

/// Where an offset is in a text that has changed; one at which something was put in is `before` or `behind` it.
export type Mover = (at: number, side: "before" | "behind") => number

/// Where offsets are after `old` became `now`.
export function mover(old: string, now: string): Mover {
  const most = Math.min(old.length, now.length)
  let head = 0
  while (head < most && old[head] === now[head]) head += 1
  let tail = 0
  while (tail < most - head && old[old.length - 1 - tail] === now[now.length - 1 - tail]) tail += 1
  const shift = now.length - old.length
  return (at, side) => {
    if (at < head || (at === head && side === "before")) return at
    return at >= old.length - tail ? at + shift : Math.min(at, now.length - tail)
  }
}
