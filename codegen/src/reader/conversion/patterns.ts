/// Patterns: from syntax to model.

import {
  isConstructorName,
  isConstructorOperator,
  isNumberLiteral,
  isVariableName,
} from "../../haskell/lexemes.ts"
import type {Cause} from "../../model/raw_reasons.ts"
import type {FieldPattern, Pattern} from "../../model/syntax_tree.ts"
import type {Range} from "../../source/lexer.ts"
import type {Context} from "./conversion_context.ts"
import {maximumDepth} from "./conversion_context.ts"
import {readLiteral} from "./literals.ts"
import type {Link} from "./operator_resolution.ts"
import {resolve} from "./operator_resolution.ts"
import type {Syntax} from "./parse_tree.ts"
import {child, childrenIn, onlyNamed} from "./parse_tree.ts"
import {writtenFields} from "./record_fields.ts"

export function readPattern(node: Syntax, context: Context): Pattern {
  const made = make(node, context)
  return typeof made === "string" ? raw(node, made, context) : made
}

/// The grammar's `!x` and `~x` begin with the space before them.
function withoutSpace(found: Range, context: Context): Range {
  return {start: found.end - context.of(found).trimStart().length, end: found.end}
}

function raw(found: Range, cause: Cause, context: Context): Pattern {
  const node = withoutSpace(found, context)
  return context.at(node, {kind: "raw-pattern", ...context.exact(node, cause)} as const)
}

function make(node: Syntax, context: Context): Pattern | Cause {
  if (context.depth >= maximumDepth) return "deep"
  context.depth++
  const made = convert(node, context)
  context.depth--
  return made
}

function convert(node: Syntax, context: Context): Pattern | Cause {
  const text = context.of(node)
  switch (node.type) {
    case "variable":
      if (text === "_") return context.at(node, {kind: "wildcard"})
      return isVariableName(text) ? context.at(node, {kind: "name-pattern", name: text}) : "name"
    case "wildcard":
      return context.at(node, {kind: "wildcard"})
    case "constructor":
    case "qualified":
    case "prefix_id":
    case "unit":
    case "apply":
      return construct(node, context)
    case "literal":
      return literal(node, text, context)
    case "negation": {
      const digits = context.of(child(node, "number") ?? node)
      return isNumberLiteral(digits)
        ? context.at(node, {kind: "number-pattern", text: `-${digits}`})
        : "literal"
    }
    case "parens": {
      const inner = child(node, "pattern")
      if (inner === undefined) return "pattern"
      const made = make(inner, context)
      if (typeof made !== "string") return made
      // What stands by itself gets its brackets from the printer; the others mean something only in theirs.
      const alone = ["bang", "lazy", "puns", "wildcards"].includes(made)
      return raw(alone ? inner : node, made, context)
    }
    case "tuple":
      return context.at(node, {
        kind: "tuple-pattern",
        items: childrenIn(node, "element").map(e => readPattern(e, context)),
      })
    case "list":
      return context.at(node, {
        kind: "list-pattern",
        items: childrenIn(node, "element").map(e => readPattern(e, context)),
      })
    case "infix":
      return infix(node, context)
    case "as": {
      const name = context.of(child(node, "bind") ?? node)
      const inner = child(node, "pattern")
      if (!isVariableName(name)) return "name"
      return inner === undefined
        ? "pattern"
        : context.at(node, {kind: "as-pattern", name, pattern: readPattern(inner, context)})
    }
    case "record":
      return record(node, context)
    case "strict":
    case "irrefutable": {
      const inner = child(node, "pattern")
      if (inner === undefined) return node.type === "strict" ? "bang" : "lazy"
      return context.at(withoutSpace(node, context), {
        kind: "strictness-pattern",
        mark: node.type === "strict" ? "!" : "~",
        pattern: readPattern(inner, context),
      })
    }
    case "view_pattern": {
      const expr = child(node, "expression")
      const inner = child(node, "pattern")
      if (expr === undefined || inner === undefined || context.expression === undefined) return "viewPattern"
      return context.at(node, {
        kind: "view-pattern",
        expr: context.expression(expr),
        pattern: readPattern(inner, context),
      })
    }
    case "signature": {
      const inner = child(node, "pattern")
      const type = child(node, "type")
      if (inner === undefined || type === undefined) return "typedPattern"
      return context.at(node, {
        kind: "typed-pattern",
        pattern: readPattern(inner, context),
        type: context.at(type, {kind: "type", text: context.typeText(type)}),
      })
    }
    default:
      return "pattern"
  }
}

function literal(node: Syntax, text: string, context: Context): Pattern | Cause {
  const value = readLiteral(text)
  if (value === undefined) return "literal"
  return context.at(
    node,
    value.kind === "number"
      ? {kind: "number-pattern", text: value.text}
      : {kind: value.kind === "string" ? "string-pattern" : "character-pattern", value: value.value},
  )
}

/// A constructor with its arguments; applications nest to the left.
function construct(node: Syntax, context: Context): Pattern | Cause {
  const args: Syntax[] = []
  let head = node
  while (head.type === "apply") {
    const argument = child(head, "argument")
    const fn = child(head, "function")
    if (argument === undefined || fn === undefined) return "pattern"
    args.unshift(argument)
    head = fn
  }
  // The grammar takes more inputs than a constructor's: `f (x y) = …`.
  if (args.length > 0 && (head.type === "variable" || head.type === "literal")) context.whole = "broken"
  if (args.some(a => a.type === "explicit_type" || a.type === "type_binder")) return "typeApplication"
  const name = head.type === "prefix_id" ? context.of(onlyNamed(head) ?? head) : context.of(head)
  if (name === "()") return context.at(node, {kind: "constructor-pattern", name, args: []})
  const fits = head.type === "prefix_id" ? isConstructorOperator(name) : isConstructorName(name)
  if (!fits) return head.type === "constructor" ? "name" : "pattern"
  return context.at(node, {kind: "constructor-pattern", name, args: args.map(a => readPattern(a, context))})
}

function infix(node: Syntax, context: Context): Pattern | Cause {
  const links: Link<Pattern>[] = []
  const ranges: Syntax[] = []
  for (let n: Syntax | undefined = node; n !== undefined; ) {
    const isLink: boolean = n.type === "infix"
    const operand = isLink ? child(n, "left_operand") : n
    const operator = isLink ? child(n, "operator") : undefined
    if (operand === undefined) return "pattern"
    links.push({kind: "operand", value: readPattern(operand, context)})
    ranges.push(operand)
    if (operator === undefined) break
    if (links.length > 2 * maximumDepth) return "deep"
    const op =
      operator.type === "infix_id" ? context.of(onlyNamed(operator) ?? operator) : context.of(operator)
    if (!isConstructorOperator(op) && !isConstructorName(op)) return "pattern"
    links.push({kind: "operator", op})
    ranges.push(operator)
    n = child(n, "right_operand")
  }
  const range = (from: number, to: number) => ({
    start: ranges[from]?.start ?? node.start,
    end: ranges[to]?.end ?? node.end,
  })
  return (
    resolve<Pattern>(links, context.fixities, {
      infix: (op, left, right, from, to) =>
        context.at(range(from, to), {kind: "infix-pattern", op, left, right} as const),
      negate: operand => operand,
    }) ?? "operators"
  )
}

function record(node: Syntax, context: Context): Pattern | Cause {
  const name = context.of(child(node, "constructor") ?? node)
  if (!isConstructorName(name)) return "name"
  const written = writtenFields(node, "pattern", context)
  if (typeof written === "string") return written
  const {rest} = written
  const fields = written.fields.map(
    ({name, label, value}): FieldPattern =>
      value === undefined
        ? {name, pattern: context.at(label, {kind: "name-pattern", name}), pun: true}
        : {name, pattern: readPattern(value, context)},
  )
  return context.at(node, {kind: "record-pattern", name, fields, ...(rest ? {rest} : {})})
}
