/// Whether the compiler groups changed definitions as their blocks do. Pure.
///
/// The compiler tells the places of the expressions and patterns that it has found. Of two readings of one text, one has an expression that
/// begins inside an expression of the other and ends outside of it: `a * b` and `b + c` in `a * b + c`. Pieces that only one of the two tells
/// of say nothing, such as `f x` in `f x y`.

import type {TypesAtPlaces} from "../wire/worker.generated.ts"
import type {Program, Span} from "./program.ts"

interface Range {
  readonly start: number
  readonly end: number
}

/// Names of the definitions whose text is not in `before` and which the compiler groups in another way than the blocks.
export function otherwiseGrouped(program: Program, before: Program, types: TypesAtPlaces): readonly string[] {
  const textOf = ({text}: Program, {start, end}: Range) => text.slice(start, end)
  const known = new Set(before.definitions.map(d => textOf(before, d)))
  const changed = program.definitions.filter(d => !known.has(textOf(program, d)))
  if (changed.length === 0) return []
  const lines = lineStarts(program.text)
  return changed.flatMap(definition => {
    const isInside = ({start, end}: Range) => definition.start <= start && end <= definition.end
    const ours = widestOfEach(program.spans.filter(isInside))
    const theirs = placesIn(program.text, lines, types, definition).filter(isInside)
    return cross([...ours, ...theirs]) ? [definition.name] : []
  })
}

/// The offset at which each line starts.
function lineStarts(text: string): readonly number[] {
  const starts = [0]
  for (let at = text.indexOf("\n"); at >= 0; at = text.indexOf("\n", at + 1)) starts.push(at + 1)
  return starts
}

/// The places that the compiler told of on the lines of a definition. Their columns count characters, offsets UTF-16 units.
function placesIn(
  text: string,
  lines: readonly number[],
  {at}: TypesAtPlaces,
  definition: Range,
): readonly Range[] {
  const offset = (line: number, column: number): number => {
    const start = lines[line - 1] ?? text.length
    let units = 0
    for (let i = 1; i < column; i++) units += (text.codePointAt(start + units) ?? 0) > 0xffff ? 2 : 1
    return start + units
  }
  return at.flatMap(([line = 0, column = 0, endLine = 0, endColumn = 0]) => {
    const isNear =
      (lines[line - 1] ?? 0) <= definition.end && (lines[endLine] ?? text.length) >= definition.start
    return isNear ? [{start: offset(line, column), end: offset(endLine, endColumn)}] : []
  })
}

function widestOfEach(spans: readonly Span[]): readonly Range[] {
  const widest = new Map<string, Span>()
  for (const span of spans) {
    const best = widest.get(span.block)
    if (best === undefined || span.end - span.start > best.end - best.start) widest.set(span.block, span)
  }
  return [...widest.values()]
}

/// Whether one of the ranges begins inside another and ends outside of it.
function cross(ranges: readonly Range[]): boolean {
  const open: number[] = []
  for (const {start, end} of [...ranges].sort((a, b) => a.start - b.start || b.end - a.end)) {
    while ((open.at(-1) ?? Number.POSITIVE_INFINITY) <= start) open.pop()
    if (end > (open.at(-1) ?? Number.POSITIVE_INFINITY)) return true
    open.push(end)
  }
  return false
}
