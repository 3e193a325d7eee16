/// Functions that readers of expressions, statements and declarations share, and expressions that are kept as text.

import type {Cause} from "../../model/raw_reasons.ts"
import type {Declaration, Expr, Guarded, RightSide} from "../../model/syntax_tree.ts"
import type {Range} from "../../source/lexer.ts"
import type {Context} from "./conversion_context.ts"
import type {Syntax} from "./parse_tree.ts"

/// Functions that readers in different files need of each other; `declarations.ts` provides them, so that the files have no import cycle.
export interface Reading {
  readonly context: Context
  readonly expression: (node: Syntax) => Expr
  /// An expression, or why blocks cannot say it.
  readonly convert: (node: Syntax) => Expr | Cause
  readonly declarations: (around: Syntax) => readonly Declaration[]
  readonly right: (node: Syntax) => RightSide
  readonly branch: (match: Syntax) => Guarded
}

export function rawExpr(node: Range, cause: Cause, r: Reading): Expr {
  // The grammar's splices begin with the blank before them.
  const text = r.context.of(node)
  const range = {start: node.start + text.length - text.trimStart().length, end: node.end}
  return r.context.at(range, {kind: "raw", ...r.context.exact(range, cause)} as const)
}
