/// Declarations: from syntax to model. Signatures and equations of one name become one definition, at the top and inside others.

import {isOperator, isVariableName} from "../../haskell/lexemes.ts"
import type {Cause} from "../../model/raw_reasons.ts"
import type {Clause, Declaration, Expr, Guarded, Pattern, RightSide} from "../../model/syntax_tree.ts"
import type {Context} from "./conversion_context.ts"
import {grouped, headOf, over, plainName} from "./equation_groups.ts"
import {convertExpr, readExpr} from "./expressions.ts"
import {hasUnresolvedOperators, localFixities} from "./local_fixities.ts"
import type {Syntax} from "./parse_tree.ts"
import {child, childrenIn, namedChildren} from "./parse_tree.ts"
import {readPattern} from "./patterns.ts"
import type {Reading} from "./reading.ts"
import {readStatements} from "./statements.ts"
import {readData, readSynonym, readType} from "./type_declarations.ts"

/// One definition from the declarations that a piece of text holds, or why it is none.
export function readTop(nodes: readonly Syntax[], context: Context): Declaration | Cause {
  const local = localFixities(nodes, context)
  if (local === undefined) return "localFixity"
  if (local.size > 0) context.fixities = new Map([...context.fixities, ...local])
  const r = readingOf(context)
  const groups = grouped(nodes, context)
  const [only] = groups
  if (only === undefined) return "declaration"
  if (groups.length > 1) return "several"
  const made = readGroup(only, r)
  const kept = context.kept()
  if (kept !== undefined || typeof made === "string") return kept ?? made
  return hasUnresolvedOperators(made, context.fixities, local) ? "localFixity" : made
}

function readingOf(context: Context): Reading {
  const r: Reading = {
    context,
    expression: node => readExpr(node, r),
    convert: node => convertExpr(node, r),
    declarations: around => readLocal(around, r),
    right: node => readRight(node, r),
    branch: match => readGuarded(match, r),
  }
  context.expression = r.expression
  return r
}

/// The definitions after the `where` or `let` of a node.
function readLocal(around: Syntax, r: Reading): Declaration[] {
  const binds = child(around, "binds")
  if (binds === undefined) return []
  const keyword = around.children.find(c => !c.named && (c.type === "where" || c.type === "let"))
  return readInner(childrenIn(binds, "decl"), keyword?.end ?? binds.start, r)
}

/// Definitions inside of others, each with the comments that stand beside it from a place on.
function readInner(nodes: readonly Syntax[], start: number, r: Reading, isClass = false): Declaration[] {
  let from = start
  const groups = grouped(nodes, r.context).map(group => ({group, range: over(group)}))
  const pragmas = r.context.takePragmas(
    start,
    groups[groups.length - 1]?.range.end ?? start,
    groups.map(g => g.range),
  )
  const all = [...groups, ...pragmas.map(range => ({group: [], range}))]
  all.sort((a, b) => a.range.start - b.range.start)
  return all.map(({group, range}) => {
    const made = group.length === 0 ? "directive" : readGroup(group, r, isClass)
    const remark = r.context.takeComments(from, range.end)
    from = range.end
    if (typeof made === "string")
      return r.context.at(range, {
        kind: "raw-declaration",
        ...r.context.exact(range, made),
        ...remark,
      } as const)
    return r.context.at(range, {...made, ...remark})
  })
}

const others: {readonly [type: string]: Cause} = {
  fixity: "fixity",
  type_family: "family",
  type_instance: "family",
  data_family: "family",
  data_instance: "family",
  foreign_import: "foreign",
  foreign_export: "foreign",
}

function readGroup(group: readonly Syntax[], r: Reading, isClass = false): Declaration | Cause {
  const [first] = group
  if (first === undefined) return "declaration"
  switch (first.type) {
    case "data_type":
    case "newtype":
      return readData(first, r.context)
    case "type_synomym":
      return readSynonym(first, r.context)
    case "signature":
      return child(first, "names") !== undefined
        ? "names"
        : group.length > 1
          ? readDefinition(group, r)
          : isClass
            ? readMethodType(first, r)
            : "lonely"
    case "function":
    case "bind":
      return readDefinition(group, r)
    case "class":
    case "instance":
    case "deriving_instance":
      return readInstance(first, r)
    case "top_splice":
      return isSplice(r.context.of(first), r.context.extensions) ? "template" : "broken"
    default:
      return others[first.type] ?? "declaration"
  }
}

/// Whether an expression at the margin makes declarations: `$(f x)`, with Template Haskell also `f x`, with quasiquotes `[f|x|]`.
function isSplice(text: string, extensions: ReadonlySet<string>): boolean {
  if (text.startsWith("$") || extensions.has("TemplateHaskell")) return true
  return extensions.has("QuasiQuotes") && /^\[[\p{L}_][\p{L}\p{N}_'.]*\|/u.test(text)
}

/// A method of a class that has a type and no equations.
function readMethodType(node: Syntax, r: Reading): Declaration | Cause {
  const nameNode = child(node, "name")
  const type = child(node, "type")
  if (nameNode === undefined || type === undefined) return "lonely"
  const name = plainName(nameNode, r.context)
  if (!isVariableName(name) && !isOperator(name)) return "name"
  return r.context.at(node, {
    kind: "function",
    name,
    clauses: [],
    signature: readType(type, r.context),
  } as const)
}

/// A class or an instance. Parts other than equations and signatures, like types that belong to it, are kept as text.
function readInstance(node: Syntax, r: Reading): Declaration | Cause {
  const {context} = r
  const cause = node.type === "class" ? "class" : "instance"
  const body = child(node, "declarations")
  const where = node.children.find(c => c.type === "where")
  const inner = body === undefined ? [] : childrenIn(body, "declaration")
  if (body !== undefined && (where === undefined || namedChildren(body).some(c => c.field !== "declaration")))
    return cause
  const head = {start: node.start, end: where?.start ?? node.end}
  return context.at(node, {
    kind: "instance",
    head: context.typeText(head),
    declarations: readInner(inner, where?.end ?? node.end, r, node.type === "class"),
  })
}

function readDefinition(group: readonly Syntax[], r: Reading): Declaration | Cause {
  const {context} = r
  const [first, ...rest] = group
  if (first === undefined) return "declaration"
  const signed = first.type === "signature"
  const equations = signed ? rest : group
  const [equation] = equations
  const pattern =
    equation === undefined
      ? undefined
      : (child(equation, "pattern") ??
        equation.children.find(c => c.field === "name" && context.of(c) === "_"))
  if (equation !== undefined && pattern !== undefined) {
    if (pattern.type === "splice") return "template"
    const read = readPattern(pattern, context)
    return context.at(equation, {kind: "binding", pattern: read, right: readRight(equation, r)})
  }
  const clauses: Clause[] = []
  let name = ""
  for (const e of equations) {
    const head = headOf(e, context)
    if (head === undefined) return "declaration"
    name = head.name
    const patterns = head.patterns.map((p): Pattern => readPattern(p, context))
    clauses.push(context.at(e, {kind: "clause", patterns, right: readRight(e, r)} as const))
  }
  // `f @t x`: no pattern, so no brackets may go around it.
  if (clauses.some(c => c.patterns.some(p => p.kind === "raw-pattern" && p.text.startsWith("@"))))
    return "typeApplication"
  if (!isVariableName(name) && !isOperator(name)) return "name"
  if (clauses.some(c => c.patterns.length !== clauses[0]?.patterns.length)) return "arity"
  const type = signed ? child(first, "type") : undefined
  return context.at(over(group), {
    kind: "function",
    name,
    clauses,
    ...(type === undefined ? {} : {signature: readType(type, context)}),
  } as const)
}

/// What stands after `=` or `->`: of an equation, or of an alternative.
function readRight(node: Syntax, r: Reading): RightSide {
  const matches = childrenIn(node, "match")
  const [only] = matches
  const bare = only === undefined ? undefined : child(only, "expression")
  const body =
    matches.length === 1 && only !== undefined && bare !== undefined && child(only, "guards") === undefined
      ? readExpr(bare, r)
      : matches.map(m => readGuarded(m, r))
  return {kind: "right", body, where: r.declarations(node)}
}

function readGuarded(match: Syntax, r: Reading): Guarded {
  const guards = child(match, "guards")
  const body = child(match, "expression")
  const expr: Expr = body === undefined ? r.context.at(match, {kind: "hole"} as const) : readExpr(body, r)
  return r.context.at(match, {
    kind: "guarded",
    guards: guards === undefined ? [] : readStatements(childrenIn(guards, "guard"), undefined, r),
    body: expr,
  } as const)
}
