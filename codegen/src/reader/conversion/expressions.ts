/// Expressions: from syntax to model. Round brackets leave no trace: the printer knows where Haskell needs them.

import {
  isConstructorName,
  isConstructorOperator,
  isOperatorUse,
  isVariableName,
} from "../../haskell/lexemes.ts"
import type {Cause} from "../../model/raw_reasons.ts"
import type {Alternative, Expr, FieldValue} from "../../model/syntax_tree.ts"
import {readChain, readSection, readTupleItems} from "./applications.ts"
import {maximumDepth} from "./conversion_context.ts"
import {readLiteral} from "./literals.ts"
import type {Syntax} from "./parse_tree.ts"
import {child, childrenIn, hasToken, namedChildren, onlyNamed} from "./parse_tree.ts"
import {readPattern} from "./patterns.ts"
import type {Reading} from "./reading.ts"
import {rawExpr} from "./reading.ts"
import {writtenFields} from "./record_fields.ts"
import {readStatements} from "./statements.ts"

export function readExpr(node: Syntax, r: Reading): Expr {
  const made = convertExpr(node, r)
  return typeof made === "string" ? rawExpr(node, made, r) : made
}

export function convertExpr(node: Syntax, r: Reading): Expr | Cause {
  const {context} = r
  if (context.depth >= maximumDepth) return "deep"
  context.depth++
  const made = convert(node, r)
  context.depth--
  return made
}

function convert(node: Syntax, r: Reading): Expr | Cause {
  const {context} = r
  const text = context.of(node)
  const at = (e: Expr): Expr => context.at(node, e)
  switch (node.type) {
    case "variable":
    case "constructor":
    case "qualified": {
      const mask = context.maskAt(node)
      if (mask !== undefined) return rawExpr(mask, "broken", r)
      // See `source_rewriting.ts`.
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
      return readChain(node, r)
    case "left_section":
    case "right_section":
      return readSection(node, r)
    case "lambda":
      return readLambda(node, r)
    case "conditional":
      return readConditional(node, r)
    case "case":
      return readCase(node, r)
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
    case "tuple":
      return at({kind: "tuple", items: readTupleItems(node, r)})
    case "list":
      return at({kind: "list", items: childrenIn(node, "element").map(e => readExpr(e, r))})
    case "arithmetic_sequence":
      return readRange(node, r)
    case "list_comprehension":
      return readComprehension(node, r)
    case "signature":
      return readTyped(node, r)
    case "record":
      return readRecord(node, r)
    case "lambda_case": {
      const alternatives = readAlternatives(node, r)
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

function readConditional(node: Syntax, r: Reading): Expr | Cause {
  const [condition, yes, no] = ["if", "then", "else"].map(f => child(node, f))
  if (condition === undefined || yes === undefined || no === undefined) return "expression"
  return r.context.at(node, {
    kind: "if",
    condition: readExpr(condition, r),
    yes: readExpr(yes, r),
    no: readExpr(no, r),
  })
}

function readTyped(node: Syntax, r: Reading): Expr | Cause {
  const {context} = r
  const inner = child(node, "expression")
  const type = child(node, "type")
  if (inner === undefined || type === undefined) return "expression"
  return context.at(node, {
    kind: "typed",
    expr: readExpr(inner, r),
    type: context.at(type, {kind: "type", text: context.typeText(type)}),
  })
}

function word(name: string, at: (e: Expr) => Expr): Expr | Cause {
  if (name === "_") return at({kind: "hole"})
  if (isVariableName(name) || (isOperatorUse(name) && !isConstructorOperator(name)))
    return at({kind: "variable", name})
  if (isConstructorName(name) || isConstructorOperator(name)) return at({kind: "constructor-name", name})
  return "name"
}

function literal(text: string, at: (e: Expr) => Expr): Expr | Cause {
  const value = readLiteral(text)
  return value === undefined ? "literal" : at(value)
}

function readLambda(node: Syntax, r: Reading): Expr | Cause {
  const patterns = child(node, "patterns")
  const body = child(node, "expression")
  if (patterns === undefined || body === undefined) return "expression"
  const parameters = namedChildren(patterns).map(p => readPattern(p, r.context))
  return r.context.at(node, {kind: "lambda", parameters, body: readExpr(body, r)})
}

function readCase(node: Syntax, r: Reading): Expr | Cause {
  const scrutinee = namedChildren(node).find(c => c.field === undefined)
  if (scrutinee === undefined) return "expression"
  const alternatives = readAlternatives(node, r)
  if (alternatives === undefined) return "expression"
  return r.context.at(node, {kind: "case", scrutinee: readExpr(scrutinee, r), alternatives})
}

function readAlternatives(node: Syntax, r: Reading): Alternative[] | undefined {
  const alternatives = child(node, "alternatives")
  const all = alternatives === undefined ? [] : childrenIn(alternatives, "alternative")
  if (all.length === 0) {
    // Without alternatives only in braces (EmptyCase); blocks have at least one.
    if (!/\{\s*\}$/.test(r.context.of(node))) r.context.whole = "broken"
    return undefined
  }
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

function readRange(node: Syntax, r: Reading): Expr | Cause {
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

function readComprehension(node: Syntax, r: Reading): Expr | Cause {
  const body = child(node, "expression")
  const [qualifiers, ...others] = childrenIn(node, "qualifiers")
  if (body === undefined || qualifiers === undefined) return "expression"
  if (others.length > 0) return "parallel"
  const all = childrenIn(qualifiers, "qualifier")
  if (all.some(q => !["generator", "let", "boolean"].includes(q.type))) return "parallel"
  const statements = readStatements(all, undefined, r)
  return r.context.at(node, {kind: "comprehension", body: readExpr(body, r), statements})
}

function readRecord(node: Syntax, r: Reading): Expr | Cause {
  const of = child(node, "expression") ?? child(node, "constructor")
  if (of === undefined) return "expression"
  const written = writtenFields(node, "expression", r.context)
  if (typeof written === "string") return written
  const {rest} = written
  const fields = written.fields.map(
    ({name, label, value}): FieldValue =>
      value === undefined
        ? {name, value: r.context.at(label, {kind: "variable", name}), pun: true}
        : {name, value: readExpr(value, r)},
  )
  const made = r.context.of(of)
  if (isConstructorName(made))
    return r.context.at(node, {kind: "record", name: made, fields, ...(rest ? {rest} : {})})
  return fields.length === 0 || rest
    ? "expression"
    : r.context.at(node, {kind: "update", record: readExpr(of, r), fields})
}
