/// Prints a program model as Haskell source.
///
/// Pure and total: any tree prints, and the same tree prints the same text. Beside the text it returns the span that each
/// node ended up in, so that a compiler message finds its way back to a block. Expressions and patterns have files of their own;
/// here are declarations, and what a whole program is.

import type {PrintedProgram} from "../api.ts"
import {namesBoundInside, namesDefinedBy, textsInside} from "../model/bound_names.ts"
import type {
  Alternative,
  Clause,
  Declaration,
  Expr,
  Guarded,
  Node,
  Pattern,
  Program,
  RightSide,
  TypeText,
} from "../model/syntax_tree.ts"
import {unreachable} from "../model/syntax_tree.ts"
import {printData} from "./data_printer.ts"
import type {Context} from "./expression_printer.ts"
import {hung, printExpr, printViewed} from "./expression_printer.ts"
import type {Fixity} from "./fixity.ts"
import {fixitiesIn, fixitiesInside, redefinedOperators} from "./fixity.ts"
import type {Doc} from "./layout_document.ts"
import {align, group, hardline, join, layout, line, lines, mark, nest} from "./layout_document.ts"
import {constructorName, isOperator, variableName} from "./lexemes.ts"
import {printPattern} from "./pattern_printer.ts"
import {comment, printCondition, printStatement} from "./statement_printer.ts"
import {printType} from "./type_text.ts"

/// Columns; Haskell style guides agree on it.
const width = 80

/// The whole program, with a span per node.
export function printProgram(
  program: Program,
  imported: ReadonlyMap<string, Fixity> = new Map(),
): PrintedProgram & {readonly nodes: ReadonlyMap<object, {start: number; end: number}>} {
  const context = contextOf(program, imported)
  const body = join(
    program.declarations.map(d => printDeclaration(d, contextInside(d, context))),
    [hardline, hardline],
  )
  const {text, marks} = layout(
    mark(program, program.declarations.length === 0 ? "" : [body, hardline]),
    width,
  )
  const nodes = new Map(marks.map(m => [m.key, {start: m.start, end: m.end}]))
  const spans = marks.map(({key, start, end}) => {
    const from =
      (key as Node).kind === "program" ? undefined : (key as {from?: {block: string; input?: string}}).from
    return {start, end, block: from?.block, input: from?.input}
  })
  return {text, spans, nodes}
}

/// One declaration on its own, without a newline at its end.
export function printDeclarationAlone(
  declaration: Declaration,
  fixities: ReadonlyMap<string, Fixity> = new Map(),
): string {
  return layout(printDeclaration(declaration, contextInside(declaration, makeContext(fixities))), width).text
}

/// An expression or a pattern on its own, as the text of a raw block.
export function printExprAlone(e: Expr): string {
  return layout(printExpr(e, makeContext(new Map())), width).text
}

export function printPatternAlone(p: Pattern): string {
  return layout(printPattern(p, "top", makeContext(new Map())), width).text
}

function contextOf(program: Program, imported: ReadonlyMap<string, Fixity>): Context {
  const own = new Map<string, Fixity>()
  for (const d of program.declarations)
    if (d.kind === "raw-declaration") for (const [op, fixity] of fixitiesIn(d.text)) own.set(op, fixity)
  return makeContext(
    new Map([...imported, ...redefinedOperators(program.declarations.flatMap(namesDefinedBy), own), ...own]),
  )
}

/// The context for a top-level declaration, whose parameters and local definitions may bind operators.
function contextInside(d: Declaration, context: Context): Context {
  const local = new Map(textsInside(d).flatMap(text => [...fixitiesIn(text)]))
  const fixities = fixitiesInside(namesBoundInside(d), context.fixities, local)
  return fixities === context.fixities ? context : makeContext(fixities)
}

function makeContext(fixities: ReadonlyMap<string, Fixity>): Context {
  const context: Context = {
    fixities,
    declarations: ds =>
      join(
        ds.map(d => printDeclaration(d, context)),
        hardline,
      ),
    alternative: a => printAlternative(a, context),
    branches: all => printBranches(all, "->", context),
    statement: s => printStatement(s, context),
    viewed: e => printViewed(e, context),
  }
  return context
}

function printDeclaration(d: Declaration, context: Context): Doc {
  return mark(d, [comment(d.comment), declarationBody(d, context)])
}

function declarationBody(d: Declaration, context: Context): Doc {
  switch (d.kind) {
    case "function": {
      const name = isOperator(d.name) ? `(${d.name})` : variableName(d.name)
      const signature = d.signature === undefined ? [] : [signatureLine(name, d.signature)]
      const clauses = d.clauses.map(c => printClause(d.name, c, context))
      const parts = [...signature, ...clauses]
      return join(parts.length === 0 ? [`${name} = _`] : parts, hardline)
    }
    case "binding":
      return [printPattern(d.pattern, "top", context), printRight(d.right, "=", context)]
    case "data":
      return printData(d)
    case "synonym":
      return group([
        ["type ", join([constructorName(d.name), ...d.parameters.map(variableName)], " "), " ="],
        nest([line, printType(d.type)]),
      ])
    case "instance":
      return d.declarations.length === 0
        ? d.head
        : [d.head, " where", nest([hardline, context.declarations(d.declarations)])]
    case "raw-declaration":
      return lines(d.text.trim() === "" ? "-- (nothing yet)" : d.text)
    default:
      return unreachable(d)
  }
}

function signatureLine(name: string, type: TypeText): Doc {
  return group([name, nest([" ::", line, printType(type)])])
}

function printClause(name: string, clause: Clause, context: Context): Doc {
  const patterns = clause.patterns
  const [left, right] = patterns
  const head =
    isOperator(name) && patterns.length === 2 && left !== undefined && right !== undefined
      ? [printPattern(left, "operand", context), ` ${name} `, printPattern(right, "operand", context)]
      : // Inputs that are too long for a line stand below each other, further in than what the function is.
        group([
          isOperator(name) ? `(${name})` : variableName(name),
          nest(
            patterns.map(p => [line, printPattern(p, "argument", context)]),
            4,
          ),
        ])
  return mark(clause, [comment(clause.comment), head, printRight(clause.right, "=", context)])
}

function printAlternative(alternative: Alternative, context: Context): Doc {
  return mark(alternative, [
    comment(alternative.comment),
    printPattern(alternative.pattern, "top", context),
    printRight(alternative.right, "->", context),
  ])
}

function printRight(right: RightSide, sign: "=" | "->", context: Context): Doc {
  return [printBody(right, sign, context), printWhere(right.where, context)]
}

function printBody(right: RightSide, sign: string, context: Context): Doc {
  const body = right.body
  if (isGuards(body)) {
    if (body.length === 0) return ` ${sign} _`
    return printBranches(body, sign, context)
  }
  return [` ${sign}`, hung(body, context)]
}

function printBranches(branches: readonly Guarded[], sign: string, context: Context): Doc {
  return nest(
    branches.map(g => [
      hardline,
      mark(g, [
        "| ",
        g.guards.length === 0
          ? "otherwise"
          : group(
              align(
                join(
                  g.guards.map(s => printCondition(s, sign, context)),
                  [",", line],
                ),
              ),
            ),
        ` ${sign}`,
        hung(g.body, context),
      ]),
    ]),
  )
}

function isGuards(body: RightSide["body"]): body is Exclude<RightSide["body"], {readonly kind: string}> {
  return Array.isArray(body)
}

function printWhere(where: readonly Declaration[], context: Context): Doc {
  if (where.length === 0) return ""
  return nest([hardline, "where", nest([hardline, context.declarations(where)])])
}
