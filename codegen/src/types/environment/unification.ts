/// Unification and class constraints.

import type {Constraint, Meta, Type} from "../syntax/type.ts"
import {app, con, mostLevels, mostNodes, prune, spine, substitute, TypeTooLarge} from "../syntax/type.ts"
import type {Environment} from "./environment.ts"
import {builtInHeads, expand} from "./environment.ts"

export interface Rigid {
  readonly kind: "var"
  readonly name: string
  /// Made for one signature while its function is checked.
  readonly id: number
  readonly level: number
}

/// Two parts of types that are not the same. `isUnread`: one of them has a name whose meaning was not read, so they may be the same all the same.
export interface Clash {
  readonly left: Type
  readonly right: Type
  readonly isUnread: boolean
}

/// Makes two types equal, or answers the two parts that are not.
export function unify(a: Type, b: Type): Clash | undefined {
  return unifyParts(a, b, {nodes: 0})
}

function unifyParts(a: Type, b: Type, seen: {nodes: number}): Clash | undefined {
  const l = prune(a)
  const r = prune(b)
  if (l === r) return undefined
  if (l.kind === "meta") return bind(l, r) ? undefined : {left: l, right: r, isUnread: hasUnreadPart(r)}
  if (r.kind === "meta") return bind(r, l) ? undefined : {left: l, right: r, isUnread: hasUnreadPart(l)}
  if (mayBeAnything(l, r)) return {left: l, right: r, isUnread: true}
  if (l.kind === "con" && r.kind === "con" && l.name === r.name) return undefined
  if (l.kind === "var" && r.kind === "var" && l.name === r.name && (l as Rigid).id === (r as Rigid).id)
    return undefined
  if (l.kind === "app" && r.kind === "app") {
    if (++seen.nodes > mostNodes) throw new TypeTooLarge()
    return unifyParts(l.fn, r.fn, seen) ?? unifyParts(l.arg, r.arg, seen)
  }
  return {left: l, right: r, isUnread: false}
}

/// Whether one of two types has an unread name as its head that the other has not, with as many arguments.
function mayBeAnything(left: Type, right: Type): boolean {
  const [l, r] = [headOf(left), headOf(right)]
  if (!isUnread(l.head) && !isUnread(r.head)) return false
  const isSame = l.head.kind === "con" && r.head.kind === "con" && l.head.name === r.head.name
  return !isSame || l.count !== r.count
}

function headOf(type: Type): {readonly head: Type; readonly count: number} {
  let head = prune(type)
  let count = 0
  for (; head.kind === "app"; head = prune(head.fn)) count++
  return {head, count}
}

function isUnread(type: Type): boolean {
  return type.kind === "con" && type.isUnread === true
}

/// Whether a type has a part whose meaning was not read.
export function hasUnreadPart(type: Type): boolean {
  return unreadNameIn(type) !== undefined
}

/// The first name in a type whose meaning was not read.
export function unreadNameIn(type: Type): string | undefined {
  const t = prune(type)
  if (t.kind === "con") return isUnread(t) ? t.name : undefined
  return t.kind === "app" ? (unreadNameIn(t.fn) ?? unreadNameIn(t.arg)) : undefined
}

/// Occurs check, level adjustment and measure in one walk. A rigid variable cannot get into a type from outside its signature.
function bind(meta: Meta, type: Type): boolean {
  if (!mayHold(meta, type, {nodes: 0}, 0)) return false
  lower(meta.level, type)
  meta.is = type
  return true
}

function mayHold(meta: Meta, type: Type, seen: {nodes: number}, levels: number): boolean {
  const t = prune(type)
  if (t === meta) return false
  if (++seen.nodes > mostNodes || levels > mostLevels) throw new TypeTooLarge()
  if (t.kind === "var") return ((t as Partial<Rigid>).level ?? 0) <= meta.level
  return t.kind !== "app" || (mayHold(meta, t.fn, seen, levels + 1) && mayHold(meta, t.arg, seen, levels + 1))
}

function lower(level: number, type: Type): void {
  const t = prune(type)
  if (t.kind === "meta" && t.level > level) t.level = level
  if (t.kind === "app") {
    lower(level, t.fn)
    lower(level, t.arg)
  }
}

/// What a constraint comes down to: nothing, constraints on unknowns or variables, or a failure.
export type Reduced =
  | {readonly kind: "stuck"; readonly constraints: readonly Constraint[]}
  | {readonly kind: "no"; readonly constraint: Constraint}

export function reduce(
  wanted: Constraint,
  env: Environment,
  givens: readonly Constraint[] = [],
  depth = 0,
): Reduced {
  const type = prune(wanted.type)
  const {head, args} = spine(type)
  if (givens.some(g => superclasses(g.name, env).has(wanted.name) && sameType(g.type, type)))
    return {kind: "stuck", constraints: []}
  if (wanted.name === "Ends") return reduceEnds(type, env)
  if (wanted.name === "Typeable" && head.kind === "con")
    return reduceAll(
      args.map(a => ({name: "Typeable", type: a})),
      env,
      givens,
      depth,
    )
  const instances = env.instances.get(wanted.name)
  const catchAll = instances?.get("*")
  const everything = catchAll === "none" ? undefined : catchAll
  if (head.kind !== "con") {
    // Rosy shows a value of any type somehow: its catch-all instance is chosen also while the type is open.
    if (everything !== undefined && wanted.name === "Value")
      return applyInstance(everything, wanted, args, env, givens, depth)
    return {kind: "stuck", constraints: [{name: wanted.name, type}]}
  }
  if (env.ownClasses?.has(wanted.name) === true) {
    if (lacksInstance(wanted.name, head.name, args, env, givens, depth))
      return {kind: "no", constraint: {name: wanted.name, type}}
    if (env.derived?.has(`${wanted.name} ${head.name}`) !== true) env.assumed.push({name: wanted.name, type})
    return {kind: "stuck", constraints: []}
  }
  const assumed = (): Reduced => {
    env.assumed.push({name: wanted.name, type})
    return {kind: "stuck", constraints: []}
  }
  // An unknown class is left to GHC.
  if (!env.classes.has(wanted.name)) return assumed()
  const instance = instances?.get(head.name) ?? everything
  const entry = env.types.get(head.name)
  // What a type from elsewhere can do, only GHC knows.
  if (
    instance === undefined &&
    (entry === undefined || entry.foreign === true) &&
    !builtInHeads.test(head.name)
  )
    return assumed()
  if (instance === undefined || instance === "none" || depth > 50)
    return {kind: "no", constraint: {name: wanted.name, type}}
  if (entry?.own === true && env.written?.has(`${wanted.name} ${head.name}`) !== true)
    env.needs.add(`${wanted.name} ${head.name}`)
  return applyInstance(instance, wanted, args, env, givens, depth)
}

/// Whether a type certainly does not belong to a class of the program: no instance is about its head or about all types, and it does not derive
/// the class; or its only instance asks for something that its arguments lack.
function lacksInstance(
  of: string,
  head: string,
  args: readonly Type[],
  env: Environment,
  givens: readonly Constraint[],
  depth: number,
): boolean {
  const all = env.ownInstances?.get(of)
  const entry = env.types.get(head)
  if (all === undefined || (entry === undefined ? !builtInHeads.test(head) : entry.foreign === true))
    return false
  if (depth > 50 || env.derived?.has(`${of} ${head}`) === true) return false
  const possible = all
    .map(i => ({...i, type: expand(i.type, env)}))
    .filter(i => {
      const own = spine(i.type).head
      return own.kind !== "con" || own.name === head
    })
  const [only] = possible
  if (only === undefined) return true
  const formal = spine(only.type).args
  if (possible.length > 1 || spine(only.type).head.kind !== "con" || formal.length !== args.length)
    return false
  const by = new Map(formal.flatMap((f, i) => (f.kind === "var" ? [[f.name, args[i] as Type] as const] : [])))
  if (by.size < formal.length) return false
  const needed = only.constraints.map(c => ({name: c.name, type: substitute(c.type, by)}))
  return reduceAll(needed, env, givens, depth).kind === "no"
}

function reduceAll(
  all: readonly Constraint[],
  env: Environment,
  givens: readonly Constraint[],
  depth: number,
): Reduced {
  const constraints: Constraint[] = []
  for (const c of all) {
    const r = reduce(c, env, givens, depth + 1)
    if (r.kind === "no") return r
    constraints.push(...r.constraints)
  }
  return {kind: "stuck", constraints}
}

/// `Ends end ctrl`: every `Done` that a task's controller sends carries what the task ends with (rosy-hs/src/Rosy/Command.hs).
/// Here the two types become one; outside a task a `Done` has no place at all.
function reduceEnds(type: Type, env: Environment): Reduced {
  const [end, of] = spine(type).args
  if (end === undefined || of === undefined) return {kind: "stuck", constraints: []}
  const {head, args} = spine(of)
  const inner = (parts: readonly Type[]): Reduced => {
    const constraints: Constraint[] = []
    for (const part of parts) {
      const r = reduceEnds(app(con("(,)"), end, part), env)
      if (r.kind === "no") return r
      constraints.push(...r.constraints)
    }
    return {kind: "stuck", constraints}
  }
  if (head.kind === "meta") return {kind: "stuck", constraints: [{name: "Ends", type}]}
  if (head.kind !== "con") return {kind: "stuck", constraints: []}
  const [first, second] = args
  if (head.name === "Done" && first !== undefined)
    return unify(end, first)?.isUnread !== false
      ? {kind: "stuck", constraints: []}
      : {kind: "no", constraint: {name: "Ends", type}}
  if (head.name === "->" && second !== undefined) return inner([second])
  return ["Maybe", "[]", "Either", "Priority"].includes(head.name) || /^\(,+\)$/.test(head.name)
    ? inner(args)
    : {kind: "stuck", constraints: []}
}

function applyInstance(
  instance: {readonly constraints: readonly Constraint[]; readonly type: Type},
  wanted: Constraint,
  args: readonly Type[],
  env: Environment,
  givens: readonly Constraint[],
  depth: number,
): Reduced {
  const {head, args: formal} = spine(instance.type)
  const by = new Map<string, Type>()
  if (head.kind === "var") by.set(head.name, wanted.type)
  else {
    if (formal.length !== args.length) return {kind: "no", constraint: wanted}
    for (const [i, f] of formal.entries()) {
      const actual = args[i]
      if (actual === undefined) continue
      if (f.kind === "var") by.set(f.name, actual)
      // An instance for `[Char]` and its like: only that type.
      else if (prune(actual).kind !== "meta" && !sameType(f, actual) && !hasUnreadPart(actual))
        return {kind: "no", constraint: wanted}
    }
  }
  const constraints: Constraint[] = []
  for (const c of instance.constraints) {
    const r = reduce({name: c.name, type: substitute(c.type, by)}, env, givens, depth + 1)
    if (r.kind === "no")
      return depth === 0 && !["Controller", "Runnable"].includes(wanted.name)
        ? {kind: "no", constraint: r.constraint}
        : r
    constraints.push(...r.constraints)
  }
  return {kind: "stuck", constraints}
}

export function sameType(a: Type, b: Type): boolean {
  const l = prune(a)
  const r = prune(b)
  if (l === r) return true
  if (l.kind === "con" && r.kind === "con") return l.name === r.name
  if (l.kind === "var" && r.kind === "var") return l.name === r.name && (l as Rigid).id === (r as Rigid).id
  return l.kind === "app" && r.kind === "app" && sameType(l.fn, r.fn) && sameType(l.arg, r.arg)
}

/// Constraints without repetitions and without those that follow from another.
export function simplify(constraints: readonly Constraint[], env: Environment): Constraint[] {
  const kept: Constraint[] = []
  for (const [i, c] of constraints.entries()) {
    const follows = constraints.some(
      (other, j) =>
        i !== j &&
        sameType(other.type, c.type) &&
        (other.name === c.name ? j < i : superclasses(other.name, env).has(c.name)),
    )
    if (!follows) kept.push(c)
  }
  return kept
}

/// All classes that follow from one: `Ord` gives `Ord` and `Eq`.
export function superclasses(name: string, env: Environment, found: Set<string> = new Set()): Set<string> {
  if (found.has(name)) return found
  found.add(name)
  for (const s of env.classes.get(name) ?? []) superclasses(s, env, found)
  return found
}
