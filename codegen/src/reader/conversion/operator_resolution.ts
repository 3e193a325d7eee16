/// Operator resolution: which operator of a flat chain takes which operands (Haskell 2010 report, §10.6). Iterative, for chains of any length.

import type {Fixities, Fixity} from "../../haskell/fixity.ts"
import {fixityOf} from "../../haskell/fixity.ts"

/// `a + - b * c` is operand, operator, minus, operand, operator, operand.
export type Link<T> =
  | {readonly kind: "operand"; readonly value: T}
  | {readonly kind: "operator"; readonly op: string}
  | {readonly kind: "minus"}

/// What to build; `from` and `to` are the numbers of the first and last link that went in.
export interface Build<T> {
  infix(op: string, left: T, right: T, from: number, to: number): T
  negate(operand: T, from: number, to: number): T
}

interface Operand<T> {
  readonly value: T
  readonly from: number
}

type Waiting<T> =
  | {readonly kind: "minus"; readonly fixity: Fixity; readonly from: number}
  | {readonly kind: "operator"; readonly fixity: Fixity; readonly op: string; readonly left: Operand<T>}

const minus: Fixity = {precedence: 6, associates: "left"}
const start: Fixity = {precedence: -1, associates: "none"}

/// How two operators group that stand side by side: the left one takes the operand between them first, or the right one does.
/// Undefined where their fixities forbid that, and where one is not known and the grouping depends on it.
function groupingOf(left: Fixity, right: Fixity): "left" | "right" | undefined {
  if (Number.isNaN(left.precedence) || Number.isNaN(right.precedence)) {
    // Every operator that GHC lets stand behind `$` binds tighter or as it does, and none binds tighter than an `infixl 9`.
    if (left.precedence === 0 && left.associates === "right") return "right"
    return left.precedence === 9 && left.associates === "left" ? "left" : undefined
  }
  if (left.precedence !== right.precedence) return left.precedence > right.precedence ? "left" : "right"
  if (left.associates !== right.associates || left.associates === "none") return undefined
  return left.associates
}

/// `undefined` when the fixities forbid the chain, as in `a == b == c`, or do not decide how it groups.
export function resolve<T>(links: readonly Link<T>[], fixities: Fixities, build: Build<T>): T | undefined {
  // Operators and signs that wait for their right operand, each with the operand on its left.
  const waiting: Waiting<T>[] = []
  let at = 0
  for (;;) {
    // An operand, with the signs before it.
    let outer = waiting[waiting.length - 1]?.fixity ?? start
    for (; links[at]?.kind === "minus"; at++) {
      if (outer.precedence >= 6) return undefined
      waiting.push({kind: "minus", fixity: minus, from: at})
      outer = minus
    }
    const operand = links[at]
    if (operand?.kind !== "operand") return undefined
    let done: Operand<T> = {value: operand.value, from: at}
    at++
    const next = links[at]
    if (next !== undefined && next.kind !== "operator") return undefined
    const own = next === undefined ? start : fixityOf(next.op, fixities)
    // Everything that binds tighter than the next operator is complete.
    for (let top = waiting[waiting.length - 1]; top !== undefined; top = waiting[waiting.length - 1]) {
      const grouping = next === undefined ? "left" : groupingOf(top.fixity, own)
      if (grouping === undefined) return undefined
      if (grouping === "right") break
      waiting.pop()
      done =
        top.kind === "minus"
          ? {value: build.negate(done.value, top.from, at - 1), from: top.from}
          : {
              value: build.infix(top.op, top.left.value, done.value, top.left.from, at - 1),
              from: top.left.from,
            }
    }
    if (next === undefined) return done.value
    waiting.push({kind: "operator", fixity: own, op: next.op, left: done})
    at++
  }
}
