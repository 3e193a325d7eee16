/// Printer of expressions, with no more brackets than the fixities require (`bracket_rules.ts`).

import type {Alternative, Declaration, Expr, FieldValue, Guarded, Statement} from "../model/syntax_tree.ts"
import {unreachable} from "../model/syntax_tree.ts"
import {
  canHang,
  continues,
  endsOpen,
  fixityOfExpr,
  isOpen,
  isOperandOf,
  readsOn,
  startsWithSymbol,
  transparent,
} from "./bracket_rules.ts"
import type {Fixities} from "./fixity.ts"
import {fixityOf} from "./fixity.ts"
import type {Doc} from "./layout_document.ts"
import {
  align,
  group,
  hardline,
  hasHardline,
  ifBroken,
  join,
  line,
  lines,
  mark,
  nest,
  softline,
} from "./layout_document.ts"
import {
  characterLiteral,
  constructorWord,
  numberLiteral,
  operatorWord,
  stringLiteral,
  variableName,
  variableWord,
} from "./lexemes.ts"
import {printPattern} from "./pattern_printer.ts"
import {atomicType, printType} from "./type_text.ts"

/// What the printer needs besides the node; `printer.ts` prints declarations.
export interface Context {
  readonly fixities: Fixities
  readonly declarations: (ds: readonly Declaration[]) => Doc
  readonly alternative: (a: Alternative) => Doc
  readonly branches: (branches: readonly Guarded[]) => Doc
  readonly statement: (s: Statement) => Doc
  /// An expression before the arrow of a view pattern.
  readonly viewed: (e: Expr) => Doc
}

export function printExpr(e: Expr, context: Context): Doc {
  return mark(e, exprBody(e, context))
}

/// An expression after `=`, `->` or `<-`: on the same line where it starts a block there or fits, else indented below.
export function hung(e: Expr, context: Context): Doc {
  return canHang(e) ? [" ", printExpr(e, context)] : group(nest([line, printExpr(e, context)]))
}

/// An expression before the arrow of a view pattern. What would read on past the arrow gets brackets.
export function printViewed(e: Expr, context: Context): Doc {
  return readsOn(e, "->") ? mark(e, ["(", bracketBody(e, context), ")"]) : printExpr(e, context)
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
    case "type-apply":
      return [atom(e.fn, context, true), " @", atomicType(e.type)]
    case "gap":
      return ""
    case "infix":
      return printInfix(e, context)
    case "negate":
      return ["-", tighter(e.expr, 7, context)]
    case "section":
      return printSection(e, context)
    case "lambda":
      return printLambda(e, context)
    case "if":
      return group([
        "if ",
        canHang(e.condition) ? tighter(e.condition, 0, context) : printExpr(e.condition, context),
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
      return ["do", nest(e.statements.map(s => [hardline, context.statement(s)]))]
    case "tuple": {
      const [only] = e.items
      if (e.items.length === 1 && only !== undefined) return ["(", printExpr(only, context), ")"]
      return bracketed("(", e.items, ")", context)
    }
    case "list":
      return bracketed("[", e.items, "]", context)
    case "range":
      return printRange(e, context)
    case "comprehension":
      return printComprehension(e, context)
    case "typed":
      return printTyped(e, context)
    case "record":
      return fieldsDoc(constructorWord(e.name), e.fields, context, e.rest)
    case "update":
      return printUpdate(e, context)
    case "hole":
      return "_"
    case "raw":
      return e.text.trim() === "" ? "_" : align(lines(e.text.trim()))
    default:
      return unreachable(e)
  }
}

function printLambda(e: Expr & {kind: "lambda"}, context: Context): Doc {
  if (e.parameters.length === 0) return printExpr(e.body, context)
  return [
    startsWithSymbol(e.parameters[0]) ? "\\ " : "\\",
    join(
      e.parameters.map(p => printPattern(p, "argument", context)),
      " ",
    ),
    " ->",
    hung(e.body, context),
  ]
}

function printRange(e: Expr & {kind: "range"}, context: Context): Doc {
  return [
    "[",
    // Before `..` a `do` or `if` would not know where it ends.
    tighter(e.first, 0, context),
    e.second === undefined ? "" : [", ", tighter(e.second, 0, context)],
    " ..",
    e.last === undefined ? "" : [" ", printExpr(e.last, context)],
    "]",
  ]
}

function printComprehension(e: Expr & {kind: "comprehension"}, context: Context): Doc {
  if (e.statements.length === 0) return ["[", printExpr(e.body, context), "]"]
  return group([
    "[",
    align([printExpr(e.body, context), line, "| ", join(e.statements.map(context.statement), [",", line])]),
    "]",
  ])
}

function printTyped(e: Expr & {kind: "typed"}, context: Context): Doc {
  // A type that breaks is indented, or its second line would be a new step of a `do`.
  return group([
    endsOpen(e.expr) ? mark(e.expr, ["(", bracketBody(e.expr, context), ")"]) : tighter(e.expr, 0, context),
    " :: ",
    nest(printType(e.type)),
  ])
}

function printUpdate(e: Expr & {kind: "update"}, context: Context): Doc {
  if (e.fields.length === 0) return printExpr(e.record, context)
  // `f r {x = 1}` changes `r`, so a call is bracketed here; and `C {x = 1}` makes a `C`, so a bare constructor is, too.
  return fieldsDoc(
    transparent(e.record).kind === "constructor-name"
      ? mark(e.record, ["(", exprBody(e.record, context), ")"])
      : atom(e.record, context),
    e.fields,
    context,
  )
}

function alternatives(all: readonly Alternative[], context: Context): Doc {
  return nest(all.length === 0 ? [hardline, "_ -> _"] : all.map(a => [hardline, context.alternative(a)]))
}

function bracketed(open: string, items: readonly Expr[], close: string, context: Context): Doc {
  if (items.length === 0) return open + close
  const docs = items.map(i => align(printExpr(i, context)))
  if (items.some(i => i.kind === "gap")) return [open, join(docs, ","), close]
  // A broken tuple or list has one item a line, commas first.
  return group(
    align([open, ifBroken(" "), docs.map((d, i) => (i === 0 ? d : [softline, ", ", d])), softline, close]),
  )
}

function fieldsDoc(head: Doc, fields: readonly FieldValue[], context: Context, rest?: true): Doc {
  const docs = fields.map(({name, value, pun}) =>
    pun === true && value.kind === "variable" && value.name === name
      ? printExpr(value, context)
      : align([`${variableName(name)} =`, hung(value, context)]),
  )
  if (rest === true) docs.push("..")
  return group([
    head,
    nest([line, "{", ifBroken(" "), docs.map((d, i) => (i === 0 ? d : [softline, ", ", d])), softline, "}"]),
  ])
}

function printInfix(e: Expr & {kind: "infix"}, context: Context): Doc {
  if (e.op === "$" && canHang(e.right))
    return [operand(e.left, e, "left", context), " $ ", printExpr(e.right, context)]
  if (e.op === "$")
    return group([
      operand(e.left, e, "left", context),
      " $",
      nest([line, operand(e.right, e, "right", context)]),
    ])
  return group(nest(chain(e, context)))
}

/// A chain of operators of one precedence, as one group: it breaks before all of them or before none.
function chain(e: Expr & {kind: "infix"}, context: Context): Doc {
  const part = (child: Expr, side: "left" | "right"): Doc =>
    child.kind === "infix" && continues(e, child, side, context)
      ? mark(child, chain(child, context))
      : operand(child, e, side, context)
  return [part(e.left, "left"), line, operatorWord(e.op), " ", part(e.right, "right")]
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

/// An expression as a function's argument, or with `head` as the function itself.
function atom(e: Expr, context: Context, head = false): Doc {
  const inner = transparent(e)
  const kind = fixityOfExpr(inner, context)
  const bare = kind === "atom" || (head && (inner.kind === "apply" || inner.kind === "type-apply"))
  return bare ? printExpr(e, context) : mark(e, ["(", bracketBody(e, context), ")"])
}

/// Inside brackets of its own, a block-like expression is aligned so that its lines stay inside.
export function bracketBody(e: Expr, context: Context): Doc {
  const doc = exprBody(e, context)
  return hasHardline(doc) && !canHang(e) ? align(doc) : doc
}

/// With what follows on its last line. So `f $ \case …` gets brackets: where its lines end is not to be seen.
function tighter(e: Expr, precedence: number, context: Context): Doc {
  const kind = fixityOfExpr(transparent(e), context)
  const bare = kind === "atom" || (kind !== "open" && kind.precedence >= precedence && !canHang(e))
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
