/// Items of a list in a definition's text: their ranges, what separates them, deletion, and pairing with new items.

import type {Node} from "../../model/syntax_tree.ts"
import type {Range} from "../../source/lexer.ts"
import type {Separator} from "./model_parts.ts"
import {partsOf} from "./model_parts.ts"
import type {Source} from "./source_fragments.ts"
import {rangeOf, withBrackets, withComments} from "./source_fragments.ts"
import type {Edit} from "./text_edits.ts"

/// The place of an item with what belongs to it: its comments, or its brackets.
export function itemRange(
  source: Source,
  separator: Separator,
  items: readonly Node[],
  i: number,
  a: Range,
): Range | undefined {
  const node = items[i]
  const span = node && rangeOf(source, node)
  if (span === undefined) return undefined
  if (separator !== "line") return withBrackets(source, span, a)
  const previous = i === 0 ? undefined : rangeOf(source, items[i - 1] as Node)
  return withComments(source, span, previous?.end ?? a.start)
}

export function deletion(
  source: Source,
  separator: Separator,
  items: readonly Node[],
  i: number,
  a: Range,
): readonly Edit[] | undefined {
  const own = itemRange(source, separator, items, i, a)
  const previous = i === 0 ? undefined : itemRange(source, separator, items, i - 1, a)
  const next = itemRange(source, separator, items, i + 1, a)
  if (own === undefined) return undefined
  const comments = (start: number, end: number) =>
    source.comments.some(c => c.start >= start && c.end <= end && (c.end <= own.start || c.start >= own.end))
  if (previous !== undefined && !comments(previous.end, own.end))
    return [{start: previous.end, end: own.end, text: ""}]
  return next === undefined || comments(own.start, next.start)
    ? undefined
    : [{start: own.start, end: next.start, text: ""}]
}

/// What stands between two items of the list: as between those that are there, or as is usual.
export function separatorText(
  source: Source,
  separator: Separator,
  items: readonly Node[],
  last: number,
  column: number,
  a: Range,
): string | undefined {
  const [left, right] =
    items.length < 2
      ? [undefined, undefined]
      : [Math.min(last, items.length - 2), Math.min(last, items.length - 2) + 1].map(i =>
          itemRange(source, separator, items, i, a),
        )
  const found = left && right ? source.text.slice(left.end, right.start) : undefined
  const newline = source.text.includes("\r\n") ? "\r\n" : "\n"
  switch (separator) {
    case "line":
      if (found === undefined || found.includes("\n")) return newline + " ".repeat(column)
      return /^\s*;\s*$/.test(found) ? found : undefined
    case "space":
      return found !== undefined && /^\s+$/.test(found) ? found : " "
    case "comma":
      return found !== undefined && /^\s*,\s*$/.test(found) ? found : ", "
    case "bar":
      return found !== undefined && /^\s*\|\s*$/.test(found) ? found : " | "
  }
}

/// Partners in a gap between equal items: the same kind of node, in order; all, when the gap is as long as before.
export function paired(gone: readonly Node[], come: readonly Node[]): ReadonlyMap<number, number> {
  const pairs = new Map<number, number>()
  if (gone.length === come.length) {
    for (const i of gone.keys()) pairs.set(i, i)
    return pairs
  }
  let next = 0
  for (const [i, node] of gone.entries()) {
    const found = come.findIndex(
      (c, k) => k >= next && partsOf(c).label === partsOf(node).label && c.kind === node.kind,
    )
    if (found === -1) continue
    pairs.set(i, found)
    next = found + 1
  }
  return pairs
}
