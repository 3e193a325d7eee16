/// Type inference for literals, functions without a name, tuples, lists, and choices.

import type {Alternative, Expr} from "../model/syntax_tree.ts"
import {unreachable} from "../model/syntax_tree.ts"
import {inferGuards, inferParameters, inferRefined, inferRightHandSide} from "./binding_inference.ts"
import {unknown} from "./environment/environment.ts"
import type {InferenceState} from "./inference_state.ts"
import {freshMeta, unknownType} from "./inference_state.ts"
import {checkDistinct, inferPattern} from "./pattern_inference.ts"
import type {Scope} from "./syntax/scope.ts"
import type {Type} from "./syntax/type.ts"
import {bool, con, fun, funs, listOf, prune, string, tupleOf} from "./syntax/type.ts"
import {
  classOfLiteral,
  instantiate,
  readSignature,
  requireClass,
  typeOfOperator,
  unifyAt,
} from "./type_lookup.ts"

/// Expressions whose parts stand beside each other.
export type Compound = Extract<
  Expr,
  {
    readonly kind:
      | "number"
      | "string"
      | "character"
      | "negate"
      | "section"
      | "lambda"
      | "if"
      | "branches"
      | "case"
      | "lambda-case"
      | "tuple"
      | "list"
      | "range"
      | "typed"
  }
>

export function inferCompound(s: InferenceState, e: Compound, type: Type, scope: Scope): void {
  switch (e.kind) {
    case "number":
      requireClass(s, classOfLiteral(s, e.text), type, e)
      return
    case "string":
      if (s.env.extensions?.has("OverloadedStrings") === true) s.holes.push(type)
      else unifyAt(s, type, string, e)
      return
    case "character":
      unifyAt(s, type, con("Char"), e)
      return
    case "negate":
      requireClass(s, "Num", type, e)
      s.check(e.expr, type, scope)
      return
    case "section":
      inferSection(s, e, type, scope)
      return
    case "lambda":
      inferLambda(s, e, type, scope)
      return
    case "if":
      s.check(e.condition, bool, scope)
      s.check(e.yes, type, scope)
      s.check(e.no, type, scope)
      return
    case "branches":
      for (const g of e.branches) s.check(g.body, type, inferGuards(s, g.guards, scope))
      return
    case "case": {
      const scrutinee = freshMeta(s)
      s.check(e.scrutinee, scrutinee, scope)
      inferAlternatives(s, e.alternatives, scrutinee, type, scope)
      return
    }
    case "lambda-case": {
      const [from, to] = [freshMeta(s), freshMeta(s)]
      unifyAt(s, type, fun(from, to), e)
      inferAlternatives(s, e.alternatives, from, to, scope)
      return
    }
    case "tuple":
      inferTuple(s, e, type, scope)
      return
    case "list": {
      const item = freshMeta(s)
      unifyAt(s, type, listOf(item), e)
      for (const i of e.items) s.check(i, item, scope)
      return
    }
    case "range":
      inferRange(s, e, type, scope)
      return
    case "typed":
      inferTyped(s, e, type, scope)
      return
    default:
      unreachable(e)
  }
}

function inferSection(s: InferenceState, e: Expr & {kind: "section"}, type: Type, scope: Scope): void {
  const [a, b, c] = [freshMeta(s), freshMeta(s), freshMeta(s)]
  unifyAt(s, typeOfOperator(s, e.op, e, scope), funs([a, b], c), e)
  unifyAt(s, type, e.side === "left" ? fun(b, c) : fun(a, c), e)
  s.check(e.operand, e.side === "left" ? a : b, scope)
}

function inferLambda(s: InferenceState, e: Expr & {kind: "lambda"}, type: Type, scope: Scope): void {
  // A function that only GHC knows may pass one that is used at several types: `mask $ \restore -> …`.
  const expected = prune(type)
  const isForeign = expected.kind === "meta" && expected.isForeign === true
  const inner = scope.inner()
  const result = inferParameters(s, e.parameters, type, inner)
  if (isForeign) for (const p of e.parameters) if (p.kind === "name-pattern") inner.set(p.name, unknown)
  s.check(e.body, result, inner)
}

function inferTuple(s: InferenceState, e: Expr & {kind: "tuple"}, type: Type, scope: Scope): void {
  const items = e.items.map(() => freshMeta(s))
  const open = items.filter((_, i) => e.items[i]?.kind === "gap")
  if (open.length > 0) {
    unifyAt(s, type, funs(open, tupleOf(items)), e)
    for (const [i, item] of e.items.entries())
      if (item.kind !== "gap") s.check(item, items[i] ?? freshMeta(s), scope)
    return
  }
  const [only] = items
  unifyAt(s, type, items.length === 1 && only !== undefined ? only : tupleOf(items), e)
  for (const [i, item] of e.items.entries()) s.check(item, items[i] ?? freshMeta(s), scope)
}

function inferRange(s: InferenceState, e: Expr & {kind: "range"}, type: Type, scope: Scope): void {
  const item = freshMeta(s)
  unifyAt(s, type, listOf(item), e)
  requireClass(s, "Enum", item, e)
  for (const part of [e.first, e.second, e.last]) if (part !== undefined) s.check(part, item, scope)
}

function inferTyped(s: InferenceState, e: Expr & {kind: "typed"}, type: Type, scope: Scope): void {
  const scheme = readSignature(s, e.type.text, e.type)
  if (scheme === undefined) {
    s.holes.push(type)
    s.check(e.expr, unknownType(s), scope)
    return
  }
  const inner = instantiate(s, scheme, e)
  unifyAt(s, type, inner, e)
  s.check(e.expr, inner, scope)
}

function inferAlternatives(
  s: InferenceState,
  all: readonly Alternative[],
  of: Type,
  type: Type,
  scope: Scope,
): void {
  for (const a of all)
    inferRefined(s, () => {
      checkDistinct(s, [a.pattern])
      const inner = scope.inner()
      inferPattern(s, a.pattern, of, inner)
      inferRightHandSide(s, a.right, type, inner)
    })
}
