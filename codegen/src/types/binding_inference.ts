/// Type inference for definitions: dependency groups, signatures, equations, right-hand sides and qualifiers.
///
/// Levels stand for generalisation: an unknown made inside a binding and not reachable from outside is that binding's own.

import {namesDefinedBy} from "../model/bound_names.ts"
import {everyNode} from "../model/child_nodes.ts"
import type {
  Clause,
  Declaration,
  Expr,
  FunctionDeclaration,
  Node,
  Pattern,
  PatternBinding,
  RightSide,
  Statement,
} from "../model/syntax_tree.ts"
import {deferConstraints, reduceConstraints} from "./class_constraints.ts"
import {unknown} from "./environment/environment.ts"
import type {Rigid} from "./environment/unification.ts"
import {generalise} from "./generalisation.ts"
import type {InferenceState} from "./inference_state.ts"
import {freshMeta, inferWithinBounds, mono} from "./inference_state.ts"
import {checkDistinct, inferPattern} from "./pattern_inference.ts"
import type {WrittenSignature} from "./standalone_signatures.ts"
import {checkBindings, readTextDeclaration} from "./standalone_signatures.ts"
import type {Scope} from "./syntax/scope.ts"
import {stronglyConnectedComponents} from "./syntax/strongly_connected_components.ts"
import type {Scheme, Type} from "./syntax/type.ts"
import {asFunction, bool, fun, metasIn, rigidsIn, substitute} from "./syntax/type.ts"
import {apartFromForall} from "./syntax/type_parser.ts"
import type {Wanted} from "./syntax/type_problems.ts"
import {isBeyondInference, readDefinitionSignature, unifyAt} from "./type_lookup.ts"

/// Maximum number of parameters, arguments or items of a tuple that are inferred: each may be a level of a type, and functions over types are recursive.
const mostParts = 500

/// Definitions that may refer to each other; answers the scope with their names.
export function inferGroup(
  s: InferenceState,
  declarations: readonly Declaration[],
  outer: Scope,
  top: boolean,
): Scope {
  const values = declarations.filter(d => d.kind === "function" || d.kind === "binding")
  const scope = outer.inner()
  const signatures = new Map<Declaration, Scheme>()
  const written = new Map<string, WrittenSignature>()
  for (const d of declarations)
    if (d.kind === "raw-declaration") readTextDeclaration(s, d, scope, written, top)
  checkBindings(s, declarations, written)
  const byName = new Map<string, number>()
  values.forEach((d, i) => {
    for (const name of namesDefinedBy(d)) {
      if (byName.has(name) || (top && s.env.fields?.has(name) === true))
        s.problems.push({kind: "twice", node: d, name})
      byName.set(name, i)
      // A name of the Prelude may be defined anew as long as it stands nowhere without a qualifier.
      if (top && s.env.fixed.has(name) && declarations.some(other => s.freeNames(other).has(name)))
        s.problems.push({kind: "taken", node: d, name})
      // Known from the start, also to lookups of the scope before its turn; its type comes with its component.
      const placeholder = mono(freshMeta(s))
      scope.set(name, placeholder)
      if (top) s.placeholders.add(placeholder)
    }
    if (d.kind !== "function") return
    const elsewhere = d.signature === undefined ? written.get(d.name) : undefined
    // Printing a second signature would make the program wrong.
    if (elsewhere !== undefined) s.unsignable.add(d)
    const own = d.signature === undefined ? elsewhere : {text: d.signature.text, node: d.signature}
    if (own === undefined) return
    const scheme = top
      ? s.readTopSignature(own.text, own.node)
      : readDefinitionSignature(s, own.text, own.node)
    if (scheme !== undefined) {
      signatures.set(d, scheme)
      scope.set(d.name, scheme)
    }
  })
  const edges = values.map(d =>
    [...s.freeNames(d)].flatMap(name => {
      const i = byName.get(name)
      const target = i === undefined ? undefined : values[i]
      return i === undefined || target === undefined || signatures.has(target) ? [] : [i]
    }),
  )
  for (const component of stronglyConnectedComponents(edges)) {
    const members = component.flatMap(i => values[i] ?? [])
    if (top) s.inferTopGroup(members, scope, () => inferComponent(s, members, signatures, scope, top))
    else inferComponent(s, members, signatures, scope, top)
  }
  return scope
}

/// Variables that a type promises to work for.
export function rigidVariables(s: InferenceState, names: Iterable<string>): Map<string, Type> {
  const rigid = new Map<string, Type>()
  for (const name of names) {
    const variable: Rigid = {kind: "var", name, id: s.count++, level: s.level + 1}
    rigid.set(name, variable)
  }
  return rigid
}

/// Definitions that refer to each other. What is beyond inference has an unknown type, which fits everywhere.
function inferComponent(
  s: InferenceState,
  members: readonly Declaration[],
  signatures: ReadonlyMap<Declaration, Scheme>,
  scope: Scope,
  top: boolean,
): void {
  const [only] = members
  const signature = only === undefined ? undefined : signatures.get(only)
  const infer = () => {
    if (members.length === 1 && only?.kind === "function" && signature !== undefined)
      checkAgainstSignature(s, only, signature, scope)
    else inferJointly(s, members, scope, top)
  }
  const {problems, wanted, typesApart} = {
    problems: s.problems.length,
    wanted: s.wanted.length,
    typesApart: s.typesApart,
  }
  const isUnread = members.some(d => d.kind === "function" && d.signature !== undefined && !signatures.has(d))
  if (!top) infer()
  else if (members.some(isTooLargeToInfer) || !inferWithinBounds(s, infer)) {
    s.typesApart = typesApart
    leaveToGhc(s, members, scope, signatures)
    return
  }
  if (isUnread && s.typesApart !== undefined && s.typesApart !== typesApart)
    s.typesApart.isBeyondInference = true
  if (
    !members.some(
      d => d.kind === "function" && isBeyondInference(s, apartFromForall(d.signature?.text ?? "").type),
    )
  )
    return
  s.problems.length = problems
  s.wanted.length = wanted
  s.typesApart = typesApart
  leaveToGhc(s, members, scope)
}

/// Whether types in a definition would be larger than those that inference reads.
function isTooLargeToInfer(d: Declaration): boolean {
  for (const node of everyNode(d)) if (partsOfType(node) > mostParts) return true
  return false
}

/// Number of levels or arguments that a node gives to one type.
function partsOfType(node: Node): number {
  switch (node.kind) {
    case "clause":
      return node.patterns.length
    case "lambda":
      return node.parameters.length
    case "apply":
    case "constructor-pattern":
      return node.args.length
    case "tuple":
    case "tuple-pattern":
      return node.items.length
    default:
      return 0
  }
}

function leaveToGhc(
  s: InferenceState,
  members: readonly Declaration[],
  scope: Scope,
  signatures: ReadonlyMap<Declaration, Scheme> = new Map(),
): void {
  for (const d of members) {
    const scheme = signatures.get(d) ?? unknown
    s.schemes.set(d, scheme)
    for (const name of namesDefinedBy(d)) scope.set(name, scheme)
  }
}

/// The variables of an instance's `head` stand for the same types all through its methods (GHC's ScopedTypeVariables).
export function checkAgainstSignature(
  s: InferenceState,
  d: FunctionDeclaration,
  scheme: Scheme,
  scope: Scope,
  head: ReadonlySet<string> = new Set(),
): void {
  s.schemes.set(d, scheme)
  const before = s.wanted
  s.wanted = []
  const rigid = rigidVariables(s, scheme.variables)
  s.level++
  const {opaque} = s
  const givens = scheme.constraints.map(c => ({name: c.name, type: substitute(c.type, rigid)}))
  const {scoped, signed} = s
  const isScoped = (name: string) => head.has(name) || scheme.scoped?.includes(name) === true
  s.scoped = new Map([...scoped, ...[...rigid].filter(([name]) => isScoped(name))])
  s.signed = true
  inferClauses(s, d, substitute(scheme.type, rigid), scope)
  s.scoped = scoped
  s.signed = signed
  s.level--
  const {stuck} = reduceConstraints(s, s.wanted, givens)
  // What follows from a class of the program's own, or from a name for several constraints, only GHC knows.
  const hasUnreadClass = givens.some(c => !s.env.classes.has(c.name))
  const deferred: Wanted[] = []
  const own = new Set([...rigid.values()])
  for (const c of stuck) {
    // Only about variables that s signature promises to work for.
    const mine = metasIn(c.type).size === 0 && [...rigidsIn(c.type)].some(v => own.has(v))
    if (mine && (s.opaque > opaque || hasUnreadClass)) s.env.assumed.push(c)
    else if (mine) s.problems.push({kind: "too-general", node: c.node, constraint: c})
    else deferred.push(c)
  }
  s.wanted = before
  deferConstraints(s, deferred, new Set())
}

function inferJointly(s: InferenceState, members: readonly Declaration[], scope: Scope, top: boolean): void {
  const before = s.wanted
  s.wanted = []
  s.level++
  const types = new Map<Declaration, Type>()
  for (const d of members) {
    if (d.kind === "function") {
      const type = freshMeta(s)
      types.set(d, type)
      scope.set(d.name, mono(type))
    } else if (d.kind === "binding") {
      const type = freshMeta(s)
      types.set(d, type)
      inferPattern(s, d.pattern, type, scope)
    }
  }
  const {signed} = s
  s.signed = false
  for (const d of members) {
    const type = types.get(d)
    if (type === undefined) continue
    if (d.kind === "function") inferClauses(s, d, type, scope)
    else if (d.kind === "binding") inferRightHandSide(s, (d as PatternBinding).right, type, scope)
  }
  s.signed = signed
  s.level--
  const {stuck} = reduceConstraints(s, s.wanted, [])
  s.wanted = before
  generalise(s, members, types, stuck, scope, top)
  if (top && isRecursive(s, members)) checkPrintableSignature(s, members, scope)
}

function isRecursive(s: InferenceState, members: readonly Declaration[]): boolean {
  const names = new Set(members.flatMap(namesDefinedBy))
  return members.some(d => [...s.freeNames(d)].some(name => names.has(name)))
}

/// With its type written out, a definition may use itself at another type each time, and GHC may find that nothing decides
/// which. Such a definition is better off without a signature.
function checkPrintableSignature(s: InferenceState, members: readonly Declaration[], scope: Scope): void {
  const {found, schemes, wanted} = s
  const [problems, holes] = [s.problems.length, s.holes.length]
  s.found = new Map()
  s.schemes = new Map()
  s.wanted = []
  for (const d of members) {
    const scheme = schemes.get(d)
    if (d.kind === "function" && scheme !== undefined) checkAgainstSignature(s, d, scheme, scope)
  }
  if (s.problems.length > problems) for (const d of members) s.unsignable.add(d)
  s.problems.length = problems
  s.holes.length = holes
  s.found = found
  s.schemes = schemes
  s.wanted = wanted
}

export function inferClauses(s: InferenceState, d: FunctionDeclaration, type: Type, scope: Scope): void {
  for (const c of d.clauses) inferClause(s, c, type, scope)
}

function inferClause(s: InferenceState, c: Clause, type: Type, scope: Scope): void {
  inferRefined(s, () => {
    const inner = scope.inner()
    const result = inferParameters(s, c.patterns, type, inner)
    inferRightHandSide(s, c.right, result, inner)
  })
}

/// Infers patterns and what stands behind them. Where a constructor's type is only GHC's to know, it may say what a variable of a signature stands for
/// (GADTs), so that nothing is said that depends on it.
export function inferRefined(s: InferenceState, infer: () => void): void {
  const {opaque, typesApart} = s
  const before = s.problems.length
  infer()
  if (s.opaque === opaque) return
  if (s.typesApart !== undefined && s.typesApart !== typesApart) s.typesApart.isBeyondInference = true
  const found = s.problems.splice(before)
  s.problems.push(...found.filter(p => !("isOfVariable" in p && p.isOfVariable)))
}

/// Patterns that take the parameters of a function; answers the type of what it makes.
export function inferParameters(
  s: InferenceState,
  patterns: readonly Pattern[],
  type: Type,
  scope: Scope,
): Type {
  checkDistinct(s, patterns)
  let result = type
  for (const p of patterns) {
    let f = asFunction(result)
    if (f === undefined) {
      f = {from: freshMeta(s), to: freshMeta(s)}
      unifyAt(s, result, fun(f.from, f.to), p)
    }
    inferPattern(s, p, f.from, scope)
    result = f.to
  }
  return result
}

export function inferRightHandSide(s: InferenceState, right: RightSide, type: Type, scope: Scope): void {
  const inner = right.where.length === 0 ? scope : inferGroup(s, right.where, scope, false)
  const body = right.body
  if (!Array.isArray(body)) {
    s.check(body as Expr, type, inner)
    return
  }
  for (const g of body) {
    const bound = inferGuards(s, g.guards, inner)
    s.check(g.body, type, bound)
  }
}

export function inferGuards(s: InferenceState, statements: readonly Statement[], scope: Scope): Scope {
  return inferQualifiers(s, statements, scope, element => element)
}

/// The scope behind the conditions and bindings of a guard or a list comprehension. `container` gives the type of the expression of `pattern <- expression` from
/// that of the pattern.
export function inferQualifiers(
  s: InferenceState,
  statements: readonly Statement[],
  scope: Scope,
  container: (element: Type) => Type,
): Scope {
  let inner = scope
  for (const step of statements) {
    if (step.kind === "statement") s.check(step.expr, bool, inner)
    else inner = inferBinding(s, step, inner, container)
  }
  return inner
}

/// The scope behind `pattern <- expression` or `let`.
export function inferBinding(
  s: InferenceState,
  step: Exclude<Statement, {kind: "statement"}>,
  scope: Scope,
  container: (element: Type) => Type,
): Scope {
  if (step.kind === "let-statement") return inferGroup(s, step.declarations, scope, false)
  const element = freshMeta(s)
  s.check(step.expr, container(element), scope)
  checkDistinct(s, [step.pattern])
  const inner = scope.inner()
  inferPattern(s, step.pattern, element, inner)
  return inner
}
