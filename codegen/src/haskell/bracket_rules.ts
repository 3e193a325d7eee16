/// Rules that decide where an expression needs brackets, and which expressions go on below their first line.

import type {Expr, Pattern} from "../model/syntax_tree.ts"
import type {Fixities, Fixity} from "./fixity.ts"
import {fixityOf} from "./fixity.ts"
import {numberLiteral} from "./lexemes.ts"

/// Whether a pattern starts with `!` or `~`, which would form an operator with the backslash before it.
export function startsWithSymbol(p: Pattern | undefined): boolean {
  return p?.kind === "strictness-pattern" || (p?.kind === "raw-pattern" && /^[!~]/.test(p.text.trim()))
}

/// Whether the expression starts a block on its line and goes on below: `do`, `case`, `f $ do`.
export function canHang(e: Expr): boolean {
  switch (e.kind) {
    case "do":
      return e.statements.length > 0
    case "case":
    case "lambda-case":
    case "branches":
      return true
    case "infix":
      return e.op === "$" && canHang(e.right)
    case "lambda":
      return e.parameters.length > 0 && canHang(e.body)
    case "let":
      return e.declarations.length === 0 && canHang(e.body)
    default:
      return false
  }
}

/// `f $ do …`: what comes after it would become part of its last line.
export function endsOpen(e: Expr): boolean {
  const inner = transparent(e)
  return inner.kind === "infix" && inner.op === "$" && (isOpen(inner.right) || endsOpen(inner.right))
}

/// A type reads on past `->`. What goes on below its first line would hide where the condition ends.
export function readsOn(e: Expr, sign: string): boolean {
  const inner = transparent(e)
  if (inner.kind === "typed") return sign === "->"
  // The right side of any other operator gets brackets of its own.
  if (inner.kind === "infix") return inner.op === "$" && readsOn(inner.right, sign)
  if (inner.kind === "if") return readsOn(inner.no, sign)
  return isOpen(inner)
}

/// Whether an operand is part of its parent's chain: an operator of the same precedence on the side to which both associate.
export function continues(
  parent: Expr & {kind: "infix"},
  child: Expr & {kind: "infix"},
  side: "left" | "right",
  context: {fixities: Fixities},
): boolean {
  if (child.op === "$") return false
  const mine = fixityOf(parent.op, context.fixities)
  const theirs = fixityOf(child.op, context.fixities)
  return mine.precedence === theirs.precedence && mine.associates === side && theirs.associates === side
}

export function isOperandOf(
  child: Expr,
  mine: Fixity,
  side: "left" | "right",
  context: {fixities: Fixities},
): boolean {
  const inner = transparent(child)
  const theirs = fixityOfExpr(inner, context)
  if (theirs === "atom") return true
  if (theirs === "open") return false
  // An application binds tighter than any operator, also one of unknown fixity.
  if (theirs.precedence > 9) return true
  if (theirs.precedence !== mine.precedence) return theirs.precedence > mine.precedence
  return mine.associates === side && theirs.associates === side
}

/// Extends as far to the right as it can, so anywhere but at the end it needs brackets.
export function isOpen(e: Expr): boolean {
  const inner = transparent(e)
  return (
    ["lambda", "if", "branches", "case", "lambda-case", "let", "do"].includes(inner.kind) &&
    fixityOfExpr(inner, emptyContext) === "open"
  )
}

const emptyContext = {fixities: new Map<string, Fixity>()}

/// Nodes that print exactly as the one inside them.
export function transparent(e: Expr): Expr {
  if (e.kind === "apply" && e.args.length === 0) return transparent(e.fn)
  if (e.kind === "lambda" && e.parameters.length === 0) return transparent(e.body)
  if (e.kind === "let" && e.declarations.length === 0) return transparent(e.body)
  if (e.kind === "update" && e.fields.length === 0) return transparent(e.record)
  return e
}

export function fixityOfExpr(e: Expr, context: {fixities: Fixities}): Fixity | "atom" | "open" {
  switch (e.kind) {
    case "infix":
      return fixityOf(e.op, context.fixities)
    // The report reads unary minus as an operator of precedence 6 that associates to the left.
    case "negate":
      return {precedence: 6, associates: "left"}
    case "number":
      return numberLiteral(e.text).negative ? {precedence: 6, associates: "left"} : "atom"
    case "apply":
    case "type-apply":
      return {precedence: 10, associates: "left"}
    case "lambda":
    case "if":
    case "case":
    case "lambda-case":
    case "let":
    case "typed":
      return "open"
    case "branches":
      return e.branches.length === 0 ? "atom" : "open"
    case "do":
      return e.statements.length === 0 ? "atom" : "open"
    case "raw":
      return isRawAtom(e.text) ? "atom" : "open"
    case "section":
      return isSubtract(e) ? {precedence: 10, associates: "left"} : "atom"
    default:
      return "atom"
  }
}

function isRawAtom(text: string): boolean {
  return /^[\w'.]*$|^"[^"\\]*"$|^\([^()]*\)$|^\[[^[\]]*\]$/.test(text.trim())
}

function isSubtract(e: Expr): boolean {
  return e.kind === "section" && e.side === "right" && e.op === "-"
}
