/// Whether the compiler reads changed definitions as their blocks do. Pure.
///
/// In: the program before and after an edit, and the compiler's answer about it. Out: names of definitions. The places of the parsed tree's nodes are the
/// tree but for the fixities of operators. Those are in the places of typed expressions, of which only some are told: of two readings of
/// `a * b + c`, one has an expression that begins inside an expression of the other and ends outside of it.

import {areSameGroups, characterOffsets, placesOfGroups, syntaxGroups} from "@rosy/codegen/reader"
import type {Checked, TypesAtPlaces} from "../wire/worker.generated.ts"
import type {Document} from "./history.ts"
import type {Definition, Program, Span} from "./program.ts"

/// `groups` is `null` when the text could not be parsed.
export type CompilerReading = Pick<Checked, "groups" | "types">

interface Range {
  readonly start: number
  readonly end: number
}

/// Names of the definitions whose text is not in `before` and which the compiler groups in another way than the blocks.
export function otherwiseGrouped(
  document: Document,
  before: Document,
  {groups, types}: CompilerReading,
): readonly string[] {
  const {program} = document
  const changed = changedDefinitions(document, before)
  if (changed.length === 0) return []
  const typed = placesOfTypes(program.text, types)
  const parsed = groups === null ? null : placesOfGroups(program.text, groups)
  return changed.flatMap(definition => {
    const {name, start, end} = definition
    const isInside = (range: Range) => start <= range.start && range.end <= end
    const tree = parsed === null ? undefined : groupsOf(document, definition)
    const nodes = (parsed ?? []).filter(isInside).map(r => ({start: r.start - start, end: r.end - start}))
    const isOther = tree !== undefined && !areSameGroups(program.text.slice(start, end), tree, nodes)
    const ours = widestOfEach(program.spans.filter(isInside))
    return isOther || cross([...ours, ...typed.filter(isInside)]) ? [name] : []
  })
}

/// Names of the definitions whose text is not in `before` and is made of blocks. Text that a learner wrote into a block may be unreadable: it stays.
export function changedByBlocks(document: Document, before: Document): readonly string[] {
  return changedDefinitions(document, before).flatMap(definition => {
    const tree = groupsOf(document, definition)
    if (tree === undefined) return []
    const textOf = ({start, end}: Range) =>
      document.program.text.slice(definition.start + start, definition.start + end)
    return tree.texts.every(t => before.program.text.includes(textOf(t))) ? [definition.name] : []
  })
}

function changedDefinitions({program}: Document, before: Document): readonly Definition[] {
  const textOf = ({text}: Program, {start, end}: Range) => text.slice(start, end)
  const known = new Set(before.program.definitions.map(d => textOf(before.program, d)))
  return program.definitions.filter(d => !known.has(textOf(program, d)))
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
