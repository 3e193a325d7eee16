/// Type inference for patterns, and the names that they bind.

import {bindersIn} from "../model/name_resolution.ts"
import type {Pattern} from "../model/syntax_tree.ts"
import {unreachable} from "../model/syntax_tree.ts"
import {unknown} from "./environment/environment.ts"
import type {InferenceState} from "./inference_state.ts"
import {freshMeta, mono, recordWatched, unknownType} from "./inference_state.ts"
import type {Scope} from "./syntax/scope.ts"
import type {Type} from "./syntax/type.ts"
import {con, fun, listOf, prune, string, tupleOf} from "./syntax/type.ts"
import {
  classOfLiteral,
  isPossiblyImported,
  openConstructor,
  readSignature,
  requireClass,
  unifyAt,
} from "./type_lookup.ts"

/// A name may stand only once among the patterns that are matched together. (Haskell 2010 report §3.17.1)
export function checkDistinct(s: InferenceState, patterns: readonly Pattern[]): void {
  const seen = new Set<string>()
  for (const [name, node] of patterns.flatMap(bindersIn)) {
    if (seen.has(name)) s.problems.push({kind: "twice", node: node as Pattern, name})
    seen.add(name)
  }
}

export function inferPattern(s: InferenceState, p: Pattern, type: Type, scope: Scope): void {
  s.found.set(p, type)
  switch (p.kind) {
    case "name-pattern":
      scope.set(p.name, mono(type))
      return
    case "wildcard":
      recordWatched(s, p.from, type, scope)
      return
    case "constructor-pattern":
      inferConstructorPattern(s, p, type, scope)
      return
    case "number-pattern":
      requireClass(s, classOfLiteral(s, p.text), type, p)
      requireClass(s, "Eq", type, p)
      return
    case "string-pattern":
      if (s.env.extensions?.has("OverloadedStrings") === true) s.holes.push(type)
      else unifyAt(s, type, string, p)
      return
    case "character-pattern":
      unifyAt(s, type, con("Char"), p)
      return
    case "tuple-pattern": {
      const items = p.items.map(() => freshMeta(s))
      const [only] = items
      unifyAt(s, type, items.length === 1 && only !== undefined ? only : tupleOf(items), p)
      for (const [i, item] of p.items.entries()) inferPattern(s, item, items[i] ?? freshMeta(s), scope)
      return
    }
    case "list-pattern": {
      const item = freshMeta(s)
      unifyAt(s, type, listOf(item), p)
      for (const i of p.items) inferPattern(s, i, item, scope)
      return
    }
    case "infix-pattern":
      if (p.op === ":") {
        const item = freshMeta(s)
        unifyAt(s, type, listOf(item), p)
        inferPattern(s, p.left, item, scope)
        inferPattern(s, p.right, type, scope)
      } else
        inferConstructorPattern(
          s,
          {...p, kind: "constructor-pattern", name: p.op, args: [p.left, p.right]},
          type,
          scope,
        )
      return
    case "as-pattern":
      scope.set(p.name, mono(type))
      inferPattern(s, p.pattern, type, scope)
      return
    case "record-pattern":
      inferRecordPattern(s, p, type, scope)
      return
    case "strictness-pattern":
      inferPattern(s, p.pattern, type, scope)
      return
    case "view-pattern": {
      const inner = freshMeta(s)
      s.check(p.expr, fun(type, inner), scope)
      inferPattern(s, p.pattern, inner, scope)
      return
    }
    case "typed-pattern": {
      // A variable of the type may be bound here, so only types without variables decide something.
      const scheme = readSignature(s, p.type.text, p.type)
      if (scheme !== undefined && scheme.variables.length === 0) unifyAt(s, type, scheme.type, p)
      else s.holes.push(type)
      inferPattern(s, p.pattern, type, scope)
      return
    }
    case "raw-pattern":
      s.holes.push(type)
      bindRawNames(s, p.text, scope)
      return
    default:
      unreachable(p)
  }
}

function inferConstructorPattern(
  s: InferenceState,
  p: Pattern & {kind: "constructor-pattern"},
  type: Type,
  scope: Scope,
): void {
  if (p.name === "()" && p.args.length === 0) {
    unifyAt(s, type, con("()"), p)
    return
  }
  const info = s.env.constructors.get(p.name)
  if (info === undefined || info.scheme.unknown === true) {
    s.opaque++
    if (info === undefined && !isPossiblyImported(s, p.name))
      s.problems.push({kind: "unknown-name", node: p, name: p.name})
    s.holes.push(type)
    for (const a of p.args) inferPattern(s, a, unknownType(s), scope)
    return
  }
  const {fields, result} = openConstructor(s, info.scheme, info.fields.length, p)
  if (fields.length !== p.args.length)
    s.problems.push({
      kind: "wrong-field-count",
      node: p,
      name: p.name,
      wanted: fields.length,
      found: p.args.length,
    })
  unifyAt(s, type, result, p)
  for (const [i, a] of p.args.entries()) inferField(s, a, fields[i] ?? freshMeta(s), scope)
}

function inferRecordPattern(
  s: InferenceState,
  p: Pattern & {kind: "record-pattern"},
  type: Type,
  scope: Scope,
): void {
  const info = s.env.constructors.get(p.name)
  const restNames = p.rest !== true ? [] : (info?.fieldNames ?? []).filter(n => n !== undefined)
  const isListed = (name: string) => p.fields.some(f => f.name === name)
  if (info === undefined || info.scheme.unknown === true) {
    if (info === undefined && !isPossiblyImported(s, p.name))
      s.problems.push({kind: "unknown-name", node: p, name: p.name})
    s.holes.push(type)
    for (const f of p.fields) inferPattern(s, f.pattern, unknownType(s), scope)
    for (const name of restNames) if (!isListed(name)) scope.set(name, mono(unknownType(s)))
    return
  }
  const {fields, result} = openConstructor(s, info.scheme, info.fields.length, p)
  unifyAt(s, type, result, p)
  for (const f of p.fields) {
    const at = info.fieldNames.indexOf(f.name)
    if (at < 0) s.problems.push({kind: "unknown-name", node: p, name: f.name})
    inferField(s, f.pattern, fields[at] ?? freshMeta(s), scope)
  }
  for (const name of restNames)
    if (!isListed(name)) scope.set(name, mono(fields[info.fieldNames.indexOf(name)] ?? unknownType(s)))
}

/// The names that raw Haskell may bind.
function bindRawNames(s: InferenceState, text: string, scope: Scope): void {
  for (const [name] of text.matchAll(/(?<![\p{L}\p{N}_'])[\p{Ll}_][\p{L}\p{N}_']*/gu))
    scope.set(name, mono(unknownType(s)))
  // Two dots name all parts of a record.
  for (const [, name = ""] of text.matchAll(/([\p{Lu}][\p{L}\p{N}_']*)\s*\{[^{}]*\.\.\s*\}/gu))
    for (const field of s.env.constructors.get(name)?.fieldNames ?? [])
      if (field !== undefined) scope.set(field, mono(unknownType(s)))
}

/// A field whose type only GHC knows may have several types, one at each use (`forall`).
function inferField(s: InferenceState, p: Pattern, type: Type, scope: Scope): void {
  const field = prune(type)
  inferPattern(s, p, type, scope)
  if (p.kind === "name-pattern" && field.kind === "meta" && field.isForeign === true)
    scope.set(p.name, unknown)
}
