/// Fragments of a definition's source: columns, brackets, and the comments that belong to an item of a list.

import type {Node} from "../../model/syntax_tree.ts"
import type {Range} from "../../source/lexer.ts"
import {lex} from "../../source/top_level_items.ts"
import type {Piece} from "../module/module_pieces.ts"
import {asWritten} from "./model_parts.ts"

/// The text of a definition without the comment above it, with the spans of its nodes.
export interface Source {
  readonly text: string
  /// The column of its first character.
  readonly column: number
  readonly spans: ReadonlyMap<object, Range>
  readonly comments: readonly Range[]
  /// Whether a comment stands behind the definition, on its last line.
  readonly hasCommentBehind: boolean
}

export function sourceOf(piece: Piece): Source {
  const start = piece.core.start - piece.start
  const text = piece.slice.slice(start, piece.core.end - piece.start)
  const column = start - (piece.slice.lastIndexOf("\n", start - 1) + 1)
  const hasCommentBehind = /^[ \t]*(?:--|\{-)/.test(piece.slice.slice(piece.core.end - piece.start))
  return {text, column, spans: piece.spans, comments: lex(text).comments, hasCommentBehind}
}

export function columnAt(source: {text: string; column: number}, at: number): number {
  const line = source.text.lastIndexOf("\n", at - 1)
  return line === -1 ? source.column + at : at - line - 1
}

/// The column behind a text that starts in a column.
export function endColumn(text: string, column: number): number {
  return columnAt({text, column}, text.length)
}

/// The indentation of the line of a place.
export function indentAt(source: {text: string; column: number}, at: number): number {
  const line = source.text.lastIndexOf("\n", at - 1) + 1
  const blanks = /^[ \t]*/.exec(source.text.slice(line))?.[0].length ?? 0
  return line === 0 ? source.column + blanks : blanks
}

/// Whether only blanks stand before a place on its line.
export function startsLine(source: Source, at: number): boolean {
  const line = source.text.lastIndexOf("\n", at - 1)
  return source.text.slice(line + 1, at).trim() === "" && (line !== -1 || at === 0)
}

/// The later lines of a text, moved by a number of columns; never further left than the margin.
export function reindented(text: string, by: number): string {
  if (by === 0 || !text.includes("\n")) return text
  const [first = "", ...others] = text.split("\n")
  const moved = others.map(l => {
    if (l.trim() === "") return l
    return by > 0 ? " ".repeat(by) + l : l.slice(Math.min(-by, l.length - l.trimStart().length))
  })
  return [first, ...moved].join("\n")
}

/// The range with the pair of round brackets around it, inside of `bound`; undefined when there is none.
export function bracketsAround(source: Source, range: Range, bound: Range): Range | undefined {
  const {text} = source
  let start = range.start - 1
  while (start >= bound.start && /\s/.test(text[start] ?? "")) start--
  let end = range.end
  while (end < bound.end && /\s/.test(text[end] ?? "")) end++
  return start >= bound.start && end < bound.end && text[start] === "(" && text[end] === ")"
    ? {start, end: end + 1}
    : undefined
}

/// The range with all brackets around it.
export function withBrackets(source: Source, range: Range, bound: Range): Range {
  let all = range
  for (let more = bracketsAround(source, all, bound); more !== undefined; ) {
    all = more
    more = bracketsAround(source, all, bound)
  }
  return all
}

/// An item of a list with the comments on the lines directly above it and the one behind it on its last line.
export function withComments(source: Source, range: Range, from: number): Range {
  let {start, end} = range
  if (startsLine(source, start))
    for (let i = source.comments.length - 1; i >= 0; i--) {
      const c = source.comments[i]
      if (c === undefined || c.end > start) continue
      const between = source.text.slice(c.end, start)
      if (c.start < from || !/^[ \t]*\r?\n[ \t]*$/.test(between) || !startsLine(source, c.start)) break
      start = c.start
    }
  for (const c of source.comments) {
    if (c.start < end || /[^ \t]/.test(source.text.slice(end, c.start))) continue
    if (/^[ \t]*(?:\r?\n|$)/.test(source.text.slice(c.end))) end = c.end
    break
  }
  return {start, end}
}

/// The range of a node in the text.
export function rangeOf(source: Source, node: Node): Range | undefined {
  return source.spans.get(asWritten(node))
}
