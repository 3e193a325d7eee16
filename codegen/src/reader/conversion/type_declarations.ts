/// Data types and type synonyms: from syntax to model.

import {isConstructorName, isConstructorOperator, isVariableName} from "../../haskell/lexemes.ts"
import type {Cause} from "../../model/raw_reasons.ts"
import type {Constructor, Declaration, Field, TypeText} from "../../model/syntax_tree.ts"
import type {Context} from "./conversion_context.ts"
import {plainName} from "./equation_groups.ts"
import type {Syntax} from "./parse_tree.ts"
import {child, childrenIn, hasToken, namedChildren, onlyNamed, withoutParens} from "./parse_tree.ts"

export function readType(node: Syntax, context: Context): TypeText {
  return context.at(node, {kind: "type", text: context.typeText(node)} as const)
}

export function readData(node: Syntax, context: Context): Declaration | Cause {
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
        ? readRecordFields(childrenIn(field, "field"), context)
        : readFields(namedChildren(field), context)
    return typeof fields === "string"
      ? fields
      : context.at(node, {kind: "constructor", name: context.of(name), fields} as const)
  }
  const inner = child(node, "constructor")
  if (inner?.type === "infix") return readInfixConstructor(node, inner, context)
  const name = inner && child(inner, "name")
  if (
    inner === undefined ||
    name === undefined ||
    child(node, "forall") !== undefined ||
    child(node, "context") !== undefined
  )
    return "data"
  if (!isConstructorName(plainName(name, context)) && !isConstructorOperator(plainName(name, context)))
    return "data"
  const fields =
    inner.type === "prefix"
      ? readFields(childrenIn(inner, "field"), context)
      : readRecordFields(childrenIn(child(inner, "fields") ?? inner, "field"), context)
  if (typeof fields === "string") return fields
  // `A {}` differs from `A` only in looks, but it is not ours to change.
  if (inner.type === "record" && fields.length === 0) return "data"
  return context.at(node, {kind: "constructor", name: plainName(name, context), fields} as const)
}

/// `a :+: b`
function readInfixConstructor(node: Syntax, inner: Syntax, context: Context): Constructor | Cause {
  const operator = child(inner, "operator")
  const operands = [child(inner, "left_operand"), child(inner, "right_operand")]
  const fields = readFields(
    operands.flatMap(o => o ?? []),
    context,
  )
  if (child(node, "forall") !== undefined || child(node, "context") !== undefined) return "data"
  if (operator === undefined || typeof fields === "string" || fields.length !== 2) return "data"
  const name = plainName(operator, context)
  if (!isConstructorName(name) && !isConstructorOperator(name)) return "data"
  const start = node.end - context.of(node).trimStart().length
  return context.at({start, end: node.end}, {kind: "constructor", name, fields, infix: true} as const)
}

function readFields(nodes: readonly Syntax[], context: Context): Constructor["fields"] | Cause {
  const fields: Field[] = []
  for (const n of nodes) {
    const field = readField(n, context)
    if (typeof field === "string") return field
    fields.push(field)
  }
  return fields
}

/// The type of a field without the `!` before it and the brackets around it.
function readField(node: Syntax, context: Context): Field | Cause {
  const strict = node.type === "strict_field"
  const inner = strict ? onlyNamed(node) : node
  if (inner === undefined || inner.type === "lazy_field" || inner.type === "strict_field") return "strict"
  const type = readType(withoutParens(inner), context)
  return strict ? {type, strict} : {type}
}

function readRecordFields(nodes: readonly Syntax[], context: Context): Constructor["fields"] | Cause {
  const fields: Field[] = []
  for (const n of nodes) {
    const type = child(n, "type")
    for (const name of childrenIn(n, "name")) {
      if (!isVariableName(context.of(name))) return "name"
      // Without `!` a type in brackets keeps them.
      const field =
        type === undefined
          ? "strict"
          : type.type === "strict_field" || type.type === "lazy_field"
            ? readField(type, context)
            : {type: readType(type, context)}
      if (typeof field === "string") return field
      fields.push({name: context.of(name), ...field})
    }
  }
  return fields
}

function readDeriving(node: Syntax, context: Context): string[] | undefined {
  if (child(node, "strategy") !== undefined || child(node, "via") !== undefined) return undefined
  const classes = child(node, "classes")
  if (classes === undefined) return undefined
  const all = classes.type === "tuple" || classes.type === "parens" ? namedChildren(classes) : [classes]
  return all.every(c => isClassUse(context.of(c))) ? all.map(c => context.typeText(c)) : undefined
}

/// A class, perhaps with arguments: `Show`, `MonadState Int`.
function isClassUse(text: string): boolean {
  const [name = "", ...args] = text.split(/\s+/)
  return isConstructorName(name) && (args.length === 0 || !/--|\{-|=>|\bforall\b/.test(text))
}

export function readSynonym(node: Syntax, context: Context): Declaration | Cause {
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
  return context.at(node, {
    kind: "synonym",
    name: context.of(name),
    parameters,
    type: readType(type, context),
  })
}
