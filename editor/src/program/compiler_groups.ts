/// Whether the compiler reads definitions as their blocks do. Pure.
///
/// In: the program, definitions of it that edits of blocks have written, and the compiler's answer about it. Out: names of definitions. The places of the parsed tree's nodes are the
/// tree but for the fixities of operators. Those are in the places of typed expressions, of which only some are told: of two readings of
/// `a * b + c`, one has an expression that begins inside an expression of the other and ends outside of it.

import {areSameGroups, characterOffsets, placesOfGroups, syntaxGroups} from "@rosy/codegen/reader"
import type {Checked, TypesAtPlaces} from "../wire/worker.generated.ts"
import type {Document} from "./history.ts"
import type {Definition, Span} from "./program.ts"

/// `groups` is `null` when the text could not be parsed.
export type CompilerReading = Pick<Checked, "groups" | "types">

interface Range {
  readonly start: number
  readonly end: number
}

/// Those of the definitions that the compiler groups in another way than the blocks.
export function otherwiseGrouped(
  document: Document,
  definitions: readonly Definition[],
  {groups, types}: CompilerReading,
): readonly Definition[] {
  const {program} = document
  if (definitions.length === 0) return []
  const typed = placesOfTypes(program.text, types)
  const parsed = groups === null ? null : placesOfGroups(program.text, groups)
  return definitions.filter(definition => {
    const {start, end} = definition
    const isInside = (range: Range) => start <= range.start && range.end <= end
    const tree = parsed === null ? undefined : groupsOf(document, definition)
    const nodes = (parsed ?? []).filter(isInside).map(r => ({start: r.start - start, end: r.end - start}))
    const isOther = tree !== undefined && !areSameGroups(program.text.slice(start, end), tree, nodes)
    const ours = widestOfEach(program.spans.filter(isInside))
    return isOther || cross([...ours, ...typed.filter(isInside)])
  })
}

/// Whether the definitions are made of blocks. Text that a learner wrote into a block, which is not in `before`, may be unreadable: it stays.
export function areMadeOfBlocks(
  document: Document,
  definitions: readonly Definition[],
  before: Document,
): boolean {
  return definitions.every(definition => {
    const tree = groupsOf(document, definition)
    const textOf = ({start, end}: Range) =>
      document.program.text.slice(definition.start + start, definition.start + end)
    return tree?.texts.every(t => before.program.text.includes(textOf(t))) === true
  })
}

function groupsOf({view}: Document, {start}: Definition): ReturnType<typeof syntaxGroups> {
  const piece = view?.module.pieces.find(p => p.kind === "declaration" && p.core.start === start)
  return piece === undefined ? undefined : syntaxGroups(piece)
}

/// The places of the types that are told.
function placesOfTypes(text: string, {at}: TypesAtPlaces): readonly Range[] {
  const offset = characterOffsets(text)
  return at.map(([line = 1, column = 1, endLine = 1, endColumn = 1]) => ({
    start: offset(line, column),
    end: offset(endLine, endColumn),
  }))
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
