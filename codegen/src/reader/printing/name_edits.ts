/// Edits of the words of a node between its parts: an operator, or the name of a function in its signature and equations.

import type {Node} from "../../model/syntax_tree.ts"
import type {Source} from "./source_fragments.ts"
import {rangeOf} from "./source_fragments.ts"
import type {Edit} from "./text_edits.ts"

/// The words of a node between its parts: an operator, or the name of a function in its signature and equations.
export function nameEdits(source: Source, old: Node, fresh: Node): readonly Edit[] | undefined {
  const {text} = source
  if (old.kind === "infix" && fresh.kind === "infix") {
    const [left, right] = [rangeOf(source, old.left), rangeOf(source, old.right)]
    return left && right && wordEdit(source, left.end, right.start, old.op, fresh.op)
  }
  if (old.kind !== "function" || fresh.kind !== "function") return undefined
  if ((old.signature === undefined) !== (fresh.signature === undefined)) return undefined
  const edits: Edit[] = []
  const span = rangeOf(source, old)
  const signature = old.signature && rangeOf(source, old.signature)
  const places: [number, number][] = span && signature ? [[span.start, signature.start]] : []
  for (const clause of old.clauses) {
    const range = rangeOf(source, clause)
    if (range === undefined) return undefined
    const [first, second] = clause.patterns.map(p => rangeOf(source, p))
    const infix =
      first !== undefined && second !== undefined && !startsWithName(source, range.start, old.name)
    places.push(infix ? [first.end, second.start] : [range.start, first?.start ?? range.end])
  }
  for (const [start, end] of places) {
    const bare = new RegExp(`^\\s*\\(?\\s*${escaped(old.name)}\\s*\\)?`, "u").exec(text.slice(start, end))
    const edit = wordEdit(source, start, bare === null ? end : start + bare[0].length, old.name, fresh.name)
    if (edit === undefined) return undefined
    edits.push(...edit)
  }
  return edits
}

function startsWithName(source: Source, at: number, name: string): boolean {
  return new RegExp(`^(?:${escaped(name)}(?![\\p{L}\\p{N}_'])|\\(\\s*${escaped(name)}\\s*\\))`, "u").test(
    source.text.slice(at),
  )
}

/// The edit of the only word between two places, with its backticks or brackets.
function wordEdit(
  source: Source,
  start: number,
  end: number,
  old: string,
  fresh: string,
): readonly Edit[] | undefined {
  const symbol = (name: string): boolean => !/^[\p{L}_]/u.test(name.replace(/^(?:\p{Lu}[\w']*\.)+(?=.)/u, ""))
  const between = source.text.slice(start, end)
  if (symbol(old) === symbol(fresh)) {
    const at = between.indexOf(old)
    if (at === -1 || between.indexOf(old, at + 1) !== -1) return undefined
    return [{start: start + at, end: start + at + old.length, text: fresh}]
  }
  const written = symbol(old) ? old : new RegExp(`\`\\s*${escaped(old)}\\s*\``, "u").exec(between)?.[0]
  const at = written === undefined ? -1 : between.indexOf(written)
  if (written === undefined || at === -1 || /[()]/.test(between.slice(at))) return undefined
  return [
    {
      start: start + at,
      end: start + at + written.length,
      text: symbol(fresh) ? fresh : `\`${fresh}\``,
    },
  ]
}

function escaped(name: string): string {
  return name.replace(/[.*+?^${}()|[\]\\/-]/g, "\\$&")
}
