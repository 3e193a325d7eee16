/// Texts of subtrees that stood in an old definition, and the text of a new node made of them.

import type {Node} from "../../model/syntax_tree.ts"
import type {Range} from "../../source/lexer.ts"
import {keyOf, partsOf} from "./model_parts.ts"
import type {Source} from "./source_fragments.ts"
import {columnAt, endColumn, indentAt, rangeOf, reindented, withComments} from "./source_fragments.ts"

/// Text that a moved subtree brings along.
interface Moved extends Range {
  readonly text: string
  readonly column: number
  /// The indentation of the line on which it starts.
  readonly indent: number
  readonly source: Source
}

/// The texts of all subtrees of some definitions, by what they say.
export type MovedTexts = ReadonlyMap<string, readonly Moved[]>

/// The place of the definition, as it stands, for which a text is written.
export interface Origin extends Range {
  readonly source: Source
  /// The indentation of the line on which the text will start.
  readonly indent: number
}

/// Kinds of leaves that are spelled in several ways (`"\SOH"`, `"\1"`). Other single words have nothing to bring along.
const spelled = new Set<Node["kind"]>(["string", "character", "string-pattern", "character-pattern"])

export function movedTexts(definitions: readonly {root: Node; source: Source}[]): MovedTexts {
  const found = new Map<string, Moved[]>()
  for (const {root, source} of definitions) {
    const visit = (node: Node): void => {
      const {places, lists} = partsOf(node)
      const span = source.spans.get(node)
      const isLeaf = places.length === 0 && lists.length === 0
      if (span !== undefined && (!isLeaf || spelled.has(node.kind)) && node !== root) {
        const range = isItem(node) ? withComments(source, span, 0) : span
        const key = keyOf(node)
        const moved = {
          ...range,
          text: source.text.slice(range.start, range.end),
          column: columnAt(source, range.start),
          indent: indentAt(source, range.start),
          source,
        }
        const others = found.get(key)
        if (others === undefined) found.set(key, [moved])
        else others.push(moved)
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

/// The text of a subtree: of several that say the same, the one in the place of the edit, else the first.
function movedText(movedTexts: MovedTexts, node: Node, origin: Origin): Moved | undefined {
  const all = movedTexts.get(keyOf(node))
  return (
    all?.find(m => m.source === origin.source && m.start >= origin.start && m.end <= origin.end) ?? all?.[0]
  )
}

/// A node of the new definition as text that starts in a column, for a place of the old one. Subtrees that stood in the old text keep theirs.
export function written(
  source: Source,
  movedTexts: MovedTexts,
  node: Node,
  b: Range,
  column: number,
  origin: Origin,
): string {
  const moved = movedText(movedTexts, node, origin)
  if (moved !== undefined) return placed(moved, column, origin.indent)
  const span = rangeOf(source, node)
  if (span === undefined) return ""
  const range = isItem(node) ? withComments(source, span, b.start) : span
  const base = columnAt(source, range.start)
  let out = ""
  let at = range.start
  for (const {range: inner, moved} of movedInside(source, movedTexts, node, origin)) {
    out += reindented(source.text.slice(at, inner.start), column - base)
    out += placed(moved, endColumn(out, column), out.includes("\n") ? indentOf(lastLine(out)) : origin.indent)
    at = inner.end
  }
  return out + reindented(source.text.slice(at, range.end), column - base)
}

/// A moved text that starts in a column of a line. Its later lines follow its own column where they are right of it, else the indentation of its line.
function placed({text, column, indent}: Moved, at: number, lineIndent: number): string {
  const [, ...later] = text.split("\n")
  const hangs = later.some(line => line.trim() !== "" && indentOf(line) < column)
  return reindented(text, hangs ? lineIndent - indent : at - column)
}

function indentOf(line: string): number {
  return line.length - line.trimStart().length
}

function lastLine(text: string): string {
  return text.slice(text.lastIndexOf("\n") + 1)
}

function movedInside(
  source: Source,
  movedTexts: MovedTexts,
  node: Node,
  origin: Origin,
): readonly {range: Range; moved: Moved}[] {
  const found: {range: Range; moved: Moved}[] = []
  const visit = (n: Node): void => {
    const {places, lists} = partsOf(n)
    for (const part of [...places, ...lists.flatMap(l => l.items)]) {
      if (part === undefined) continue
      const moved = movedText(movedTexts, part, origin)
      const span = rangeOf(source, part)
      if (moved === undefined || span === undefined) visit(part)
      else found.push({range: isItem(part) ? withComments(source, span, 0) : span, moved})
    }
  }
  visit(node)
  return found.sort((x, y) => x.range.start - y.range.start)
}
