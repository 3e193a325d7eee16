/// Printer of statements: steps of a `do`, qualifiers, and conditions of a guard; and of the comments above a node.

import type {Expr, Statement} from "../model/syntax_tree.ts"
import {unreachable} from "../model/syntax_tree.ts"
import {readsOn} from "./bracket_rules.ts"
import type {Context} from "./expression_printer.ts"
import {bracketBody, hung, printExpr} from "./expression_printer.ts"
import type {Doc} from "./layout_document.ts"
import {align, hardline, indented, mark} from "./layout_document.ts"
import {printPattern} from "./pattern_printer.ts"

export function printStatement(s: Statement, context: Context): Doc {
  return mark(s, [comment(s.comment), statementBody(s, context)])
}

/// A condition of a guard. It ends before `,`, `=` or `->`, so what would read on past them gets brackets.
export function printCondition(s: Statement, sign: string, context: Context): Doc {
  if (s.kind === "let-statement" || !readsOn(s.expr, sign)) return printStatement(s, context)
  const bracketed = mark(s.expr, ["(", bracketBody(s.expr, context), ")"])
  const pattern = s.kind === "bind" ? [printPattern(s.pattern, "top", context), " <- "] : []
  return mark(s, [comment(s.comment), ...pattern, bracketed])
}

/// Lines above a node. A line that starts with a symbol would otherwise read as an operator after `--`.
export function comment(text: string | undefined): Doc {
  if (text === undefined || text.trim() === "") return ""
  return text.split("\n").map(l => [l.trim() === "" ? "--" : `-- ${l.trimEnd()}`, hardline])
}

function statementBody(s: Statement, context: Context): Doc {
  switch (s.kind) {
    case "bind":
      return [printPattern(s.pattern, "top", context), " <-", hung(s.expr, context)]
    case "let-statement":
      return s.declarations.length === 0
        ? "let _ = ()"
        : ["let ", align(context.declarations(s.declarations))]
    case "statement":
      // A `let … in` here would be read as a statement followed by a stray `in`; a line that starts below a list, as the next statement.
      return startsWithLet(s.expr)
        ? ["(", printExpr(s.expr, context), ")"]
        : startsWithList(s.expr)
          ? indented(printExpr(s.expr, context))
          : printExpr(s.expr, context)
    default:
      return unreachable(s)
  }
}

function startsWithList(e: Expr): boolean {
  switch (e.kind) {
    case "list":
    case "tuple":
      return true
    case "infix":
      return startsWithList(e.left)
    case "apply":
      return startsWithList(e.fn)
    case "typed":
      return startsWithList(e.expr)
    case "update":
      return startsWithList(e.record)
    default:
      return false
  }
}

function startsWithLet(e: Expr): boolean {
  return e.kind === "let" && e.declarations.length > 0
}
