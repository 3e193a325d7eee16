/// Hindley-Milner inference over the program tree, with type classes and without giving up at the first problem.
///
/// Levels stand for generalisation: an unknown made inside a binding and not reachable from outside is that binding's own.
/// Every expression and pattern gets a type; an empty socket gets the type that would fit it. What does not go
/// together is recorded at the node where it shows, and inference goes on as if it had been right.

import {namesDefinedBy} from "../model/bound_names.ts"
import {freeInDeclaration} from "../model/name_resolution.ts"
import type {
  DataDeclaration,
  Declaration,
  Expr,
  InstanceDeclaration,
  Node,
  Origin,
  Pattern,
  Statement,
  SynonymDeclaration,
  TypeText,
} from "../model/syntax_tree.ts"
import type {BlockId} from "../serialized_blocks.ts"
import {inferGroup} from "./binding_inference.ts"
import {reduceConstraints, solveRemaining} from "./class_constraints.ts"
import {classHead} from "./environment/declaration_scanner.ts"
import type {Environment} from "./environment/environment.ts"
import {expand} from "./environment/environment.ts"
import {isKnownClass} from "./environment/kinds.ts"
import {library} from "./environment/standard_library.ts"
import {reduce} from "./environment/unification.ts"
import {checkExpression, inferStatements} from "./expression_inference.ts"
import type {CachedGroup, InferenceCache} from "./inference_cache.ts"
import type {InferenceState} from "./inference_state.ts"
import {freshMeta, inferWithinBounds} from "./inference_state.ts"
import {checkDuplicateInstances, inferInstance} from "./instance_inference.ts"
import {inferPattern} from "./pattern_inference.ts"
import {Scope} from "./syntax/scope.ts"
import type {Scheme, Type} from "./syntax/type.ts"
import {app, con, metasIn, showScheme} from "./syntax/type.ts"
import {apartFromForall} from "./syntax/type_parser.ts"
import {readDefinitionSignature, readSignature} from "./type_lookup.ts"

/// A new inference in an environment. `typesKey` identifies the program's own types for the cache; `watch` is a socket to ask about.
export function createInference(
  env: Environment,
  {
    cache,
    typesKey = "",
    watch,
    apart,
  }: {
    cache?: InferenceCache
    typesKey?: string
    watch?: Origin | undefined
    apart?: BlockId | undefined
  } = {},
): InferenceState {
  const s: InferenceState = {
    env,
    found: new Map(),
    schemes: new Map(),
    problems: [],
    holes: [],
    foreignNames: new Map(),
    sockets: new Set(),
    unreadClashes: [],
    undefinedNames: new Map(),
    settledHoles: [],
    improvable: [],
    wanted: [],
    pending: [],
    level: 0,
    count: 0,
    lenient: false,
    signed: false,
    opaque: 0,
    strays: new Map(),
    scoped: new Map(),
    placeholders: new Set(),
    unsignable: new Set(),
    largeTypes: new Set(),
    groups: [],
    watch,
    watched: undefined,
    watchedType: undefined,
    apart,
    typesApart: undefined,
    check: (e, type, scope) => checkExpression(s, e, type, scope),
    freeNames: d => cache?.freeIn(d) ?? freeInDeclaration(d),
    inferTopGroup: (members, scope, infer) => inferCached(s, cache, typesKey, members, scope, infer),
    readTopSignature: (text, node) => readCached(s, cache, typesKey, text, node),
  }
  return s
}

/// The type of every expression and pattern, parents before their parts.
export function allTypes(s: InferenceState): ReadonlyMap<Node, Type> {
  return new Map([...s.found, ...s.groups.flatMap(group => [...group.types])])
}

/// Top-level declarations; answers the names they define.
export function inferProgram(
  s: InferenceState,
  declarations: readonly Declaration[],
  known: Scope = new Scope(),
): Scope {
  const scope = inferGroup(s, declarations, known, true)
  inferWithinBounds(s, () => checkDuplicateInstances(s, declarations))
  for (const d of declarations) if (d.kind === "instance") checkClass(s, d)
  for (const d of declarations)
    if (d.kind === "instance")
      s.inferTopGroup([d], scope, () => inferWithinBounds(s, () => inferInstance(s, d, scope)))
  inferWithinBounds(s, () => solveRemaining(s))
  return scope
}

/// Looks for unknown superclasses in the declaration of a class.
function checkClass(s: InferenceState, d: InstanceDeclaration): void {
  const head = /^class\b/.test(d.head) ? classHead(d.head) : undefined
  for (const name of head?.superclasses ?? [])
    if (!name.includes(".") && !isKnownClass(s.env, name))
      s.problems.push({kind: "unknown-class", node: d, name})
}

/// Looks for unknown types in a type declaration.
export function checkDeclaredTypes(s: InferenceState, d: DataDeclaration | SynonymDeclaration): void {
  // Types and constructors have names apart: `data Token = Char Char` is allowed.
  const constructors = d.kind === "data" ? d.constructors.map(c => c.name) : []
  const isType = (name: string) => library.types.has(name) || library.classes.has(name)
  for (const name of [
    ...[d.name].filter(isType),
    ...constructors.filter(name => library.constructors.has(name)),
  ])
    if (s.env.fixed.has(name)) s.problems.push({kind: "taken", node: d, name})
  const texts = d.kind === "synonym" ? [d.type] : d.constructors.flatMap(c => c.fields.map(f => f.type))
  const before = s.problems.length
  for (const t of texts) readFieldType(s, t, d)
  if (d.kind === "data" && s.problems.length === before) checkDeriving(s, d)
}

/// A synonym may stand for a type that still takes arguments, and for a constraint.
function readFieldType(s: InferenceState, t: TypeText, d: DataDeclaration | SynonymDeclaration): void {
  const before = s.problems.length
  readSignature(s, t.text, t)
  if (d.kind === "synonym" && s.problems[before]?.kind === "kind") s.problems.length = before
}

/// Looks at what a type derives: classes that exist, with those that they build on, for fields that belong to them.
function checkDeriving(s: InferenceState, d: DataDeclaration): void {
  const {env} = s
  const needs = [...env.needs]
  for (const name of d.deriving) {
    // A class of a module, or one with more parameters, is for GHC to judge.
    if (/[. ]/.test(name)) continue
    if (!isKnownClass(env, name)) {
      s.problems.push({kind: "unknown-class", node: d, name})
      continue
    }
    const absent = (env.classes.get(name) ?? []).find(
      c => derivedClasses.has(c) && !d.deriving.includes(c) && env.written?.has(`${c} ${d.name}`) !== true,
    )
    if (absent !== undefined)
      s.problems.push({kind: "missing-superclass", node: d, name, of: d.name, wanted: absent})
    if (!structuralClasses.has(name)) continue
    for (const c of d.constructors)
      for (const type of env.constructors.get(c.name)?.fields ?? []) {
        const r = reduce({name, type: expand(type, env)}, env)
        if (r.kind === "no") s.problems.push({kind: "no-instance", node: d, constraint: r.constraint})
      }
  }
  // Only what the program does with a type decides what the printer lets it derive.
  env.needs.clear()
  for (const n of needs) env.needs.add(n)
}

/// Classes that are derived from the fields of a type, each of which must belong to the class.
const structuralClasses: ReadonlySet<string> = new Set(["Eq", "Ord", "Show", "Read"])
const derivedClasses: ReadonlySet<string> = new Set([...structuralClasses, "Functor", "Foldable"])

/// An expression that belongs to no declaration; names that only a function around it could bind are let be.
export function inferLooseExpression(s: InferenceState, expr: Expr, scope: Scope): Type {
  s.lenient = true
  s.strays = new Map()
  s.level++
  const type = freshMeta(s)
  checkExpression(s, expr, type, scope)
  s.level--
  s.wanted = reduceConstraints(s, s.wanted, []).stuck
  s.pending.push(...s.wanted)
  s.wanted = []
  s.lenient = false
  return type
}

export function inferLoosePattern(s: InferenceState, pattern: Pattern): Type {
  s.level++
  const type = freshMeta(s)
  inferPattern(s, pattern, type, new Scope())
  s.level--
  s.pending.push(...reduceConstraints(s, s.wanted, []).stuck)
  s.wanted = []
  return type
}

export function inferLooseStatements(
  s: InferenceState,
  statements: readonly Statement[],
  scope: Scope,
): void {
  s.lenient = true
  s.strays = new Map()
  s.level++
  inferStatements(s, statements, app(con("Task"), freshMeta(s)), scope)
  s.level--
  s.pending.push(...reduceConstraints(s, s.wanted, []).stuck)
  s.wanted = []
  s.lenient = false
}

/// Reads the signature of a top-level definition, or takes what was read of the very same one before.
function readCached(
  s: InferenceState,
  cache: InferenceCache | undefined,
  typesKey: string,
  text: string,
  node: Node,
): Scheme | undefined {
  const known = cache?.signatures.get(node)
  if (known?.typesKey === typesKey && known.text === text) {
    s.problems.push(...known.problems)
    if (known.isLarge) s.largeTypes.add(apartFromForall(text).type)
    return known.scheme
  }
  const before = s.problems.length
  const scheme = readDefinitionSignature(s, text, node)
  const isLarge = s.largeTypes.has(apartFromForall(text).type)
  cache?.signatures.set(node, {typesKey, text, scheme, problems: s.problems.slice(before), isLarge})
  return scheme
}

/// Infers a group of top-level definitions, or takes what was found for the very same group before.
function inferCached(
  s: InferenceState,
  cache: InferenceCache | undefined,
  typesKey: string,
  members: readonly Declaration[],
  scope: Scope,
  infer: () => void,
): void {
  const watched = s.watch?.block ?? s.apart
  // What is looked at must be gone through; all else may be remembered.
  const fresh = cache === undefined || (watched !== undefined && members.some(d => cache.holds(d, watched)))
  const key = fresh ? undefined : cacheKey(typesKey, members, scope, cache)
  const known = key === undefined ? undefined : cache?.groups.get(key)
  if (known !== undefined) {
    for (const [d, scheme] of known.schemes) s.schemes.set(d, scheme)
    for (const d of known.members) {
      const scheme = s.schemes.get(d)
      if (d.kind === "function" && scheme !== undefined) scope.set(d.name, scheme)
    }
    s.problems.push(...known.problems)
    for (const n of known.needs) s.env.needs.add(n)
    for (const d of known.unsignable) s.unsignable.add(d)
    s.groups.push(known)
    return
  }
  const outer = {
    found: s.found,
    wanted: s.wanted.length,
    problems: s.problems.length,
    schemes: s.schemes.size,
    needs: [...s.env.needs],
    holes: s.holes.length,
    improvable: s.improvable.length,
  }
  s.found = new Map()
  s.env.needs.clear()
  infer()
  const needs = [...s.env.needs]
  for (const n of outer.needs) s.env.needs.add(n)
  const types = s.found
  s.found = outer.found
  const group = {members, types}
  // What other definitions may still decide cannot be remembered, nor what binds names by a pattern.
  const closed =
    s.wanted.length === outer.wanted &&
    members.every(d => {
      const scheme = s.schemes.get(d)
      return scheme === undefined || (d.kind === "function" && metasIn(scheme.type).size === 0)
    })
  if (closed) {
    // Nothing else decides them, as of groups that are remembered; each definition goes through all that are left.
    s.settledHoles.push(...s.holes.splice(outer.holes))
    s.improvable.length = outer.improvable
  }
  if (key === undefined || !closed) {
    s.groups.push(group)
    return
  }
  const found: CachedGroup = {
    ...group,
    schemes: [...s.schemes].slice(outer.schemes),
    problems: s.problems.slice(outer.problems),
    needs,
    unsignable: members.filter(d => s.unsignable.has(d)),
  }
  cache?.groups.set(key, found)
  s.groups.push(found)
}

function cacheKey(
  typesKey: string,
  members: readonly Declaration[],
  scope: Scope,
  cache: InferenceCache,
): string | undefined {
  const own = new Set(members.flatMap(namesDefinedBy))
  const parts = [typesKey, ...members.map(d => String(cache.numberOf(d)))]
  for (const d of members)
    for (const name of cache.freeIn(d)) {
      const scheme = own.has(name) ? undefined : scope.get(name)
      if (scheme === undefined) continue
      if (metasIn(scheme.type).size > 0) return undefined
      parts.push(`${name} :: ${showScheme(scheme)}`)
    }
  return parts.join("\n")
}
