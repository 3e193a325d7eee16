/// Incremental reading: the pieces of an edited text from those before the edit.
///
/// A window of the text is read alone: the pieces that the edit touches, with one definition before them and one behind, which it does not touch. Where both
/// are read as before, what stands around the window is read as before, too; otherwise the whole file is read again.

import type {Fixity} from "../../haskell/fixity.ts"
import {redefinedOperators} from "../../haskell/fixity.ts"
import {operatorsIn} from "../../haskell/import_fixities.ts"
import {firstWith, type Range} from "../../source/lexer.ts"
import type {Converted, Module, Piece} from "./module_pieces.ts"

/// What is remembered of each piece.
export interface Section {
  /// The name it seems to define, by its first words.
  readonly name: string
  /// All that its conversion depends on; empty when it is not converted.
  readonly key: string
  readonly converted: Converted | undefined
  /// Whether it is a definition in a place of its own, so that a window may begin or end with it.
  readonly isDefinition: boolean
}

/// A text as it was read.
export interface Reading {
  readonly module: Module
  /// As many as the module has pieces.
  readonly sections: readonly Section[]
  /// Extensions of the language that the file turns on.
  readonly extensions: ReadonlySet<string>
  /// Operators whose binding the file declares itself.
  readonly declared: ReadonlyMap<string, Fixity>
  /// All operators of the file, where some are imported with a fixity of their own or an unknown one.
  readonly operators: ReadonlySet<string> | undefined
  readonly margin: number | undefined
  readonly isClosed: boolean
}

/// What an edit can have changed.
export interface Change {
  /// The numbers of the pieces of the window before the edit; `behind` is exclusive.
  readonly first: number
  readonly behind: number
  /// The window in the new text.
  readonly start: number
  readonly end: number
  /// By how much the text behind the window moved.
  readonly shift: number
  /// The file's margin, when the window does not begin with the file.
  readonly margin: number | undefined
}

/// A window of the new text as it was read by itself.
export interface Window {
  readonly pieces: readonly Piece[]
  readonly sections: readonly Section[]
  readonly margin: number | undefined
  readonly isClosed: boolean
}

/// The window for an edit; undefined where a part of the file depends on all of it.
export function changedPieces(
  {module, sections, margin, isClosed}: Reading,
  text: string,
): Change | undefined {
  const {pieces, text: before} = module
  if (!isClosed || margin === undefined) return undefined
  const [from, same] = commonEnds(before, text)
  const to = before.length - same
  // What ends where the change begins may go on with it.
  const touched = firstWith(pieces, piece => piece.end >= from)
  let first = Math.max(touched - 1, 0)
  // The reading of a window that begins with the file needs nothing from above.
  const beginsLine = (i: number) => i === 0 || pieces[i - 1]?.slice.endsWith("\n") === true
  if (sections[first]?.isDefinition !== true || !beginsLine(first)) first = 0
  let behind = firstWith(pieces, piece => piece.start > to)
  while (behind < pieces.length && !(sections[behind]?.isDefinition === true && beginsLine(behind + 1)))
    behind += 1
  behind = Math.min(behind + 1, pieces.length)
  const shift = text.length - before.length
  return {
    first,
    behind,
    start: pieces[first]?.start ?? 0,
    end: behind === pieces.length ? text.length : (pieces[behind - 1]?.end ?? 0) + shift,
    shift,
    margin: first === 0 ? undefined : margin,
  }
}

/// How many units two texts have in common at the beginning, and at the end behind that.
function commonEnds(one: string, other: string): readonly [number, number] {
  const most = Math.min(one.length, other.length)
  let start = 0
  while (start < most && one.charCodeAt(start) === other.charCodeAt(start)) start += 1
  let end = 0
  while (
    end < most - start &&
    one.charCodeAt(one.length - 1 - end) === other.charCodeAt(other.length - 1 - end)
  )
    end += 1
  return [start, end]
}

/// Whether operators bind in the whole file as they did and its extensions are the same, so that what is outside of the window says the same.
export function hasSameDialect(
  {module, sections, declared, operators}: Reading,
  {first, behind}: Change,
  window: string,
  parts: readonly {readonly name: string}[],
): boolean {
  const declares = (text: string) => text.includes("infix") || /LANGUAGE/i.test(text)
  if (declares(window) || module.pieces.slice(first, behind).some(piece => declares(piece.slice)))
    return false
  const old = module.pieces
    .slice(first, behind)
    .map(piece => piece.slice)
    .join("")
  if (importLines(old) !== importLines(window)) return false
  if (
    operators !== undefined &&
    hasOtherOperators(operators, window, [...parts, ...sections.slice(first, behind)])
  )
    return false
  const own = (named: readonly {readonly name: string}[]) =>
    [
      ...redefinedOperators(
        named.map(part => part.name),
        declared,
      ).keys(),
    ].join(" ")
  const now = [...sections.slice(0, first), ...parts, ...sections.slice(behind)]
  return own(sections) === own(now)
}

function importLines(text: string): string {
  return (text.match(/^[ \t]*import\b.*(?:\n[ \t]+.*)*/gm) ?? []).join("\n")
}

/// Whether a window has an operator that the file had not, or defines one, so that fixities of the file must be found anew.
function hasOtherOperators(
  operators: ReadonlySet<string>,
  window: string,
  defined: readonly {readonly name: string}[],
): boolean {
  if (defined.some(({name}) => operators.has(name))) return true
  return [...operatorsIn(window)].some(op => !operators.has(op))
}

/// The reading with the window in its place; undefined where the window has an effect on what is outside of it.
export function replaced(
  before: Reading,
  text: string,
  {first, behind, start, shift}: Change,
  {pieces, sections, margin, isClosed}: Window,
): Reading | undefined {
  const isLast = behind === before.sections.length
  const keeps = (old: number, now: number) => before.sections[old]?.key === sections[now]?.key
  if (!isClosed || (!isLast && margin !== before.margin)) return undefined
  if (first > 0 && !keeps(first, 0)) return undefined
  if (!isLast && !keeps(behind - 1, sections.length - 1)) return undefined
  return {
    ...before,
    module: {
      ...before.module,
      text,
      pieces: [
        ...before.module.pieces.slice(0, first),
        ...pieces.map(piece => moved(piece, start)),
        ...before.module.pieces.slice(behind).map(piece => moved(piece, shift)),
      ],
    },
    sections: [...before.sections.slice(0, first), ...sections, ...before.sections.slice(behind)],
    margin: margin ?? before.margin,
  }
}

function moved(piece: Piece, by: number): Piece {
  if (by === 0) return piece
  const {core, remark, start, end} = piece
  return {
    ...piece,
    core: movedRange(core, by),
    remark: remark && movedRange(remark, by),
    start: start + by,
    end: end + by,
  }
}

function movedRange({start, end}: Range, by: number): Range {
  return {start: start + by, end: end + by}
}
