/// Which operator of a flat chain takes which operands: the algorithm of the Haskell 2010 report, §10.6.

import type {Fixities, Fixity} from "../haskell/fixity.ts"
import {fixityOf} from "../haskell/fixity.ts"

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

interface Part<T> {
  readonly value: T
  readonly from: number
}

const minus: Fixity = {precedence: 6, associates: "left"}
const start: Fixity = {precedence: -1, associates: "none"}

/// `undefined` when the fixities forbid the chain, as in `a == b == c`.
export function resolve<T>(links: readonly Link<T>[], fixities: Fixities, build: Build<T>): T | undefined {
  let at = 0

  const negated = (outer: Fixity): Part<T> | undefined => {
    const from = at
    const link = links[at]
    if (link?.kind === "operand") {
      at++
      return after(outer, {value: link.value, from})
    }
    if (link?.kind !== "minus" || outer.precedence >= 6) return undefined
    at++
    const operand = negated(minus)
    return operand && after(outer, {value: build.negate(operand.value, from, at - 1), from})
  }

  const after = (outer: Fixity, left: Part<T>): Part<T> | undefined => {
    let done = left
    for (;;) {
      const link = links[at]
      if (link === undefined) return done
      if (link.kind !== "operator") return undefined
      const own = fixityOf(link.op, fixities)
      if (
        outer.precedence === own.precedence &&
        (outer.associates !== own.associates || outer.associates === "none")
      )
        return undefined
      if (
        outer.precedence > own.precedence ||
        (outer.precedence === own.precedence && outer.associates === "left")
      )
        return done
      at++
      const right = negated(own)
      if (right === undefined) return undefined
      done = {value: build.infix(link.op, done.value, right.value, done.from, at - 1), from: done.from}
    }
  }

  const whole = negated(start)
  return at === links.length ? whole?.value : undefined
}
