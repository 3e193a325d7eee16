/// Comments of a teacher on places in a program, and where those places are after edits. Pure.
///
/// A place is a range in the text of a definition as it was when the comment was written. It is found again by the differences between that text and the definition
/// as it is now; so it follows edits on every device, and nothing about it is stored with the program.

import {innermostBlock, type Program, textRangeOf} from "./program.ts"
import {changesBetween} from "./text_changes.ts"

export interface PlaceInProgram {
  /// The name of the definition; `null` for lines outside of definitions.
  readonly definition: string | null
  /// Its text when the place was chosen.
  readonly piece: string
  /// The range in `piece`, in UTF-16 units.
  readonly start: number
  readonly end: number
}

export interface BlockComment {
  readonly id: number
  readonly text: string
  readonly place: PlaceInProgram
}

interface Range {
  readonly start: number
  readonly end: number
}

/// Characters of a piece that the service takes (protocol §11).
const longestPiece = 20_000

/// The place of a block; of the line at `cursor` for a block without a text, or for none. `null` in an empty line.
export function placeOf(program: Program, block: string | null, cursor: number): PlaceInProgram | null {
  const range = (block === null ? null : textRangeOf(program.spans, block)) ?? lineAt(program.text, cursor)
  if (program.text.slice(range.start, range.end).trim() === "") return null
  const around = program.definitions.find(d => d.start <= range.start && range.end <= d.end)
  if (around !== undefined && around.end - around.start <= longestPiece)
    return {
      definition: around.name,
      piece: program.text.slice(around.start, around.end),
      start: range.start - around.start,
      end: range.end - around.start,
    }
  const piece = program.text.slice(range.start, range.end).slice(0, longestPiece)
  return {definition: null, piece, start: 0, end: piece.length}
}

function lineAt(text: string, offset: number): Range {
  const start = text.lastIndexOf("\n", offset - 1) + 1
  const end = text.indexOf("\n", offset)
  return {start, end: end < 0 ? text.length : end}
}

/// Share of a definition's letters that a definition of another name must have, to be the same one under a new name.
const alikeEnough = 0.6

/// Where a place is now; `null` when it is gone.
export function locatePlace(program: Program, place: PlaceInProgram): Range | null {
  const {definition, piece, start, end} = place
  const textOf = ({start: from, end: to}: Range) => program.text.slice(from, to)
  const own = program.definitions.find(d => d.name === definition)
  if (own !== undefined) return moved(piece, textOf(own), place, own.start)
  const same = program.text.indexOf(piece)
  if (same >= 0) return {start: same + start, end: same + end}
  if (definition === null) return null
  const [renamed] = program.definitions
    .map(one => ({one, share: keptShare(piece, textOf(one))}))
    .filter(({share}) => share >= alikeEnough)
    .sort((a, b) => b.share - a.share)
  return renamed === undefined ? null : moved(piece, textOf(renamed.one), place, renamed.one.start)
}

/// The range of `piece` in `now`, which starts at `at`.
function moved(piece: string, now: string, {start, end}: Range, at: number): Range | null {
  if (start === 0 && end === piece.length) return {start: at, end: at + now.length}
  const changes = changesBetween(piece, now)
  const inner = {start: changes.mapPos(start, 1), end: changes.mapPos(end, -1)}
  // What was written in the place of all of it stands at its edges.
  const range =
    inner.start < inner.end ? inner : {start: changes.mapPos(start, -1), end: changes.mapPos(end, 1)}
  if (now.slice(range.start, range.end).trim() === "") return null
  return {start: at + range.start, end: at + range.end}
}

function keptShare(piece: string, now: string): number {
  let kept = 0
  changesBetween(piece, now).iterGaps((_from, _to, length) => {
    kept += length
  })
  return kept / Math.max(piece.length, now.length)
}

/// A comment at its place.
export interface LocatedComment {
  readonly comment: BlockComment
  readonly range: Range
  readonly block: string | null
}

/// The comments whose places are not gone.
export function locateComments(
  program: Program,
  comments: readonly BlockComment[],
): readonly LocatedComment[] {
  return comments.flatMap(comment => {
    const range = locatePlace(program, comment.place)
    return range === null ? [] : [{comment, range, block: innermostBlock(program.spans, range)}]
  })
}

/// Characters of a place that are quoted.
const longestQuote = 40

/// The first line of a place's text, to be quoted beside its comment.
export function quoteOf(text: string): string {
  const line = text.trim().split("\n")[0] ?? ""
  return line.length > longestQuote ? `${line.slice(0, longestQuote - 1)}…` : line
}

/// The number of the line at an offset, from 1.
export const lineNumber = (text: string, offset: number): number => text.slice(0, offset).split("\n").length
