/// The program as the page stores it: its text, the text range of each block, problems with their block, and fixes as text edits. Pure.

import {type BlockProblem, type ConflictNames, socketKey} from "@rosy/codegen"
import type {Word} from "@rosy/codegen/reader"
import type {Place, Problem} from "../wire/problem.generated.ts"
import type {Declaration} from "../wire/worker.generated.ts"
import {worded} from "../words/worker_sentences.ts"
import {type ChangeDesc, ChangeSet} from "./text_changes.ts"

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

/// Families of words, each with a colour: the same as those of blocks.
export type Family = "event" | "state" | "command" | "memory" | "task" | "number" | "choice" | "own"

/// What is known of the families of blocks; asked for, because a program may have thousands of blocks and few of them are of interest after an edit.
export interface Families {
  get(block: BlockId): Family | undefined
}

export const noFamilies: Families = new Map()

export interface Program {
  readonly text: string
  readonly spans: readonly Span[]
  readonly definitions: readonly Definition[]
  /// The family of each block whose type is known.
  readonly families: Families
  /// What the names in each top-level piece of the text are there for, by the syntax tree: counted from where the piece starts.
  readonly words: readonly {readonly start: number; readonly words: readonly Word[]}[]
}

export const emptyProgram: Program = {text: "", spans: [], definitions: [], families: noFamilies, words: []}

/// A problem on the page: what it says, and the block and text it is about when it has any.
export interface Finding {
  readonly severity: "error" | "warning" | "note"
  readonly kind: string
  /// Its source: the inference of the blocks, the compiler, or the running program.
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
  /// Key of the socket that it is about, as in `socketKey`.
  readonly socket?: string | undefined
  /// Where in the program's text.
  readonly range: {readonly start: number; readonly end: number} | null
  /// Of a conflict between two functions. Each of them has a finding.
  readonly conflict?: ConflictNames | undefined
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
export function textRangeOf(spans: readonly Span[], block: BlockId): {start: number; end: number} | null {
  let ranges = widest.get(spans)
  if (ranges === undefined) {
    ranges = new Map()
    for (const span of spans) {
      const best = ranges.get(span.block)
      if (best === undefined || span.end - span.start > best.end - best.start) ranges.set(span.block, span)
    }
    widest.set(spans, ranges)
  }
  const range = ranges.get(block)
  return range === undefined ? null : {start: range.start, end: range.end}
}

/// The widest span of each block, found once for each list: a program may have thousands of blocks and of problems.
const widest = new WeakMap<readonly Span[], Map<BlockId, Span>>()

/// Brings a problem of the service home, in the language of the page: to the innermost block at its place, or else to the definition of the
/// function it names.
export function locateProblem(program: Program, problem: Problem, from: "compiler" | "run"): Finding {
  const named = program.definitions.find(d => d.name === problem.function) ?? null
  const start = problem.start === null ? null : offsetOf(program.text, problem.start)
  const end = problem.end === null ? start : offsetOf(program.text, problem.end)
  const range = start === null || end === null ? null : {start, end: Math.max(start, end)}
  const block = range === null ? null : innermostBlock(program.spans, range)
  return {
    severity: problem.severity,
    kind: problem.kind,
    from,
    message: worded(problem.sentences?.message ?? null, problem.message),
    hint: worded(problem.sentences?.hint ?? null, problem.hint),
    ghc: problem.ghc,
    function: problem.function,
    time: problem.time,
    inputs: problem.inputs,
    fixes: problem.fixes.map(({title, sentence, edits}) => ({
      title: worded(sentence, title),
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

/// A problem that codegen found on a block, in the text of the program; `time` is that of the run which showed it.
export function blockFinding(program: Program, problem: BlockProblem, time: number | null = null): Finding {
  const block = problem.block ?? null
  return {
    severity: problem.severity,
    kind: problem.kind,
    from: time === null ? "blocks" : "run",
    message: problem.message,
    hint: problem.hint,
    ghc: "",
    function: null,
    time,
    inputs: [],
    fixes: [],
    block,
    ...(block === null || problem.input === undefined ? {} : {socket: socketKey(block, problem.input)}),
    range: block === null ? null : textRangeOf(program.spans, block),
    ...(problem.conflict === undefined ? {} : {conflict: problem.conflict}),
  }
}

/// Whether two findings are about a common piece of the text.
export function isOverlapping({range: a}: Finding, {range: b}: Finding): boolean {
  return a !== null && b !== null && a.start < b.end && b.start < a.end
}

/// The range after `changes`: it moves with the text around it, and shrinks with deleted text.
export function mapRange(
  changes: ChangeDesc,
  range: {readonly start: number; readonly end: number},
): {start: number; end: number} {
  const start = changes.mapPos(range.start, -1)
  return {start, end: Math.max(start, changes.mapPos(range.end, -1))}
}

/// Text to put in the place of a range. Offsets in UTF-16 units; `end` is exclusive.
export interface Edit {
  readonly start: number
  readonly end: number
  readonly text: string
}

/// What a button says, and all that it replaces at once; no two edits overlap.
export interface Fix {
  readonly title: string
  readonly edits: readonly Edit[]
}

/// The cursor's place after a fix: the first place that it left open, else behind its first edit.
export function selectionAfterFix(fix: Fix): {start: number; end: number} {
  const [first] = [...fix.edits].sort((a, b) => a.start - b.start)
  if (first === undefined) return {start: 0, end: 0}
  const hole = /(?<=[\s(])_(?=\n|$)/.exec(first.text)
  const start = first.start + (hole === null ? first.text.length : hole.index)
  return {start, end: hole === null ? start : start + 1}
}

/// A fix after the text has changed. Text inserted at the edges of an edit is not part of it.
export function mapFix(changes: ChangeDesc, fix: Fix): Fix {
  const edits = fix.edits.map(e => {
    const end = changes.mapPos(e.end, -1)
    return {...e, start: e.start === e.end ? end : Math.min(end, changes.mapPos(e.start, 1)), end}
  })
  return {...fix, edits}
}

/// The changes that a fix makes in a text of `length` UTF-16 units.
export function fixChanges(fix: Fix, length: number): ChangeSet {
  const changes = fix.edits.map(({start, end, text}) => ({from: start, to: end, insert: text}))
  return ChangeSet.of(changes, length)
}

/// The type that the compiler found, written above the definition around `offset`; `null` when it has one, or none is known.
export function signatureFix(
  program: Program,
  declared: readonly Declaration[],
  offset: number,
  title: (signature: string) => string,
): Fix | null {
  const around = program.definitions.find(d => d.start <= offset && offset <= d.end)
  const type = declared.find(d => d.name === around?.name)?.type
  if (around === undefined || type === undefined || !isFunctionName(around.name)) return null
  const text = program.text.slice(around.start, around.end)
  if (!text.startsWith(around.name) || /^\S+\s*(?:,[^:=]*)?::/.test(text)) return null
  const signature = `${around.name} :: ${type}`
  return {
    title: title(signature),
    edits: [{start: around.start, end: around.start, text: `${signature}\n`}],
  }
}

function isFunctionName(name: string): boolean {
  return /^[\p{Ll}_]/u.test(name)
}

/// The definition that holds the selected block.
export function selectedDefinition(program: Program, selected: string | null): string | null {
  const range = selected === null ? null : textRangeOf(program.spans, selected)
  if (range === null) return null
  return program.definitions.find(d => d.start <= range.start && range.end <= d.end)?.name ?? null
}
