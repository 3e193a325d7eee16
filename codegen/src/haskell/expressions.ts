/// Prints expressions and statements, with no more brackets than Haskell's fixities ask for.

import type {Alternative, Declaration, Expr, FieldValue, Guarded, Statement} from "../model/tree.ts"
import {unreachable} from "../model/tree.ts"
import type {Doc} from "./doc.ts"
import {
  align,
  group,
  hardline,
  hasHardline,
  ifBroken,
  indented,
  join,
  line,
  lines,
  mark,
  nest,
  softline,
} from "./doc.ts"
import type {Fixities, Fixity} from "./fixity.ts"
import {fixityOf} from "./fixity.ts"
import {
  characterLiteral,
  constructorWord,
  isConstructorName,
  isConstructorOperator,
  isOperator,
  numberLiteral,
  stringLiteral,
  variableName,
} from "./lexemes.ts"
import {printPattern} from "./patterns.ts"
import {printType} from "./typetext.ts"

/// What the printer needs besides the node; declarations are printed by `print.ts`.
export interface Context {
  readonly fixities: Fixities
  readonly declarations: (ds: readonly Declaration[]) => Doc
  readonly alternative: (a: Alternative) => Doc
  readonly branches: (branches: readonly Guarded[]) => Doc
}

export function printExpr(e: Expr, context: Context): Doc {
  return mark(e, exprBody(e, context))
}

/// Whether the expression starts a block on its line and goes on below: `do`, `case`, `f $ do`.
export function hangs(e: Expr): boolean {
  switch (e.kind) {
    case "do":
      return e.statements.length > 0
    case "case":
    case "lambda-case":
    case "branches":
      return true
    case "infix":
      return e.op === "$" && hangs(e.right)
    case "lambda":
      return e.parameters.length > 0 && hangs(e.body)
    case "let":
      return e.declarations.length === 0 && hangs(e.body)
    default:
      return false
  }
}

function exprBody(e: Expr, context: Context): Doc {
  switch (e.kind) {
    case "variable":
      return variableWord(e.name)
    case "constructor-name":
      return constructorWord(e.name)
    case "number": {
      const {negative, digits} = numberLiteral(e.text)
      return negative ? `-${digits}` : digits
    }
    case "string":
      return stringLiteral(e.value)
    case "character":
      return characterLiteral(e.value)
    case "apply":
      if (e.args.length === 0) return printExpr(e.fn, context)
      return group([atom(e.fn, context, true), nest(e.args.map(a => [line, atom(a, context)]))])
    case "infix":
      return printInfix(e, context)
    case "negate":
      return ["-", tighter(e.expr, 7, context)]
    case "section":
      return printSection(e, context)
    case "lambda":
      if (e.parameters.length === 0) return printExpr(e.body, context)
      return [
        "\\",
        join(
          e.parameters.map(p => printPattern(p, "argument")),
          " ",
        ),
        " ->",
        hangs(e.body) ? [" ", printExpr(e.body, context)] : group(nest([line, printExpr(e.body, context)])),
      ]
    case "if":
      return group([
        "if ",
        hangs(e.condition) ? tighter(e.condition, 0, context) : printExpr(e.condition, context),
        nest([line, "then ", printExpr(e.yes, context), line, "else ", printExpr(e.no, context)]),
      ])
    case "branches":
      return e.branches.length === 0 ? "_" : ["if", context.branches(e.branches)]
    case "case":
      return ["case ", tighter(e.scrutinee, 0, context), " of", alternatives(e.alternatives, context)]
    case "lambda-case":
      return ["\\case", alternatives(e.alternatives, context)]
    case "let":
      if (e.declarations.length === 0) return printExpr(e.body, context)
      return align(
        group([
          "let ",
          align(context.declarations(e.declarations)),
          nest([line, "in ", printExpr(e.body, context)], 1),
        ]),
      )
    case "do":
      if (e.statements.length === 0) return "_"
      return ["do", nest(e.statements.map(s => [hardline, printStatement(s, context)]))]
    case "tuple": {
      const [only] = e.items
      if (e.items.length === 1 && only !== undefined) return ["(", printExpr(only, context), ")"]
      return bracketed("(", e.items, ")", context)
    }
    case "list":
      return bracketed("[", e.items, "]", context)
    case "range":
      return [
        "[",
        // Before `..` a `do` or `if` would not know where it ends.
        tighter(e.first, 0, context),
        e.second === undefined ? "" : [", ", tighter(e.second, 0, context)],
        " ..",
        e.last === undefined ? "" : [" ", printExpr(e.last, context)],
        "]",
      ]
    case "comprehension":
      if (e.statements.length === 0) return ["[", printExpr(e.body, context), "]"]
      return group([
        "[",
        align([
          printExpr(e.body, context),
          line,
          "| ",
          join(
            e.statements.map(s => printStatement(s, context)),
            [",", line],
          ),
        ]),
        "]",
      ])
    case "typed":
      // A type that breaks is indented, or its second line would be a new step of a `do`.
      return group([
        endsOpen(e.expr)
          ? mark(e.expr, ["(", bracketBody(e.expr, context), ")"])
          : tighter(e.expr, 0, context),
        " :: ",
        nest(printType(e.type)),
      ])
    case "record":
      return fieldsDoc(constructorWord(e.name), e.fields, context)
    case "update":
      if (e.fields.length === 0) return printExpr(e.record, context)
      // `f r {x = 1}` changes `r`, so a call is bracketed here; and `C {x = 1}` makes a `C`, so a bare constructor is, too.
      return fieldsDoc(
        transparent(e.record).kind === "constructor-name"
          ? mark(e.record, ["(", exprBody(e.record, context), ")"])
          : atom(e.record, context),
        e.fields,
        context,
      )
    case "hole":
      return "_"
    case "raw":
      return e.text.trim() === "" ? "_" : align(lines(e.text.trim()))
    default:
      return unreachable(e)
  }
}

function alternatives(all: readonly Alternative[], context: Context): Doc {
  return nest(all.length === 0 ? [hardline, "_ -> _"] : all.map(a => [hardline, context.alternative(a)]))
}

/// `f $ do …`: what comes after it would become part of its last line.
function endsOpen(e: Expr): boolean {
  const inner = transparent(e)
  return inner.kind === "infix" && inner.op === "$" && (isOpen(inner.right) || endsOpen(inner.right))
}

export function printStatement(s: Statement, context: Context): Doc {
  return mark(s, [comment(s.comment), statementBody(s, context)])
}

/// A condition of a guard. It ends before `,`, `=` or `->`, so what would read on past them gets brackets.
export function printCondition(s: Statement, sign: string, context: Context): Doc {
  if (s.kind === "let-statement" || !readsOn(s.expr, sign)) return printStatement(s, context)
  const bracketed = mark(s.expr, ["(", bracketBody(s.expr, context), ")"])
  const pattern = s.kind === "bind" ? [printPattern(s.pattern, "top"), " <- "] : []
  return mark(s, [comment(s.comment), ...pattern, bracketed])
}

/// A type reads on past `->`. What goes on below its first line would hide where the condition ends.
function readsOn(e: Expr, sign: string): boolean {
  const inner = transparent(e)
  if (inner.kind === "typed") return sign === "->"
  // The right side of any other operator gets brackets of its own.
  if (inner.kind === "infix") return inner.op === "$" && readsOn(inner.right, sign)
  if (inner.kind === "if") return readsOn(inner.no, sign)
  return isOpen(inner)
}

function comment(text: string | undefined): Doc {
  if (text === undefined || text.trim() === "") return ""
  return text.split("\n").map(l => [l.trim() === "" ? "--" : `-- ${l.trimEnd()}`, hardline])
}

function statementBody(s: Statement, context: Context): Doc {
  switch (s.kind) {
    case "bind":
      return [
        printPattern(s.pattern, "top"),
        " <-",
        hangs(s.expr) ? [" ", printExpr(s.expr, context)] : group(nest([line, printExpr(s.expr, context)])),
      ]
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

function bracketed(open: string, items: readonly Expr[], close: string, context: Context): Doc {
  if (items.length === 0) return open + close
  const docs = items.map(i => align(printExpr(i, context)))
  // A broken tuple or list has one item a line, commas first.
  return group(
    align([open, ifBroken(" "), docs.map((d, i) => (i === 0 ? d : [softline, ", ", d])), softline, close]),
  )
}

function fieldsDoc(head: Doc, fields: readonly FieldValue[], context: Context): Doc {
  const docs = fields.map(({name, value}) =>
    align([
      `${variableName(name)} =`,
      hangs(value) ? [" ", printExpr(value, context)] : group(nest([line, printExpr(value, context)])),
    ]),
  )
  return group([
    head,
    nest([line, "{", ifBroken(" "), docs.map((d, i) => (i === 0 ? d : [softline, ", ", d])), softline, "}"]),
  ])
}

function printInfix(e: Expr & {kind: "infix"}, context: Context): Doc {
  const op = operatorWord(e.op)
  if (e.op === "$" && hangs(e.right))
    return [operand(e.left, e, "left", context), " $ ", printExpr(e.right, context)]
  if (e.op === "$")
    return group([
      operand(e.left, e, "left", context),
      " $",
      nest([line, operand(e.right, e, "right", context)]),
    ])
  return group(nest(chain(e, op, context)))
}

/// A chain of operators of one precedence, as one group: it breaks before all of them or before none.
function chain(e: Expr & {kind: "infix"}, op: string, context: Context): Doc {
  const left = continues(e, e.left, "left", context)
    ? mark(
        e.left,
        chain(e.left as Expr & {kind: "infix"}, operatorWord((e.left as Expr & {kind: "infix"}).op), context),
      )
    : operand(e.left, e, "left", context)
  const right = continues(e, e.right, "right", context)
    ? mark(
        e.right,
        chain(
          e.right as Expr & {kind: "infix"},
          operatorWord((e.right as Expr & {kind: "infix"}).op),
          context,
        ),
      )
    : operand(e.right, e, "right", context)
  return [left, line, op, " ", right]
}

function continues(
  parent: Expr & {kind: "infix"},
  child: Expr,
  side: "left" | "right",
  context: Context,
): boolean {
  if (child.kind !== "infix" || child.op === "$") return false
  const mine = fixityOf(parent.op, context.fixities)
  const theirs = fixityOf(child.op, context.fixities)
  return mine.precedence === theirs.precedence && mine.associates === side && theirs.associates === side
}

/// An operand of `parent`, in brackets where the fixities need them.
function operand(child: Expr, parent: Expr & {kind: "infix"}, side: "left" | "right", context: Context): Doc {
  const mine = fixityOf(parent.op, context.fixities)
  const bare =
    isOperandOf(child, mine, side, context) || (parent.op === "$" && side === "right" && isOpen(child))
  if (bare) return printExpr(child, context)
  const doc = exprBody(child, context)
  // What goes on below its first line stays inside its brackets, or it would look like a part of the whole.
  return mark(child, ["(", hasHardline(doc) ? align(doc) : doc, ")"])
}

function isOperandOf(child: Expr, mine: Fixity, side: "left" | "right", context: Context): boolean {
  const inner = transparent(child)
  const theirs = fixityOfExpr(inner, context)
  if (theirs === "atom") return true
  if (theirs === "open") return false
  if (theirs.precedence !== mine.precedence) return theirs.precedence > mine.precedence
  return mine.associates === side && theirs.associates === side
}

/// Extends as far to the right as it can, so anywhere but at the end it needs brackets.
function isOpen(e: Expr): boolean {
  const inner = transparent(e)
  return (
    ["lambda", "if", "branches", "case", "lambda-case", "let", "do"].includes(inner.kind) &&
    fixityOfExpr(inner, emptyContext) === "open"
  )
}

const emptyContext = {fixities: new Map<string, Fixity>()}

/// Nodes that print exactly as the one inside them.
function transparent(e: Expr): Expr {
  if (e.kind === "apply" && e.args.length === 0) return transparent(e.fn)
  if (e.kind === "lambda" && e.parameters.length === 0) return transparent(e.body)
  if (e.kind === "let" && e.declarations.length === 0) return transparent(e.body)
  if (e.kind === "update" && e.fields.length === 0) return transparent(e.record)
  return e
}

function fixityOfExpr(e: Expr, context: {fixities: Fixities}): Fixity | "atom" | "open" {
  switch (e.kind) {
    case "infix":
      return fixityOf(e.op, context.fixities)
    // The report reads unary minus as an operator of precedence 6 that associates to the left.
    case "negate":
      return {precedence: 6, associates: "left"}
    case "number":
      return numberLiteral(e.text).negative ? {precedence: 6, associates: "left"} : "atom"
    case "apply":
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

/// An expression as a function's argument, or with `head` as the function itself.
function atom(e: Expr, context: Context, head = false): Doc {
  const inner = transparent(e)
  const kind = fixityOfExpr(inner, context)
  const bare = kind === "atom" || (head && inner.kind === "apply")
  return bare ? printExpr(e, context) : mark(e, ["(", bracketBody(e, context), ")"])
}

/// Inside brackets of its own, a block-like expression is aligned so that its lines stay inside.
function bracketBody(e: Expr, context: Context): Doc {
  const doc = exprBody(e, context)
  return hasHardline(doc) && !hangs(e) ? align(doc) : doc
}

/// With what follows on its last line. So `f $ \case …` gets brackets: where its lines end is not to be seen.
function tighter(e: Expr, precedence: number, context: Context): Doc {
  const kind = fixityOfExpr(transparent(e), context)
  const bare = kind === "atom" || (kind !== "open" && kind.precedence >= precedence && !hangs(e))
  if (bare) return printExpr(e, context)
  const doc = exprBody(e, context)
  return mark(e, ["(", e.kind === "infix" && hasHardline(doc) ? align(doc) : doc, ")"])
}

function printSection(e: Expr & {kind: "section"}, context: Context): Doc {
  const op = operatorWord(e.op)
  const mine = fixityOf(e.op, context.fixities)
  const bare = isOperandOf(e.operand, mine, e.side, context)
  const inner = bare
    ? printExpr(e.operand, context)
    : mark(e.operand, ["(", exprBody(e.operand, context), ")"])
  // `(- x)` is a number, not a section. (Haskell 2010 report §3.5)
  if (e.side === "right" && e.op === "-") return ["subtract ", atom(e.operand, context)]
  return e.side === "left" ? ["(", inner, ` ${op})`] : [`(${op} `, inner, ")"]
}

function isSubtract(e: Expr): boolean {
  return e.kind === "section" && e.side === "right" && e.op === "-"
}

function variableWord(name: string): string {
  return isOperator(name) ? `(${name})` : variableName(name)
}

/// An operator between two operands: a symbol, or a name in backticks.
export function operatorWord(op: string): string {
  if (isOperator(op) || isConstructorOperator(op)) return op
  return `\`${isConstructorName(op) ? op : variableName(op)}\``
}
