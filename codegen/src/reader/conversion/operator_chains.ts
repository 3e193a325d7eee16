/// Flat chains of operators and applications in the syntax tree.
///
/// The grammar nests every operator chain to the right and every application to the left.

import {isConstructorName, isOperatorUse, isVariableName} from "../../haskell/lexemes.ts"
import type {Cause} from "../../model/raw_reasons.ts"
import type {Range} from "../../source/lexer.ts"
import type {Context} from "./conversion_context.ts"
import type {Syntax} from "./parse_tree.ts"
import {child, onlyNamed} from "./parse_tree.ts"

/// One link of a chain, with its place. An operand keeps its syntax until it is read.
export type Piece = Range &
  (
    | {readonly kind: "minus"}
    | {readonly kind: "operator"; readonly op: string}
    | {readonly kind: "operand"; readonly parts: readonly Syntax[]}
  )

export function flatten(whole: Syntax, pieces: Piece[], context: Context): Cause | undefined {
  let node = whole
  // The grammar nests chains to the right.
  for (;;) {
    const rest = flattenFirst(node, pieces, context)
    if (rest === undefined || typeof rest === "string") return rest
    node = rest
  }
}

/// Appends the first operand and operator of a chain; answers what follows them.
function flattenFirst(node: Syntax, pieces: Piece[], context: Context): Cause | Syntax | undefined {
  switch (node.type) {
    case "infix": {
      const left = child(node, "left_operand")
      const operator = child(node, "operator")
      const right = child(node, "right_operand")
      if (left === undefined || operator === undefined || right === undefined) return "expression"
      const op = operatorOf(operator, context)
      if (op === undefined) return "name"
      const problem = flatten(left, pieces, context)
      if (problem !== undefined) return problem
      pieces.push({kind: "operator", op, start: operator.start, end: operator.end})
      return right
    }
    case "negation": {
      const inner = child(node, "expression")
      if (inner === undefined) return "expression"
      pieces.push({kind: "minus", start: node.start, end: node.start + 1})
      return inner
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
function wordsOf(whole: Syntax): Syntax[] {
  const behind: Syntax[][] = []
  let node = whole
  // Applications nest to the left.
  while (node.type === "apply") {
    const fn = child(node, "function")
    const argument = child(node, "argument")
    if (argument !== undefined) behind.push(wordsOf(argument))
    if (fn === undefined) return behind.reverse().flat()
    node = fn
  }
  return [...operandWords(node), ...behind.reverse().flat()]
}

function operandWords(node: Syntax): Syntax[] {
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

export function isTypeArgument(node: Syntax): boolean {
  return node.type === "type_application" || node.type === "explicit_type" || node.type === "kind_application"
}

export function operatorOf(node: Syntax, context: Context): string | undefined {
  if (node.type === "infix_id") {
    const name = context.of(onlyNamed(node) ?? node)
    return isVariableName(name) || isConstructorName(name) ? name : undefined
  }
  const op = context.of(node)
  return isOperatorUse(op) || op === ":" ? op : undefined
}
