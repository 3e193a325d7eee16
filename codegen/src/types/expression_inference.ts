/// Type inference for expressions and for the statements of a `do`.

import type {Expr, Statement} from "../model/syntax_tree.ts"
import {inferBinding, inferGroup, inferQualifiers} from "./binding_inference.ts"
import {inferCompound} from "./compound_expressions.ts"
import {expand, unknown} from "./environment/environment.ts"
import {unify} from "./environment/unification.ts"
import type {InferenceState} from "./inference_state.ts"
import {freshMeta, recordWatched, unknownType} from "./inference_state.ts"
import type {Scope} from "./syntax/scope.ts"
import type {Type} from "./syntax/type.ts"
import {
  app,
  asFunction,
  con,
  fun,
  listOf,
  prune,
  spine,
  substitute,
  unit,
  variablesIn,
} from "./syntax/type.ts"
import {
  instantiate,
  isPossiblyImported,
  openConstructor,
  readSignature,
  requireClass,
  typeOfConstructor,
  typeOfName,
  typeOfOperator,
  unifyAt,
} from "./type_lookup.ts"

/// The type of a stack of steps without a step, where nothing else decides it.
const emptyTask: Type = app(con("Task"), unit)

export function checkExpression(s: InferenceState, e: Expr, wanted: Type, scope: Scope): void {
  const type = apartFrom(s, e, wanted)
  s.found.set(e, type)
  switch (e.kind) {
    case "variable":
      unifyAt(s, type, typeOfName(s, e.name, e, scope), e)
      return
    case "constructor-name":
      unifyAt(s, type, typeOfConstructor(s, e.name, e), e)
      return
    case "apply": {
      const fn = freshMeta(s)
      checkExpression(s, e.fn, fn, scope)
      inferApplication(s, fn, e.args, type, e, scope)
      return
    }
    case "infix":
      if (e.op === "$") {
        const fn = freshMeta(s)
        checkExpression(s, e.left, fn, scope)
        inferApplication(s, fn, [e.right], type, e, scope)
      } else inferApplication(s, typeOfOperator(s, e.op, e, scope), [e.left, e.right], type, e, scope)
      return
    case "let":
      checkExpression(s, e.body, type, inferGroup(s, e.declarations, scope, false))
      return
    case "do": {
      // A `do` with one statement has the type of that statement; GHC requires no monad.
      const [only, ...more] = e.statements
      if (only?.kind === "statement" && more.length === 0) checkExpression(s, only.expr, type, scope)
      else inferStatements(s, e.statements, type, scope)
      return
    }
    case "comprehension":
      inferComprehension(s, e, type, scope)
      return
    case "type-apply":
      // Which variable the type stands for, GHC knows.
      s.holes.push(type)
      readSignature(s, e.type.text, e.type)
      checkExpression(s, e.fn, unknownType(s), scope)
      return
    case "gap":
      return
    case "record":
      inferRecord(s, e, type, scope)
      return
    case "update":
      inferUpdate(s, e, type, scope)
      return
    case "hole":
      if (e.steps === true && spine(type).head.kind === "meta") unifyAt(s, type, emptyTask, e)
      s.holes.push(type)
      s.sockets.add(type)
      recordWatched(s, e.from, type, scope)
      return
    case "raw":
      // GHC will say; until then it fits anywhere and decides nothing, but that it is a function where it says so.
      s.holes.push(type)
      if (/^\\ *case(?![\p{L}\p{N}_'])/u.test(e.text.trim()))
        unifyAt(s, type, fun(unknownType(s), unknownType(s)), e)
      return
    default:
      inferCompound(s, e, type, scope)
  }
}

/// The type to infer an expression with: a new one for the block that is kept apart from its place.
function apartFrom(s: InferenceState, e: Expr, wanted: Type): Type {
  if (s.apart === undefined || s.typesApart !== undefined) return wanted
  if (e.from?.block !== s.apart || e.from.input !== undefined) return wanted
  const own = freshMeta(s)
  s.typesApart = {own, wanted, isSigned: s.signed, isBeyondInference: false}
  return own
}

function inferApplication(
  s: InferenceState,
  fn: Type,
  args: readonly Expr[],
  type: Type,
  node: Expr,
  scope: Scope,
): void {
  const wanted: Type[] = []
  let result = fn
  for (const _ of args) {
    let f = asFunction(result)
    if (f === undefined) {
      const head = prune(result)
      const part = () =>
        head.kind === "meta" && head.isForeign === true ? {...freshMeta(s), isForeign: true} : freshMeta(s)
      f = {from: part(), to: part()}
      const clash = unify(result, fun(f.from, f.to))
      if (clash?.isUnread === true) {
        s.unreadClashes.push(clash)
        s.holes.push(f.from, f.to)
      } else if (clash !== undefined) {
        const isOfVariable = prune(clash.left).kind === "var"
        s.problems.push({kind: "too-many-arguments", node, type: fn, isOfVariable})
      }
    }
    wanted.push(f.from)
    result = f.to
  }
  // The result first: what is wanted from outside explains best why an argument does not fit.
  unifyAt(s, type, result, node)
  for (const [i, a] of args.entries()) checkExpression(s, a, wanted[i] ?? freshMeta(s), scope)
}

function inferRecord(s: InferenceState, e: Expr & {kind: "record"}, type: Type, scope: Scope): void {
  const info = s.env.constructors.get(e.name)
  if (info === undefined || info.scheme.unknown === true) {
    if (info === undefined && !isPossiblyImported(s, e.name))
      s.problems.push({kind: "unknown-name", node: e, name: e.name})
    s.holes.push(type)
    for (const f of e.fields) checkExpression(s, f.value, unknownType(s), scope)
    // Which names two dots take is not known.
    if (e.rest === true) for (const [, scheme] of scope.all()) s.holes.push(scheme.type)
    return
  }
  const {fields, result} = openConstructor(s, info.scheme, info.fields.length, e)
  unifyAt(s, type, result, e)
  for (const f of e.fields) {
    const at = info.fieldNames.indexOf(f.name)
    if (at < 0) s.problems.push({kind: "unknown-name", node: e, name: f.name})
    checkExpression(s, f.value, fields[at] ?? freshMeta(s), scope)
  }
  if (e.rest !== true) return
  // Two dots take the local names that fields have.
  for (const [at, name] of info.fieldNames.entries()) {
    const local = name === undefined || e.fields.some(f => f.name === name) ? undefined : scope.get(name)
    if (local !== undefined) unifyAt(s, fields[at] ?? freshMeta(s), instantiate(s, local, e), e)
  }
}

/// A changed copy may have another type: all that no kept part is made of is open again. (Haskell 2010 report §3.15.3)
function inferUpdate(s: InferenceState, e: Expr & {kind: "update"}, type: Type, scope: Scope): void {
  const names = e.fields.map(f => f.name)
  const of = findRecordType(s, names)
  if (of === undefined) {
    const [unknown] = names.filter(n => findRecordType(s, [n]) === undefined)
    const name = unknown ?? names[0] ?? ""
    const known = s.env.values.get(name)?.unknown === true || isPossiblyImported(s, name)
    if (!known) s.problems.push({kind: "unknown-name", node: e, name})
    s.holes.push(type)
    checkExpression(s, e.record, unknownType(s), scope)
    for (const f of e.fields) checkExpression(s, f.value, unknownType(s), scope)
    return
  }
  const {name, parameters, constructors} = of
  const kept = new Set<string>()
  const changed = new Map<string, Type>()
  for (const c of constructors)
    c.fields.forEach((field, i) => {
      const at = c.fieldNames[i]
      if (at !== undefined && names.includes(at)) changed.set(at, field)
      else for (const v of variablesIn(field)) kept.add(v)
    })
  const before = new Map(parameters.map(p => [p, freshMeta(s) as Type]))
  const after = new Map([...before].map(([p, t]) => [p, kept.has(p) ? t : freshMeta(s)]))
  unifyAt(s, type, app(con(name), ...after.values()), e)
  checkExpression(s, e.record, app(con(name), ...before.values()), scope)
  for (const f of e.fields) {
    const field = changed.get(f.name) ?? freshMeta(s)
    // Variables that the type has not stand for what only GHC knows of its fields.
    const by = new Map([...variablesIn(field)].map(v => [v, after.get(v) ?? unknownType(s, f.name)] as const))
    checkExpression(s, f.value, expand(substitute(field, by), s.env), scope)
  }
}

/// The type whose constructors have all these fields, with the constructors that have them.
function findRecordType(s: InferenceState, names: readonly string[]) {
  const [first = ""] = names
  const selector = s.env.values.get(first)
  const head = selector === undefined ? undefined : asFunction(selector.type)
  const name = head === undefined ? undefined : spine(head.from).head
  const entry = name?.kind === "con" ? s.env.types.get(name.name) : undefined
  if (name?.kind !== "con" || entry === undefined) return undefined
  const constructors = entry.constructors
    .flatMap(c => s.env.constructors.get(c) ?? [])
    .filter(c => names.every(n => c.fieldNames.includes(n)))
  return constructors.length === 0 ? undefined : {name: name.name, parameters: entry.parameters, constructors}
}

function inferComprehension(
  s: InferenceState,
  e: Expr & {kind: "comprehension"},
  type: Type,
  scope: Scope,
): void {
  const item = freshMeta(s)
  unifyAt(s, type, listOf(item), e)
  checkExpression(s, e.body, item, inferQualifiers(s, e.statements, scope, listOf))
}

/// The scope behind a step of text. `rec` (RecursiveDo) binds the names that stand left of its arrows and equal signs.
function withRecursiveNames(scope: Scope, text: string): Scope {
  if (!/^rec(?![\p{L}\p{N}_'])/u.test(text)) return scope
  const inner = scope.inner()
  for (const [left] of text.slice(3).matchAll(/[^\n;]*?(?=<-|←|=)/g))
    for (const [name] of left.matchAll(/(?<![\p{L}\p{N}_'])[\p{Ll}_][\p{L}\p{N}_']*/gu))
      inner.set(name, unknown)
  return inner
}

export function inferStatements(
  s: InferenceState,
  statements: readonly Statement[],
  type: Type,
  scope: Scope,
): void {
  const monad = freshMeta(s)
  let inner = scope
  statements.forEach((step, i) => {
    const last = i === statements.length - 1
    if (step.kind === "statement") {
      const result = last ? type : app(monad, freshMeta(s))
      if (last) unifyAt(s, type, app(monad, freshMeta(s)), step.expr)
      if (step.expr.kind === "raw") inner = withRecursiveNames(inner, step.expr.text)
      checkExpression(s, step.expr, result, inner)
      if (statements.length > 1) requireClass(s, "Monad", monad, step.expr)
    } else {
      inner = inferBinding(s, step, inner, element => app(monad, element))
      if (step.kind === "bind") requireClass(s, "Monad", monad, step.expr)
    }
  })
}
