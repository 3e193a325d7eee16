/// Edits of a definition's text: their order, their application, and the columns of the lines below them.

import type {Node} from "../../model/syntax_tree.ts"
import type {Range} from "../../source/lexer.ts"
import {partsOf} from "./model_parts.ts"
import type {Source} from "./source_fragments.ts"
import {columnAt, endColumn} from "./source_fragments.ts"

/// A range of the old text and what replaces it.
export interface Edit extends Range {
  readonly text: string
}

function inOrder(edits: readonly Edit[]): readonly Edit[] {
  return edits
    .map((edit, i) => ({edit, i}))
    .sort((x, y) => x.edit.start - y.edit.start || x.edit.end - y.edit.end || x.i - y.i)
    .map(e => e.edit)
}

export function applied(text: string, edits: readonly Edit[]): string {
  let out = ""
  let at = 0
  for (const e of inOrder(edits)) {
    out += text.slice(at, Math.max(at, e.start)) + e.text
    at = Math.max(at, e.end)
  }
  return out + text.slice(at)
}

/// Items below one that an edit before it on its line moves are moved with it: they stand in its column.
export function withShiftedLayout(
  before: {root: Node; source: Source},
  edits: readonly Edit[],
): readonly Edit[] {
  const {root, source} = before
  const ordered = inOrder(edits)
  const shifts = new Map<number, number>()
  const visit = (node: Node): void => {
    const {places, lists} = partsOf(node)
    for (const {separator, items} of lists) {
      const [first, last] = [items[0], items[items.length - 1]].map(n => n && source.spans.get(n))
      if (separator === "line" && first !== undefined && last !== undefined) {
        const line = source.text.lastIndexOf("\n", first.start - 1) + 1
        const earlier = ordered.filter(e => e.end <= first.start)
        const by = earlier.some(e => e.end >= line)
          ? endColumn(applied(source.text.slice(0, first.start), earlier), source.column) -
            columnAt(source, first.start)
          : 0
        if (by !== 0)
          for (
            let at = source.text.indexOf("\n", first.start);
            at !== -1 && at < last.end;
            at = source.text.indexOf("\n", at + 1)
          )
            if (!shifts.has(at + 1)) shifts.set(at + 1, by)
      }
      items.forEach(visit)
    }
    for (const p of places) if (p !== undefined) visit(p)
  }
  visit(root)
  const more: Edit[] = []
  for (const [at, by] of shifts) {
    const blanks = /^[ ]*/.exec(source.text.slice(at))?.[0].length ?? 0
    if (/^[ \t]*\r?(?:\n|$)/.test(source.text.slice(at)) || ordered.some(e => e.start < at && e.end >= at))
      continue
    more.push({start: at, end: at + Math.min(blanks, Math.max(0, -by)), text: " ".repeat(Math.max(0, by))})
  }
  return [...ordered, ...more]
}
