/// A node's direct parts, in reading order.

import type {Declaration, Expr, Node, Pattern, RightSide} from "./syntax_tree.ts"
import {unreachable} from "./syntax_tree.ts"

export function childrenOf(node: Node): readonly Node[] {
  switch (node.kind) {
    case "program":
      return node.declarations
    case "function":
      return [...(node.signature === undefined ? [] : [node.signature]), ...node.clauses]
    case "clause":
      return [...node.patterns, ...rightParts(node.right)]
    case "guarded":
      return [...node.guards, node.body]
    case "binding":
      return [node.pattern, ...rightParts(node.right)]
    case "data":
      return node.constructors
    case "constructor":
      return node.fields.map(f => f.type)
    case "synonym":
      return [node.type]
    case "instance":
      return node.declarations
    case "alternative":
      return [node.pattern, ...rightParts(node.right)]
    case "bind":
      return [node.pattern, node.expr]
    case "let-statement":
      return node.declarations
    case "statement":
      return [node.expr]
    case "raw-declaration":
    case "type":
      return []
    default:
      return expressionParts(node)
  }
}

function expressionParts(node: Expr | Pattern): readonly Node[] {
  switch (node.kind) {
    case "apply":
      return [node.fn, ...node.args]
    case "infix":
      return [node.left, node.right]
    case "negate":
      return [node.expr]
    case "section":
      return [node.operand]
    case "lambda":
      return [...node.parameters, node.body]
    case "if":
      return [node.condition, node.yes, node.no]
    case "branches":
      return node.branches
    case "lambda-case":
      return node.alternatives
    case "case":
      return [node.scrutinee, ...node.alternatives]
    case "let":
      return [...node.declarations, node.body]
    case "do":
      return node.statements
    case "tuple":
    case "list":
      return node.items
    case "range":
      return [
        node.first,
        ...(node.second === undefined ? [] : [node.second]),
        ...(node.last === undefined ? [] : [node.last]),
      ]
    case "comprehension":
      return [node.body, ...node.statements]
    case "typed":
      return [node.expr, node.type]
    case "type-apply":
      return [node.fn, node.type]
    case "record":
      return node.fields.map(f => f.value)
    case "update":
      return [node.record, ...node.fields.map(f => f.value)]
    case "variable":
    case "constructor-name":
    case "number":
    case "string":
    case "character":
    case "hole":
    case "gap":
    case "raw":
      return []
    default:
      return patternParts(node)
  }
}

function patternParts(node: Pattern): readonly Node[] {
  switch (node.kind) {
    case "tuple-pattern":
    case "list-pattern":
      return node.items
    case "constructor-pattern":
      return node.args
    case "infix-pattern":
      return [node.left, node.right]
    case "as-pattern":
    case "strictness-pattern":
      return [node.pattern]
    case "record-pattern":
      return node.fields.map(f => f.pattern)
    case "view-pattern":
      return [node.expr, node.pattern]
    case "typed-pattern":
      return [node.pattern, node.type]
    case "name-pattern":
    case "wildcard":
    case "number-pattern":
    case "string-pattern":
    case "character-pattern":
    case "raw-pattern":
      return []
    default:
      return unreachable(node)
  }
}

function rightParts(right: RightSide): readonly Node[] {
  const body: readonly Node[] = Array.isArray(right.body) ? right.body : [right.body as Node]
  const where: readonly Declaration[] = right.where
  return [...body, ...where]
}

/// A node and everything in it, parents first. Iterative: a chain of operators may be many thousand nodes deep.
export function* everyNode(node: Node): Generator<Node> {
  const ahead: Node[] = [node]
  for (let next = ahead.pop(); next !== undefined; next = ahead.pop()) {
    yield next
    for (const child of childrenOf(next).toReversed()) ahead.push(child)
  }
}
