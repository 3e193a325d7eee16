/// Type inference for instances: methods against the types that their class gives them, superclasses, duplicate instances.

import type {Declaration, FunctionDeclaration, InstanceDeclaration} from "../model/syntax_tree.ts"
import {checkAgainstSignature, inferClauses, inferRightHandSide, rigidVariables} from "./binding_inference.ts"
import {reduceConstraints} from "./class_constraints.ts"
import {instanceHead} from "./environment/declaration_scanner.ts"
import {builtInHeads, expand} from "./environment/environment.ts"
import {isKnownClass} from "./environment/kinds.ts"
import {library} from "./environment/standard_library.ts"
import type {InferenceState} from "./inference_state.ts"
import {freshMeta, unknownType} from "./inference_state.ts"
import {inferPattern} from "./pattern_inference.ts"
import type {Scope} from "./syntax/scope.ts"
import type {Scheme, Type} from "./syntax/type.ts"
import {app, showType, spine, substitute, variablesIn} from "./syntax/type.ts"
import type {Wanted} from "./syntax/type_problems.ts"
import {readDefinitionSignature, unifyAt} from "./type_lookup.ts"

type InstanceHead = NonNullable<ReturnType<typeof instanceHead>>

/// Methods have the types that their class gives them. Where only GHC knows these, what stands inside goes together all the same.
export function inferInstance(s: InferenceState, d: InstanceDeclaration, outer: Scope): void {
  const head = /^instance\b/.test(d.head) ? instanceHead(d.head) : undefined
  // What follows from a class of the program's own is not read.
  const plain = head?.instance.constraints.every(c => s.env.classes.has(c.name)) === true
  if (head !== undefined && plain) checkSuperclasses(s, d, head)
  if (head !== undefined && !head.isQualified && !isKnownClass(s.env, head.name))
    s.problems.push({kind: "unknown-class", node: d, name: head.name})
  const seen = new Set<string>()
  for (const method of d.declarations) {
    if (method.kind === "raw-declaration" || (method.kind === "function" && method.clauses.length === 0))
      continue
    const name = method.kind === "function" ? method.name : ""
    const type = head !== undefined && name !== "" ? typeOfMethod(s, name, head, outer) : undefined
    if (head !== undefined && type === undefined && hasKnownMembers(s, head.name, name))
      s.problems.push({kind: "no-method", node: method, name, of: head.name})
    if (name !== "" && seen.has(name)) s.problems.push({kind: "twice", node: method, name})
    seen.add(name)
    if (method.kind === "function" && type !== undefined && plain) checkMethod(s, method, type, head, outer)
    else inferUnknownMethod(s, method, outer, d.head)
  }
}

/// Whether all that belongs to a class is known, and s is not among it.
function hasKnownMembers(s: InferenceState, of: string, name: string): boolean {
  const known = s.env.classes.has(of) || s.env.ownClasses?.has(of) === true
  return known && s.env.values.get(name)?.unknown !== true && s.env.open !== true
}

/// With a type of its own, which may say more than the class asks for.
function checkMethod(
  s: InferenceState,
  d: FunctionDeclaration,
  type: Scheme,
  {instance}: InstanceHead,
  outer: Scope,
): void {
  const own =
    d.signature === undefined ? undefined : readDefinitionSignature(s, d.signature.text, d.signature)
  if (own === undefined || d.signature === undefined) {
    checkAgainstSignature(s, d, type, outer, variablesIn(instance.type))
    return
  }
  const wanted = substitute(type.type, rigidVariables(s, type.variables))
  // The unknowns of the signature belong to the method, like the variables that the class promises to work for.
  s.level++
  unifyAt(s, wanted, substitute(own.type, new Map(own.variables.map(v => [v, freshMeta(s)]))), d.signature)
  s.level--
  const constraints = [...instance.constraints, ...own.constraints]
  const variables = [...new Set([...own.variables, ...variablesIn(instance.type)])]
  checkAgainstSignature(s, d, {...own, variables, constraints}, outer, variablesIn(instance.type))
}

/// A type belongs to a class once: by one instance, or derived.
export function checkDuplicateInstances(s: InferenceState, declarations: readonly Declaration[]): void {
  const seen = new Set(
    declarations.flatMap(d => (d.kind === "data" ? d.deriving.map(of => `${of} ${d.name}`) : [])),
  )
  for (const d of declarations) {
    const head = d.kind === "instance" && /^instance\b/.test(d.head) ? instanceHead(d.head) : undefined
    if (head === undefined) continue
    const {head: type, args} = spine(expand(head.instance.type, s.env))
    if (type.kind !== "con") continue
    // Instances for `[Int]` and `[Char]` are two; one for each variable is about the whole type.
    const general = args.every(a => a.kind === "var")
    // `T.Text` and `L.Text` may be two types, and what is not read may be another name for any.
    const written = d.kind === "instance" ? d.head : ""
    const named = /\p{Lu}[\p{L}\p{N}_']*\.\p{Lu}/u.test(written)
      ? written.replace(/^.*=>|\s+/gs, " ")
      : `${head.name} ${general ? type.name : showType(app(type, ...args))}`
    if (seen.has(named) || (general && hasPreludeInstance(s, head, type.name)))
      s.problems.push({kind: "second-instance", node: d, name: type.name, of: head.name})
    seen.add(named)
  }
}

/// Whether an instance for all types of this head comes with the Prelude. Both names must be the Prelude's.
function hasPreludeInstance(s: InferenceState, {name: of, isQualified}: InstanceHead, type: string): boolean {
  const isOwn = s.env.ownClasses?.has(of) === true || s.env.ownTypes?.has(type) === true
  if (isOwn || isQualified || s.env.open === true) return false
  if (!s.env.fixed.has(of) || !(s.env.fixed.has(type) || builtInHeads.test(type))) return false
  const known = library.instances.get(of)?.get(type)
  return known !== undefined && known !== "none" && spine(known.type).args.every(a => a.kind === "var")
}

/// The variables of an instance's or a class's head stand for something that its methods do not decide.
function inferUnknownMethod(s: InferenceState, method: Declaration, outer: Scope, head: string): void {
  const {scoped, wanted: before} = s
  const variables = head.match(/(?<![\p{L}\p{N}_'.])[\p{Ll}_][\p{L}\p{N}_']*/gu) ?? []
  s.scoped = new Map([...scoped, ...variables.map(v => [v, unknownType(s)] as const)])
  s.level++
  const scope = outer.inner()
  const type = unknownType(s)
  if (method.kind === "function") inferClauses(s, method, type, scope)
  if (method.kind === "binding") {
    inferPattern(s, method.pattern, type, scope)
    inferRightHandSide(s, method.right, type, scope)
  }
  s.level--
  s.wanted = before
  s.scoped = scoped
}

/// `show :: Show a => a -> String` is `Mode -> String` in `instance Show Mode`.
function typeOfMethod(
  s: InferenceState,
  name: string,
  {name: of, instance}: InstanceHead,
  outer: Scope,
): Scheme | undefined {
  const method = outer.get(name) === undefined ? s.env.values.get(name) : undefined
  const own = method?.constraints.find(c => c.name === of && c.type.kind === "var")
  if (method === undefined || own?.type.kind !== "var") return undefined
  const taken = variablesIn(instance.type)
  const variables = [...taken]
  const by = new Map<string, Type>([[own.type.name, instance.type]])
  for (const v of method.variables) {
    if (v === own.type.name) continue
    // Two variables that only share their letter stay two.
    const fresh = taken.has(v) ? `${v}'` : v
    by.set(v, {kind: "var", name: fresh})
    variables.push(fresh)
  }
  const rest = method.constraints.filter(c => c !== own)
  return {
    variables,
    constraints: [
      ...instance.constraints,
      ...rest.map(c => ({name: c.name, type: expand(substitute(c.type, by), s.env)})),
    ],
    type: expand(substitute(method.type, by), s.env),
  }
}

/// What belongs to a class belongs to those that it builds on: `Eq` with `Ord`. Such an instance of an own type may be derived.
function checkSuperclasses(
  s: InferenceState,
  d: InstanceDeclaration,
  {name: of, instance}: InstanceHead,
): void {
  const rigid = rigidVariables(s, variablesIn(instance.type))
  const type = expand(substitute(instance.type, rigid), s.env)
  const givens = instance.constraints.map(c => ({name: c.name, type: substitute(c.type, rigid)}))
  const superclasses = s.env.superclasses?.get(of) ?? s.env.classes.get(of) ?? []
  const wanted = superclasses.map((name): Wanted => ({name, type, node: d}))
  for (const c of reduceConstraints(s, wanted, givens).stuck)
    s.problems.push({kind: "too-general", node: d, constraint: c})
}
