/// Expressions and statements: from syntax to model.
///
/// The grammar nests every operator chain to the right and every application to the left; here chains get their fixities and
/// applications become flat. Round brackets leave no trace: the printer knows where Haskell needs them.

import {isConstructorName, isConstructorOperator, isOperator, isVariableName} from "../haskell/lexemes.ts"
import type {
  Alternative,
  Declaration,
  Expr,
  FieldValue,
  Guarded,
  RightSide,
  Statement,
} from "../model/tree.ts"
import type {Link} from "./chain.ts"
import {resolve} from "./chain.ts"
import type {Context} from "./context.ts"
import type {Range} from "./lexer.ts"
import {readLiteral} from "./literals.ts"
import {readPattern} from "./patterns.ts"
import type {Cause} from "./reasons.ts"
import type {Syntax} from "./syntax.ts"
import {child, childrenIn, hasToken, namedChildren, onlyNamed, tokensOf} from "./syntax.ts"

/// Definitions inside expressions are read by `declarations.ts`, which hands itself in to keep the files free of cycles.
export interface Reading {
  readonly context: Context
  readonly declarations: (around: Syntax) => readonly Declaration[]
  readonly right: (node: Syntax) => RightSide
  readonly branch: (match: Syntax) => Guarded
}

export function readExpr(node: Syntax, r: Reading): Expr {
  const made = make(node, r)
  return typeof made === "string" ? raw(node, made, r) : made
}

function raw(range: Range, cause: Cause, r: Reading): Expr {
  return r.context.at(range, {kind: "raw", ...r.context.exact(range, cause)} as const)
}

function make(node: Syntax, r: Reading): Expr | Cause {
  const {context} = r
  const text = context.of(node)
  const at = (e: Expr): Expr => context.at(node, e)
  switch (node.type) {
    case "variable":
    case "constructor":
    case "qualified": {
      // See `plainer` in module.ts.
      if (/^\d/.test(text)) return literal(text, at)
      const negated = /^- */.exec(text)?.[0].length ?? 0
      if (negated === 0) return word(text, at)
      const inner = word(text.slice(negated), e =>
        context.at({start: node.start + negated, end: node.end}, e),
      )
      return typeof inner === "string" ? inner : at({kind: "negate", expr: inner})
    }
    case "prefix_id":
      return word(context.of(onlyNamed(node) ?? node), at)
    case "wildcard":
      return at({kind: "hole"})
    case "unit":
      return at({kind: "constructor-name", name: "()"})
    case "prefix_tuple":
      return at({kind: "constructor-name", name: text.replace(/\s/g, "")})
    case "literal":
      return literal(text, at)
    case "parens": {
      const inner = child(node, "expression")
      return inner === undefined ? "expression" : readExpr(inner, r)
    }
    case "apply":
    case "infix":
    case "negation":
    case "projection":
      return chain(node, r)
    case "left_section":
    case "right_section":
      return section(node, r)
    case "lambda":
      return lambda(node, r)
    case "conditional": {
      const [condition, yes, no] = ["if", "then", "else"].map(f => child(node, f))
      if (condition === undefined || yes === undefined || no === undefined) return "expression"
      return at({kind: "if", condition: readExpr(condition, r), yes: readExpr(yes, r), no: readExpr(no, r)})
    }
    case "case":
      return caseOf(node, r)
    case "let_in": {
      const body = child(node, "expression")
      if (body === undefined) return "expression"
      return at({kind: "let", declarations: r.declarations(node), body: readExpr(body, r)})
    }
    case "do": {
      if (!hasToken(node, "do")) return "doVariant"
      const statements = readStatements(childrenIn(node, "statement"), node.start, r)
      // The grammar allows what Haskell does not: no step, or a last one that does nothing.
      if (statements[statements.length - 1]?.kind !== "statement") context.whole = "broken"
      return at({kind: "do", statements})
    }
    case "tuple": {
      const items = childrenIn(node, "element")
      return tokensOf(node, ",") === items.length - 1
        ? at({kind: "tuple", items: items.map(e => readExpr(e, r))})
        : "tupleSection"
    }
    case "list":
      return at({kind: "list", items: childrenIn(node, "element").map(e => readExpr(e, r))})
    case "arithmetic_sequence":
      return range(node, r)
    case "list_comprehension":
      return comprehension(node, r)
    case "signature": {
      const inner = child(node, "expression")
      const type = child(node, "type")
      if (inner === undefined || type === undefined) return "expression"
      return at({
        kind: "typed",
        expr: readExpr(inner, r),
        type: context.at(type, {kind: "type", text: context.typeText(type)}),
      })
    }
    case "record":
      return record(node, r)
    case "lambda_case": {
      const alternatives = alternativesOf(node, r)
      return alternatives === undefined ? "lambdaCase" : at({kind: "lambda-case", alternatives})
    }
    case "lambda_cases":
      return "lambdaCase"
    case "multi_way_if":
      return at({kind: "branches", branches: childrenIn(node, "match").map(r.branch)})
    default:
      return "expression"
  }
}

function word(name: string, at: (e: Expr) => Expr): Expr | Cause {
  if (name === "_") return at({kind: "hole"})
  if (isVariableName(name) || (isOperator(name) && !isConstructorOperator(name)))
    return at({kind: "variable", name})
  if (isConstructorName(name) || isConstructorOperator(name)) return at({kind: "constructor-name", name})
  return "name"
}

function literal(text: string, at: (e: Expr) => Expr): Expr | Cause {
  const value = readLiteral(text)
  return value === undefined ? "literal" : at(value)
}

// --- Applications and operators ----------------------------------------------------------------------------------

/// One link of a chain, with its place. An operand keeps its syntax until it is read.
type Piece = Range &
  (
    | {readonly kind: "minus"}
    | {readonly kind: "operator"; readonly op: string}
    | {readonly kind: "operand"; readonly parts: readonly Syntax[]}
  )

function chain(node: Syntax, r: Reading): Expr | Cause {
  const pieces: Piece[] = []
  const problem = flatten(node, pieces, r)
  if (problem !== undefined) return problem
  const [only] = pieces
  if (pieces.length === 1 && only?.kind === "operand") return application(only.parts, r)
  const links = pieces.map((p): Link<Expr> => {
    if (p.kind !== "operand") return p
    const made = application(p.parts, r)
    return {kind: "operand", value: typeof made === "string" ? raw(p, made, r) : made}
  })
  const over = (from: number, to: number): Range => ({
    start: pieces[from]?.start ?? node.start,
    end: pieces[to]?.end ?? node.end,
  })
  return (
    resolve<Expr>(links, r.context.fixities, {
      infix: (op, left, right, from, to) =>
        r.context.at(over(from, to), {kind: "infix", op, left, right} as const),
      negate: (expr, from, to) =>
        r.context.at(
          over(from, to),
          expr.kind === "number" && !expr.text.startsWith("-")
            ? ({kind: "number", text: `-${expr.text}`} as const)
            : ({kind: "negate", expr} as const),
        ),
    }) ?? "operators"
  )
}

function flatten(node: Syntax, pieces: Piece[], r: Reading): Cause | undefined {
  switch (node.type) {
    case "infix": {
      const left = child(node, "left_operand")
      const operator = child(node, "operator")
      const right = child(node, "right_operand")
      if (left === undefined || operator === undefined || right === undefined) return "expression"
      const op = operatorOf(operator, r)
      if (op === undefined) return "name"
      const problem = flatten(left, pieces, r)
      if (problem !== undefined) return problem
      pieces.push({kind: "operator", op, start: operator.start, end: operator.end})
      return flatten(right, pieces, r)
    }
    case "negation": {
      const inner = child(node, "expression")
      if (inner === undefined) return "expression"
      pieces.push({kind: "minus", start: node.start, end: node.start + 1})
      return flatten(inner, pieces, r)
    }
    case "apply":
    case "projection": {
      const words = wordsOf(node)
      let group: Syntax[] = []
      const push = (): void => {
        const [first] = group
        const last = group[group.length - 1]
        if (first !== undefined && last !== undefined)
          pieces.push({kind: "operand", parts: group, start: first.start, end: last.end})
        group = []
      }
      for (const w of words)
        if (w.type === ".") {
          push()
          pieces.push({kind: "operator", op: ".", start: w.start, end: w.end})
        } else group.push(w)
      push()
      return undefined
    }
    default:
      pieces.push({kind: "operand", parts: [node], start: node.start, end: node.end})
      return undefined
  }
}

/// A function and its arguments. `f.g` without spaces is composition in plain Haskell, and the grammar reads a field access.
function wordsOf(node: Syntax): Syntax[] {
  if (node.type === "apply") {
    const fn = child(node, "function")
    const argument = child(node, "argument")
    return [...(fn === undefined ? [] : wordsOf(fn)), ...(argument === undefined ? [] : wordsOf(argument))]
  }
  if (node.type === "projection") {
    const inner = child(node, "expression")
    const field = child(node, "field")
    const dot = node.children.find(c => c.type === ".") ?? {
      ...node,
      start: (field?.start ?? node.end) - 1,
      end: field?.start ?? node.end,
    }
    const name = field === undefined ? undefined : (onlyNamed(field) ?? field)
    return [
      ...(inner === undefined ? [] : wordsOf(inner)),
      {...dot, type: "."},
      ...(name === undefined ? [] : [name]),
    ]
  }
  return [node]
}

function application(parts: readonly Syntax[], r: Reading): Expr | Cause {
  const [head, ...rest] = parts
  if (head === undefined) return "expression"
  let fn: Expr
  let args = rest
  const types = parts.map(isTypeArgument).lastIndexOf(true)
  if (types > 0) {
    fn = raw({start: head.start, end: parts[types]?.end ?? head.end}, "typeApplication", r)
    args = parts.slice(types + 1)
  } else {
    const made = make(head, r)
    if (typeof made === "string" && args.length === 0) return made
    fn = typeof made === "string" ? raw(head, made, r) : made
  }
  if (args.length === 0) return fn
  const last = args[args.length - 1] ?? head
  // `(f x) y` is `f x y`.
  const [of, before] = fn.kind === "apply" ? [fn.fn, fn.args] : [fn, []]
  return r.context.at({start: head.start, end: last.end}, {
    kind: "apply",
    fn: of,
    args: [...before, ...args.map(a => readExpr(a, r))],
  } as const)
}

function isTypeArgument(node: Syntax): boolean {
  return node.type === "type_application" || node.type === "explicit_type" || node.type === "kind_application"
}

function operatorOf(node: Syntax, r: Reading): string | undefined {
  if (node.type === "infix_id") {
    const name = r.context.of(onlyNamed(node) ?? node)
    return isVariableName(name) || isConstructorName(name) ? name : undefined
  }
  const op = r.context.of(node)
  return isOperator(op) || isConstructorOperator(op) ? op : undefined
}

function section(node: Syntax, r: Reading): Expr | Cause {
  const side = node.type === "left_section" ? "left" : "right"
  const operand = child(node, side === "left" ? "left_operand" : "right_operand")
  const operator =
    child(node, "operator") ?? node.children.find(c => c.named && c !== operand && c.field === undefined)
  if (operand === undefined || operator === undefined) return "expression"
  const op = operatorOf(operator, r)
  return op === undefined
    ? "name"
    : r.context.at(node, {kind: "section", op, side, operand: readExpr(operand, r)})
}

// --- The rest ----------------------------------------------------------------------------------------------------

function lambda(node: Syntax, r: Reading): Expr | Cause {
  const patterns = child(node, "patterns")
  const body = child(node, "expression")
  if (patterns === undefined || body === undefined) return "expression"
  const parameters = namedChildren(patterns).map(p => readPattern(p, r.context))
  return r.context.at(node, {kind: "lambda", parameters, body: readExpr(body, r)})
}

function caseOf(node: Syntax, r: Reading): Expr | Cause {
  const scrutinee = namedChildren(node).find(c => c.field === undefined)
  if (scrutinee === undefined) return "expression"
  const alternatives = alternativesOf(node, r)
  if (alternatives === undefined) return "expression"
  return r.context.at(node, {kind: "case", scrutinee: readExpr(scrutinee, r), alternatives})
}

function alternativesOf(node: Syntax, r: Reading): Alternative[] | undefined {
  const alternatives = child(node, "alternatives")
  const all = alternatives === undefined ? [] : childrenIn(alternatives, "alternative")
  if (all.length === 0) r.context.whole = "broken"
  const read: Alternative[] = []
  for (const a of all) {
    const pattern = child(a, "pattern")
    if (pattern === undefined) return undefined
    read.push(
      r.context.at(a, {
        kind: "alternative",
        pattern: readPattern(pattern, r.context),
        right: r.right(a),
      } as const),
    )
  }
  return read
}

function range(node: Syntax, r: Reading): Expr | Cause {
  const first = child(node, "from")
  const second = child(node, "step")
  const last = child(node, "to")
  if (first === undefined) return "expression"
  return r.context.at(node, {
    kind: "range",
    first: readExpr(first, r),
    ...(second === undefined ? {} : {second: readExpr(second, r)}),
    ...(last === undefined ? {} : {last: readExpr(last, r)}),
  })
}

function comprehension(node: Syntax, r: Reading): Expr | Cause {
  const body = child(node, "expression")
  const [qualifiers, ...others] = childrenIn(node, "qualifiers")
  if (body === undefined || qualifiers === undefined) return "expression"
  if (others.length > 0) return "parallel"
  const all = childrenIn(qualifiers, "qualifier")
  if (all.some(q => !["generator", "let", "boolean"].includes(q.type))) return "parallel"
  const statements = readStatements(all, undefined, r)
  return r.context.at(node, {kind: "comprehension", body: readExpr(body, r), statements})
}

function record(node: Syntax, r: Reading): Expr | Cause {
  const of = child(node, "expression") ?? child(node, "constructor")
  if (of === undefined) return "expression"
  const fields: FieldValue[] = []
  for (const field of childrenIn(node, "field")) {
    const name = child(field, "field")
    const value = child(field, "expression")
    if (name === undefined) return "wildcards"
    if (value === undefined) return "puns"
    if (name.type === "field_path" || !isVariableName(r.context.of(name))) return "name"
    fields.push({name: r.context.of(name), value: readExpr(value, r)})
  }
  const made = r.context.of(of)
  if (isConstructorName(made)) return r.context.at(node, {kind: "record", name: made, fields})
  return fields.length === 0
    ? "expression"
    : r.context.at(node, {kind: "update", record: readExpr(of, r), fields})
}

// --- Statements --------------------------------------------------------------------------------------------------

/// Steps take the comments beside them from `start` on; conditions and qualifiers, without one, leave them to the step or definition
/// around them, because they have no block of their own.
export function readStatements(nodes: readonly Syntax[], start: number | undefined, r: Reading): Statement[] {
  let from = start
  return nodes.map(node => {
    const made = statement(node, r)
    const remark = from === undefined ? {} : r.context.takeComments(from, node.end)
    if (from !== undefined) from = node.end
    return r.context.at(node, {...made, ...remark})
  })
}

/// Steps of a `do`, conditions of a guard, and qualifiers of a comprehension.
function statement(node: Syntax, r: Reading): Statement {
  switch (node.type) {
    case "bind":
    case "generator":
    case "pattern_guard": {
      const pattern = child(node, "pattern") ?? child(node, "name")
      const expr = child(node, "expression")
      if (pattern !== undefined && expr !== undefined)
        return {kind: "bind", pattern: readPattern(pattern, r.context), expr: readExpr(expr, r)}
      break
    }
    case "let":
      return {kind: "let-statement", declarations: r.declarations(node)}
    case "exp":
    case "boolean": {
      const [expr] = namedChildren(node)
      if (expr !== undefined) return {kind: "statement", expr: readExpr(expr, r)}
    }
  }
  return {kind: "statement", expr: raw(node, "statement", r)}
}
