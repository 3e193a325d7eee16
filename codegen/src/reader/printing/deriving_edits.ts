/// Edits of the classes that a type derives.

import type {DataDeclaration} from "../../model/syntax_tree.ts"
import type {Range} from "../../source/lexer.ts"
import type {Source} from "./source_fragments.ts"
import {indentAt, rangeOf} from "./source_fragments.ts"
import type {Edit} from "./text_edits.ts"

/// The edit that adds classes behind those that are derived; undefined for every other difference.
export function derivingEdits(
  source: Source,
  old: DataDeclaration,
  fresh: DataDeclaration,
): readonly Edit[] | undefined {
  const span = rangeOf(source, old)
  const added = fresh.deriving.slice(old.deriving.length)
  const isLonger = added.length > 0 && old.deriving.every((name, i) => name === fresh.deriving[i])
  if (span === undefined || !isLonger || headOf(old) !== headOf(fresh)) return undefined
  return old.deriving.length === 0 ? [newClause(source, span, added)] : longerClause(source, span, added)
}

function headOf({keyword, name, parameters}: DataDeclaration): string {
  return [keyword, name, ...parameters].join(" ")
}

/// On a line of its own below constructors that stand on lines of their own; behind the last constructor where a comment follows it.
function newClause(source: Source, {start, end}: Range, added: readonly string[]): Edit {
  const isOverLines = source.text.slice(start, end).includes("\n") && !source.hasCommentBehind
  const before = isOverLines ? `\n${" ".repeat(Math.max(indentAt(source, end), 2))}` : " "
  return {start: end, end, text: `${before}deriving (${added.join(", ")})`}
}

/// Inside of the only clause, which gets brackets where it has none.
function longerClause(source: Source, span: Range, added: readonly string[]): readonly Edit[] | undefined {
  const text = source.text.slice(span.start, span.end)
  const [clause, ...others] = text.matchAll(/\bderiving\s+(?:\(([^()]*)\)|([\p{L}\p{N}_.']+))(?=\s*$)/gu)
  if (clause === undefined || others.length > 0 || text.split(/\bderiving\b/).length !== 2) return undefined
  const more = added.map(name => `, ${name}`).join("")
  const end = span.start + clause.index + clause[0].length
  const [, , single] = clause
  if (single === undefined) return [{start: end - 1, end: end - 1, text: more}]
  return [{start: end - single.length, end, text: `(${single}${more})`}]
}
