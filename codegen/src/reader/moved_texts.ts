/// Texts of subtrees that stood in an old definition, and the text of a new node made of them.

import type {Node} from "../model/syntax_tree.ts"
import type {Range} from "../source/lexer.ts"
import {keyOf, partsOf} from "./model_parts.ts"
import type {Source} from "./source_fragments.ts"
import {columnAt, endColumn, rangeOf, reindented, withComments} from "./source_fragments.ts"

/// Text that a moved subtree brings along.
interface Moved {
  readonly text: string
  readonly column: number
}

/// The texts of all subtrees of some definitions, by what they say.
export type MovedTexts = ReadonlyMap<string, Moved>

export function movedTexts(definitions: readonly {root: Node; source: Source}[]): MovedTexts {
  const found = new Map<string, Moved>()
  for (const {root, source} of definitions) {
    const visit = (node: Node): void => {
      const {places, lists} = partsOf(node)
      const span = source.spans.get(node)
      // A single word has nothing to bring along.
      if (span !== undefined && (places.length > 0 || lists.length > 0) && node !== root) {
        const range = isItem(node) ? withComments(source, span, 0) : span
        const key = keyOf(node)
        if (!found.has(key))
          found.set(key, {
            text: source.text.slice(range.start, range.end),
            column: columnAt(source, range.start),
          })
      }
      for (const p of places) if (p !== undefined) visit(p)
      for (const l of lists) l.items.forEach(visit)
    }
    visit(root)
  }
  return found
}

/// Nodes that stand on lines of their own, with comments above.
const items = new Set<Node["kind"]>([
  "function",
  "binding",
  "data",
  "synonym",
  "instance",
  "raw-declaration",
  "clause",
  "alternative",
  "guarded",
  "bind",
  "let-statement",
  "statement",
])

export function isItem(node: Node): boolean {
  return items.has(node.kind)
}

/// A node of the new definition as text that starts in a column. Subtrees that stood in the old text keep theirs.
export function written(
  source: Source,
  movedTexts: MovedTexts,
  node: Node,
  b: Range,
  column: number,
): string {
  const moved = movedTexts.get(keyOf(node))
  if (moved !== undefined) return reindented(moved.text, column - moved.column)
  const span = rangeOf(source, node)
  if (span === undefined) return ""
  const range = isItem(node) ? withComments(source, span, b.start) : span
  const base = columnAt(source, range.start)
  let out = ""
  let at = range.start
  for (const {range: inner, moved} of movedInside(source, movedTexts, node)) {
    out += reindented(source.text.slice(at, inner.start), column - base)
    out += reindented(moved.text, endColumn(out, column) - moved.column)
    at = inner.end
  }
  return out + reindented(source.text.slice(at, range.end), column - base)
}

function movedInside(
  source: Source,
  movedTexts: MovedTexts,
  node: Node,
): readonly {range: Range; moved: Moved}[] {
  const found: {range: Range; moved: Moved}[] = []
  const visit = (n: Node): void => {
    const {places, lists} = partsOf(n)
    for (const part of [...places, ...lists.flatMap(l => l.items)]) {
      if (part === undefined) continue
      const moved = movedTexts.get(keyOf(part))
      const span = rangeOf(source, part)
      if (moved === undefined || span === undefined) visit(part)
      else found.push({range: isItem(part) ? withComments(source, span, 0) : span, moved})
    }
  }
  visit(node)
  return found.sort((x, y) => x.range.start - y.range.start)
}
