/// Declarations: from syntax to model. Signatures and equations of one name become one definition, at the top and inside others.

import {isConstructorName, isOperator, isVariableName} from "../haskell/lexemes.ts"
import type {
  Clause,
  Constructor,
  Declaration,
  Expr,
  Guarded,
  Pattern,
  RightSide,
  TypeText,
} from "../model/tree.ts"
import type {Context} from "./context.ts"
import type {Reading} from "./expressions.ts"
import {readExpr, readStatements} from "./expressions.ts"
import type {Range} from "./lexer.ts"
import {readPattern} from "./patterns.ts"
import type {Cause} from "./reasons.ts"
import type {Syntax} from "./syntax.ts"
import {child, childrenIn, hasToken, namedChildren, onlyNamed} from "./syntax.ts"

/// One definition from the declarations that a piece of text holds, or why it is none.
export function readTop(nodes: readonly Syntax[], context: Context): Declaration | Cause {
  const r = readingOf(context)
  const groups = grouped(nodes, context)
  const [only] = groups
  if (only === undefined) return "declaration"
  if (groups.length > 1) return "several"
  const made = readGroup(only, r)
  return context.kept() ?? made
}

function readingOf(context: Context): Reading {
  const r: Reading = {
    context,
    declarations: around => readLocal(around, r),
    right: node => readRight(node, r),
    branch: match => guarded(match, r),
  }
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
function readInner(nodes: readonly Syntax[], start: number, r: Reading): Declaration[] {
  let from = start
  const groups = grouped(nodes, r.context).map(group => ({group, range: over(group)}))
  const told = r.context.takePragmas(
    start,
    groups[groups.length - 1]?.range.end ?? start,
    groups.map(g => g.range),
  )
  const all = [...groups, ...told.map(range => ({group: [], range}))]
  all.sort((a, b) => a.range.start - b.range.start)
  return all.map(({group, range}) => {
    const made = group.length === 0 ? "directive" : readGroup(group, r)
    const remark = r.context.takeComments(from, range.end)
    from = range.end
    if (group[0]?.type === "fixity") r.context.whole ??= "localFixity"
    if (typeof made === "string")
      return r.context.at(range, {
        kind: "raw-declaration",
        ...r.context.exact(range, made),
        ...remark,
      } as const)
    return r.context.at(range, {...made, ...remark})
  })
}

function over(group: readonly Syntax[]): Range {
  return {start: group[0]?.start ?? 0, end: group[group.length - 1]?.end ?? 0}
}

// --- Grouping ----------------------------------------------------------------------------------------------------

/// Consecutive signatures and equations of one name.
function grouped(nodes: readonly Syntax[], context: Context): Syntax[][] {
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
function headOf(node: Syntax, context: Context): Head | undefined {
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
function plainName(node: Syntax, context: Context): string {
  return node.type === "prefix_id" || node.type === "infix_id"
    ? context.of(onlyNamed(node) ?? node)
    : context.of(node)
}

// --- Functions and bindings --------------------------------------------------------------------------------------

const others: {readonly [type: string]: Cause} = {
  deriving_instance: "instance",
  fixity: "fixity",
  type_family: "family",
  type_instance: "family",
  data_family: "family",
  data_instance: "family",
  foreign_import: "foreign",
  foreign_export: "foreign",
}

function readGroup(group: readonly Syntax[], r: Reading): Declaration | Cause {
  const [first] = group
  if (first === undefined) return "declaration"
  switch (first.type) {
    case "data_type":
    case "newtype":
      return data(first, r.context)
    case "type_synomym":
      return synonym(first, r.context)
    case "signature":
      return child(first, "names") !== undefined
        ? "names"
        : group.length === 1
          ? "lonely"
          : definition(group, r)
    case "function":
    case "bind":
      return definition(group, r)
    case "class":
    case "instance":
      return instance(first, r)
    case "top_splice":
      return r.context.of(first).startsWith("$") ? "template" : "broken"
    default:
      return others[first.type] ?? "declaration"
  }
}

/// A class or an instance whose parts are equations and signatures.
function instance(node: Syntax, r: Reading): Declaration | Cause {
  const {context} = r
  const cause = node.type === "class" ? "class" : "instance"
  const body = child(node, "declarations")
  const where = node.children.find(c => c.type === "where")
  const inner = body === undefined ? [] : childrenIn(body, "declaration")
  const plain = ["function", "bind", "signature"]
  if (body !== undefined && (where === undefined || namedChildren(body).some(c => !plain.includes(c.type))))
    return cause
  const head = {start: node.start, end: where?.start ?? node.end}
  return context.at(node, {
    kind: "instance",
    head: context.typeText(head),
    declarations: readInner(inner, where?.end ?? node.end, r),
  })
}

function definition(group: readonly Syntax[], r: Reading): Declaration | Cause {
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
    ...(type === undefined ? {} : {signature: typeOf(type, context)}),
  } as const)
}

function typeOf(node: Syntax, context: Context): TypeText {
  return context.at(node, {kind: "type", text: context.typeText(node)} as const)
}

/// What stands after `=` or `->`: of an equation, or of an alternative.
function readRight(node: Syntax, r: Reading): RightSide {
  const matches = childrenIn(node, "match")
  const [only] = matches
  const bare = only === undefined ? undefined : child(only, "expression")
  const body =
    matches.length === 1 && only !== undefined && bare !== undefined && child(only, "guards") === undefined
      ? readExpr(bare, r)
      : matches.map(m => guarded(m, r))
  return {kind: "right", body, where: r.declarations(node)}
}

function guarded(match: Syntax, r: Reading): Guarded {
  const guards = child(match, "guards")
  const body = child(match, "expression")
  const expr: Expr = body === undefined ? r.context.at(match, {kind: "hole"} as const) : readExpr(body, r)
  return r.context.at(match, {
    kind: "guarded",
    guards: guards === undefined ? [] : readStatements(childrenIn(guards, "guard"), undefined, r),
    body: expr,
  } as const)
}

// --- Types -------------------------------------------------------------------------------------------------------

function data(node: Syntax, context: Context): Declaration | Cause {
  const name = child(node, "name")
  if (name?.type !== "name" || ["context", "forall", "kind"].some(f => child(node, f) !== undefined))
    return "data"
  const parameters = readParameters(node, context)
  if (parameters === undefined) return "data"
  const constructors: Constructor[] = []
  const nodes =
    node.type === "newtype"
      ? childrenIn(node, "constructor")
      : childrenIn(child(node, "constructors") ?? node, "constructor")
  if (child(node, "constructors")?.type === "gadt_constructors") return "data"
  for (const c of nodes) {
    const made = readConstructor(c, context)
    if (typeof made === "string") return made
    constructors.push(made)
  }
  const clauses = childrenIn(node, "deriving")
  const deriving = clauses[0] === undefined ? [] : readDeriving(clauses[0], context)
  if (clauses.length > 1 || deriving === undefined) return "deriving"
  return context.at(node, {
    kind: "data",
    keyword: node.type === "newtype" ? "newtype" : "data",
    name: context.of(name),
    parameters,
    constructors,
    deriving,
  } as const)
}

function readParameters(node: Syntax, context: Context): string[] | undefined {
  const params = child(node, "patterns")
  if (params === undefined) return []
  const all = namedChildren(params)
  return all.every(p => p.type === "variable" && isVariableName(context.of(p)))
    ? all.map(p => context.of(p))
    : undefined
}

function readConstructor(node: Syntax, context: Context): Constructor | Cause {
  if (node.type === "newtype_constructor") {
    const name = child(node, "name")
    const field = child(node, "field")
    if (name === undefined || field === undefined || !isConstructorName(context.of(name))) return "data"
    const fields =
      field.type === "record"
        ? recordFields(childrenIn(field, "field"), context)
        : plainFields(namedChildren(field), context)
    return typeof fields === "string"
      ? fields
      : context.at(node, {kind: "constructor", name: context.of(name), fields} as const)
  }
  const inner = child(node, "constructor")
  const name = inner && child(inner, "name")
  if (
    inner === undefined ||
    name === undefined ||
    child(node, "forall") !== undefined ||
    child(node, "context") !== undefined
  )
    return "data"
  if (!isConstructorName(context.of(name))) return "data"
  const fields =
    inner.type === "prefix"
      ? plainFields(childrenIn(inner, "field"), context)
      : recordFields(childrenIn(child(inner, "fields") ?? inner, "field"), context)
  if (typeof fields === "string") return fields
  // `A {}` differs from `A` only in looks, but it is not ours to change.
  if (inner.type === "record" && fields.length === 0) return "data"
  return context.at(node, {kind: "constructor", name: context.of(name), fields} as const)
}

function plainFields(nodes: readonly Syntax[], context: Context): Constructor["fields"] | Cause {
  if (nodes.some(n => n.type === "strict_field" || n.type === "lazy_field")) return "strict"
  return nodes.map(n => ({type: typeOf(n.type === "parens" ? (onlyNamed(n) ?? n) : n, context)}))
}

function recordFields(nodes: readonly Syntax[], context: Context): Constructor["fields"] | Cause {
  const fields: {name: string; type: TypeText}[] = []
  for (const n of nodes) {
    const type = child(n, "type")
    if (type === undefined || type.type === "strict_field" || type.type === "lazy_field") return "strict"
    for (const name of childrenIn(n, "name")) {
      if (!isVariableName(context.of(name))) return "name"
      fields.push({name: context.of(name), type: typeOf(type, context)})
    }
  }
  return fields
}

function readDeriving(node: Syntax, context: Context): string[] | undefined {
  if (child(node, "strategy") !== undefined || child(node, "via") !== undefined) return undefined
  const classes = child(node, "classes")
  if (classes === undefined) return undefined
  const all = classes.type === "tuple" || classes.type === "parens" ? namedChildren(classes) : [classes]
  return all.every(c => isConstructorName(context.of(c))) ? all.map(c => context.of(c)) : undefined
}

function synonym(node: Syntax, context: Context): Declaration | Cause {
  const name = child(node, "name")
  const type = child(node, "type")
  const parameters = readParameters(node, context)
  if (
    name?.type !== "name" ||
    type === undefined ||
    type.type === "signature" ||
    parameters === undefined ||
    hasToken(node, "instance")
  )
    return "synonym"
  return context.at(node, {kind: "synonym", name: context.of(name), parameters, type: typeOf(type, context)})
}
