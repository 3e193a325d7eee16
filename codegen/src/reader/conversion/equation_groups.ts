/// Groups of signatures and equations of one name in the syntax tree, and the heads of equations.

import type {Range} from "../../source/lexer.ts"
import type {Context} from "./conversion_context.ts"
import type {Syntax} from "./parse_tree.ts"
import {child, namedChildren, onlyNamed} from "./parse_tree.ts"

export function over(group: readonly Syntax[]): Range {
  return {start: group[0]?.start ?? 0, end: group[group.length - 1]?.end ?? 0}
}

/// Consecutive signatures and equations of one name.
export function grouped(nodes: readonly Syntax[], context: Context): Syntax[][] {
  const groups: {name: string | undefined; nodes: Syntax[]}[] = []
  for (const node of nodes) {
    const name = nameOf(node, context)
    const last = groups[groups.length - 1]
    if (name !== undefined && last?.name === name && node.type !== "signature") last.nodes.push(node)
    else groups.push({name, nodes: [node]})
  }
  return groups.map(g => g.nodes)
}

function nameOf(node: Syntax, context: Context): string | undefined {
  if (node.type === "signature") {
    const name = child(node, "name")
    return name === undefined ? undefined : plainName(name, context)
  }
  const name = headOf(node, context)?.name
  return name === "_" ? undefined : name
}

interface Head {
  readonly name: string
  readonly patterns: readonly Syntax[]
}

/// `f x y`, ``x `f` y``, `(x <+> y) z`, or just `c`.
export function headOf(node: Syntax, context: Context): Head | undefined {
  if (node.type !== "function" && node.type !== "bind" && node.type !== "function_head_parens")
    return undefined
  const more = child(node, "patterns")
  const patterns = more === undefined ? [] : namedChildren(more)
  const name = child(node, "name")
  if (name !== undefined) return {name: plainName(name, context), patterns}
  const parens = child(node, "parens")
  if (parens !== undefined) {
    const inner = headOf(parens, context)
    return inner && {name: inner.name, patterns: [...inner.patterns, ...patterns]}
  }
  const infix = node.children.find(c => c.type === "infix" && c.field === undefined)
  const left = infix && child(infix, "left_operand")
  const operator = infix && child(infix, "operator")
  const right = infix && child(infix, "right_operand")
  if (left === undefined || operator === undefined || right === undefined) return undefined
  return {name: plainName(operator, context), patterns: [left, right, ...patterns]}
}

/// Without the brackets or backticks around it.
export function plainName(node: Syntax, context: Context): string {
  return node.type === "prefix_id" || node.type === "infix_id"
    ? context.of(onlyNamed(node) ?? node)
    : context.of(node)
}
