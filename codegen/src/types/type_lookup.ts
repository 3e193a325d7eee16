/// Types of names, constructors, operators and written signatures, as they are used at one place.

import {isFractionalLiteral, unqualified} from "../haskell/lexemes.ts"
import type {Expr, Node} from "../model/syntax_tree.ts"
import {expand} from "./environment/environment.ts"
import {isKnownClass, misappliedType, typeNamesIn} from "./environment/kinds.ts"
import {unify} from "./environment/unification.ts"
import type {InferenceState} from "./inference_state.ts"
import {freshMeta, inferWithinBounds, unknownType} from "./inference_state.ts"
import {Scope} from "./syntax/scope.ts"
import type {Scheme, Type} from "./syntax/type.ts"
import {asFunction, con, funs, listOf, prune, spine, substitute, tupleOf} from "./syntax/type.ts"
import {
  apartFromForall,
  isBeyondHaskell2010,
  isHigherRank,
  isTooLarge,
  parseScheme,
  withQualifiersApart,
} from "./syntax/type_parser.ts"
import type {TypeProblem} from "./syntax/type_problems.ts"

/// Names of types and classes without a qualifier.
const unqualifiedNames = /(?<![\p{L}\p{N}_'.])\p{Lu}[\p{L}\p{N}_']*(?![\p{L}\p{N}_'.])/gu

/// The last parts of names with a qualifier.
const qualifiedNames = /\p{Lu}[\p{L}\p{N}_'.]*\.(\p{Lu}[\p{L}\p{N}_']*)/gu

/// The signature of a definition, where a `forall` may stand in front.
export function readDefinitionSignature(s: InferenceState, text: string, node: Node): Scheme | undefined {
  const {variables, type} = apartFromForall(text)
  if (variables.length === 0) return readSignature(s, text, node)
  // Where a `forall` stands, there is often more that inference does not read.
  if (!isBeyondInference(s, type) && parseScheme(withQualifiersApart(type, s.env)) === undefined)
    return undefined
  const {scoped} = s
  s.scoped = new Map([...scoped].filter(([name]) => !variables.includes(name)))
  const scheme = readSignature(s, type, node)
  s.scoped = scoped
  // A variable beside those of the `forall` has no meaning; GHC says so.
  if (scheme === undefined || scheme.variables.some(name => !variables.includes(name))) return undefined
  return {...scheme, scoped: variables}
}

/// A type with variables of its own inside, or one that is too large: GHC's to judge.
export function isBeyondInference(s: InferenceState, text: string): boolean {
  return isHigherRank(text, s.env.ranked) || isTooLarge(text) || s.largeTypes.has(text)
}

// --- Types as they are written -----------------------------------------------------------------------------------

export function readSignature(s: InferenceState, text: string, node: Node): Scheme | undefined {
  if (isBeyondInference(s, text)) return undefined
  let scheme: Scheme | undefined
  if (!inferWithinBounds(s, () => (scheme = readScheme(s, text, node)))) s.largeTypes.add(text)
  return scheme
}

function readScheme(s: InferenceState, text: string, node: Node): Scheme | undefined {
  const scheme = parseScheme(withQualifiersApart(text, s.env))
  // `Int => Int`: a type is no constraint; what is imported may be a name for one.
  const isType = (name: string) => s.env.types.get(name)?.foreign === undefined && s.env.types.has(name)
  if (scheme === undefined || scheme.bare?.some(isType) === true) {
    const isOwnOperator = [...text.matchAll(/[-=>]+/g)].some(([op]) =>
      [op, op.replace("->", "→").replace("=>", "⇒")].some(name => s.env.types.has(name)),
    )
    if (text.trim() !== "" && !isBeyondHaskell2010(text) && !isOwnOperator)
      s.problems.push({kind: "bad-signature", node, text})
    return undefined
  }
  checkTypeNames(s, scheme, text, node)
  const here = (type: Type) => substitute(expand(type, s.env), s.scoped)
  return {
    variables: scheme.variables.filter(name => !s.scoped.has(name)),
    constraints: scheme.constraints.map(c => ({name: c.name, type: here(c.type)})),
    type: here(scheme.type),
  }
}

/// Reports unknown and hidden types, unknown classes, and types with too few or too many arguments. A name with a qualifier belongs to an import,
/// and any name may come from a module whose exports are unknown.
function checkTypeNames(s: InferenceState, scheme: Scheme, text: string, node: Node): void {
  const strangers = [...text.matchAll(qualifiedNames)].flatMap(([name]) =>
    isQualifier(s, name.slice(0, name.lastIndexOf("."))) ? [] : [name],
  )
  for (const name of new Set(strangers)) s.problems.push({kind: "unknown-type", node, name})
  if (s.env.open === true || strangers.length > 0) return
  const qualified = new Set([...text.matchAll(qualifiedNames)].map(([, name = ""]) => name))
  // A constructor may stand for a type.
  const isPromoted = (name: string) =>
    s.env.extensions?.has("DataKinds") === true && s.env.constructors.has(name)
  const problems = new Map<string, TypeProblem>()
  for (const name of typeNamesIn(scheme.type))
    if (
      !s.env.types.has(name) &&
      !isKnownClass(s.env, name) &&
      !isPromoted(name) &&
      !qualified.has(name.replace(/'.*$/, "")) &&
      !/^(?:->|\[\]|\(,*\))$/.test(name)
    )
      problems.set(name, {kind: "unknown-type", node, name})
  for (const [name] of text.matchAll(unqualifiedNames))
    if (s.env.hidden.has(name) && !isPromoted(name)) problems.set(name, {kind: "unknown-type", node, name})
  for (const {name} of scheme.constraints)
    if (!qualified.has(name) && !isKnownClass(s.env, name))
      problems.set(name, {kind: "unknown-class", node, name})
  s.problems.push(...problems.values())
  if (problems.size > 0) return
  const wrong = misappliedType(scheme.type, s.env)
  if (wrong !== undefined) s.problems.push({kind: "kind", node, name: wrong})
}

/// What may stand before the dot of a name: a module that is imported, also without being named, or the program's own.
function isQualifier(s: InferenceState, name: string): boolean {
  return (
    s.env.qualifiers?.has(name) === true || ["Prelude", "Rosy", s.env.moduleName ?? "Main"].includes(name)
  )
}

// --- Names and unification --------------------------------------------------------------------------------------

export function typeOfName(s: InferenceState, name: string, node: Node, scope: Scope): Type {
  const scheme = scope.get(name) ?? s.env.values.get(name)
  if (scheme !== undefined) return instantiate(s, scheme, node)
  if (s.lenient) {
    const stray = s.strays.get(name) ?? freshMeta(s)
    s.strays.set(name, stray)
    return stray
  }
  return typeOfUndefinedName(s, name, node)
}

/// The type of a name that nothing in scope defines.
function typeOfUndefinedName(s: InferenceState, name: string, node: Node): Type {
  if (isPossiblyImported(s, name)) s.undefinedNames.set(node, name)
  else s.problems.push({kind: "unknown-name", node, name})
  return unknownType(s, name)
}

/// Whether a name may come from a module whose exports are unknown.
export function isPossiblyImported(s: InferenceState, name: string): boolean {
  const qualifier = /^(.*)\.[^.]/.exec(name)?.[1]
  return s.env.open === true || (qualifier !== undefined && isQualifier(s, qualifier))
}

export function typeOfOperator(s: InferenceState, op: string, node: Expr, scope: Scope): Type {
  if (op === ":") {
    const item = freshMeta(s)
    return funs([item, listOf(item)], listOf(item))
  }
  return /^[:\p{Lu}]/u.test(unqualified(op)) ? typeOfConstructor(s, op, node) : typeOfName(s, op, node, scope)
}

export function typeOfConstructor(s: InferenceState, name: string, node: Node): Type {
  if (name === "()") return con("()")
  if (name === "[]") return listOf(freshMeta(s))
  if (name === ":") return typeOfOperator(s, ":", node as Expr, new Scope())
  if (/^\(,+\)$/.test(name)) {
    const items = [...name.slice(1)].map(() => freshMeta(s))
    return funs(items, tupleOf(items))
  }
  const info = s.env.constructors.get(name)
  return info === undefined ? typeOfUndefinedName(s, name, node) : instantiate(s, info.scheme, node)
}

/// The name that an expression or pattern stands for.
function nameOf(node: Node): string | undefined {
  if (node.kind === "infix" || node.kind === "section") return node.op
  return "name" in node ? node.name : undefined
}

export function instantiate(s: InferenceState, scheme: Scheme, node: Node): Type {
  const name = nameOf(node)
  if (scheme.unknown === true) return unknownType(s, name)
  if (scheme.variables.length === 0) {
    for (const c of scheme.constraints) requireClass(s, c.name, c.type, node)
    return expand(scheme.type, s.env)
  }
  const isOpen = (v: string) => scheme.open?.includes(v) === true
  const by = new Map(scheme.variables.map(v => [v, isOpen(v) ? unknownType(s, name) : freshMeta(s)] as const))
  for (const c of scheme.constraints) requireClass(s, c.name, substitute(c.type, by), node)
  return expand(substitute(scheme.type, by), s.env)
}

function nameOfHead(type: Type): string {
  const {head} = spine(type)
  return head.kind === "con" ? head.name : ""
}

export function requireClass(s: InferenceState, name: string, type: Type, node: Node): void {
  s.wanted.push({name, type, node})
  const {classes, ownClasses, importedClasses} = s.env
  const isOfSeveral = /^\(,+\)$/.test(nameOfHead(type))
  const isKnown = classes.has(name) || ownClasses?.has(name) === true
  if (!isKnown && (isOfSeveral || importedClasses?.has(name) !== true)) s.improvable.push(type)
}

/// The class of a number in the program. With NumDecimals, `1e3` is a whole number.
export function classOfLiteral(s: InferenceState, text: string): "Num" | "Fractional" {
  const isWhole =
    s.env.extensions?.has("NumDecimals") === true && Number.isInteger(Number(text.replaceAll("_", "")))
  return isFractionalLiteral(text.replace("-", "")) && !isWhole ? "Fractional" : "Num"
}

export function unifyAt(s: InferenceState, wanted: Type, found: Type, node: Node): void {
  const clash = unify(wanted, found)
  if (clash === undefined) return
  if (clash.isUnread) {
    s.unreadClashes.push(clash)
    s.holes.push(wanted, found)
    return
  }
  const isOfVariable = [clash.left, clash.right].some(t => prune(t).kind === "var")
  s.problems.push({kind: "mismatch", node, wanted, found, isOfVariable})
}

export function openConstructor(
  s: InferenceState,
  scheme: Scheme,
  count: number,
  node: Node,
): {fields: Type[]; result: Type} {
  let result = instantiate(s, scheme, node)
  const fields: Type[] = []
  for (let i = 0; i < count; i++) {
    const f = asFunction(result)
    if (f === undefined) break
    fields.push(f.from)
    result = f.to
  }
  return {fields, result}
}
