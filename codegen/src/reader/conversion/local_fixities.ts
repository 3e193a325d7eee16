/// Fixities of operators that a definition declares or binds inside itself.

import type {Fixities, Fixity} from "../../haskell/fixity.ts"
import {fixitiesIn, fixitiesInside, isKnownOperator} from "../../haskell/fixity.ts"
import {namesBoundInside} from "../../model/bound_names.ts"
import {everyNode} from "../../model/child_nodes.ts"
import type {Declaration} from "../../model/syntax_tree.ts"
import type {Context} from "./conversion_context.ts"
import type {Syntax} from "./parse_tree.ts"

/// The fixities that are declared inside of a definition; undefined where one is declared twice, or of an operator that is known outside, too: its
/// chains would have different fixities in different places.
export function localFixities(nodes: readonly Syntax[], context: Context): Fixities | undefined {
  const found = new Map<string, Fixity>()
  const outer = new Set(nodes)
  const todo = [...nodes]
  for (let node = todo.pop(); node !== undefined; node = todo.pop()) {
    if (node.type === "fixity" && !outer.has(node))
      for (const [op, fixity] of fixitiesIn(context.of(node))) {
        if (found.has(op) || isKnownOperator(op, context.fixities)) return undefined
        found.set(op, fixity)
      }
    todo.push(...node.children)
  }
  return found
}

/// Whether an operator that the definition binds itself stands beside another operator. Its chains were resolved with the fixity that the
/// name has elsewhere; where the binding is in scope, it is `infixl 9`.
export function hasUnresolvedOperators(d: Declaration, fixities: Fixities, local: Fixities): boolean {
  const bound = [...everyNode(d)].filter(n => n !== d && n.kind === "function" && local.has(n.name))
  if (bound.length > local.size) return true
  const inside = fixitiesInside(
    [...namesBoundInside(d)].filter(name => !local.has(name)),
    fixities,
  )
  if (inside === fixities) return false
  const isOwn = (op: string) => inside.get(op) !== fixities.get(op)
  for (const node of everyNode(d)) {
    if (node.kind !== "infix" && node.kind !== "negate" && node.kind !== "section") continue
    const operands =
      node.kind === "infix" ? [node.left, node.right] : [node.kind === "negate" ? node.expr : node.operand]
    for (const o of operands) {
      if (o.kind !== "infix" && o.kind !== "negate") continue
      if ((node.kind !== "negate" && isOwn(node.op)) || (o.kind === "infix" && isOwn(o.op))) return true
    }
  }
  return false
}
