/// Statements: from syntax to model.

import type {Statement} from "../../model/syntax_tree.ts"
import type {Syntax} from "./parse_tree.ts"
import {child, namedChildren} from "./parse_tree.ts"
import {readPattern} from "./patterns.ts"
import type {Reading} from "./reading.ts"
import {rawExpr} from "./reading.ts"

/// Steps take the comments beside them from `start` on; conditions and qualifiers, without one, leave them to the step or definition
/// around them, because they have no block of their own.
export function readStatements(nodes: readonly Syntax[], start: number | undefined, r: Reading): Statement[] {
  let from = start
  return nodes.map(node => {
    const made = readStatement(node, r)
    const remark = from === undefined ? {} : r.context.takeComments(from, node.end)
    if (from !== undefined) from = node.end
    return r.context.at(node, {...made, ...remark})
  })
}

/// Steps of a `do`, conditions of a guard, and qualifiers of a comprehension.
function readStatement(node: Syntax, r: Reading): Statement {
  switch (node.type) {
    case "bind":
    case "generator":
    case "pattern_guard": {
      const pattern = child(node, "pattern") ?? child(node, "name")
      const expr = child(node, "expression")
      if (pattern !== undefined && expr !== undefined)
        return {kind: "bind", pattern: readPattern(pattern, r.context), expr: r.expression(expr)}
      break
    }
    case "let":
      return {kind: "let-statement", declarations: r.declarations(node)}
    case "exp":
    case "boolean": {
      const [expr] = namedChildren(node)
      if (expr !== undefined) return {kind: "statement", expr: r.expression(expr)}
    }
  }
  return {kind: "statement", expr: rawExpr(node, "statement", r)}
}
