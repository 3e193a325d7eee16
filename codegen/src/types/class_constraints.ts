/// Class constraints during inference: reduction, deferral, defaulting, and errors.

import {reduce} from "./environment/unification.ts"
import type {InferenceState} from "./inference_state.ts"
import type {Constraint, Meta, Type} from "./syntax/type.ts"
import {checkSize, con, metasIn, prune, spine} from "./syntax/type.ts"
import type {Wanted} from "./syntax/type_problems.ts"

/// Whether a constraint that was stuck on an unknown type would get further by now.
function isKnownNow(c: Constraint): boolean {
  const {head, args} = spine(prune(c.type))
  if (c.name !== "Ends") return head.kind === "con"
  const controller = args[1]
  return controller !== undefined && spine(controller).head.kind === "con"
}

/// Classes that Haskell's defaulting rules accept beside a number class. (Haskell 2010 report §4.3.4)
const standardClasses = new Set(
  `Eq Ord Show Read Enum Bounded Num Real Integral Fractional Floating RealFrac RealFloat Semigroup Monoid Functor Applicative Monad Foldable Traversable`.split(
    " ",
  ),
)
const numberClasses = new Set(["Num", "Real", "Integral", "Fractional", "Floating", "RealFrac", "RealFloat"])
const fractionClasses = new Set(["Fractional", "Floating", "RealFrac", "RealFloat"])
/// Classes of what a program can send or run. No number type belongs to them, so a number there is an error and not just undecided.
export const commandClasses: ReadonlySet<string> = new Set(["Command", "Controller", "Runnable"])

/// Constraints that do not become part of a type: passed outwards, decided by default, or unanswerable.
export function deferConstraints(
  s: InferenceState,
  constraints: readonly Wanted[],
  own: ReadonlySet<Meta>,
): void {
  const open: Wanted[] = []
  for (const c of constraints) {
    const metas = [...metasIn(c.type)]
    // About a signature's variable: the definition that has the signature answers for it.
    const theirs = metas.length === 0 || metas.some(m => m.level <= s.level || own.has(m))
    if (theirs) s.wanted.push(c)
    else open.push(c)
  }
  applyDefaults(s, open, false)
}

/// The unknowns in types of which something may be decided elsewhere.
export function undecided(types: readonly Type[], found: Set<Meta> = new Set()): Set<Meta> {
  for (const type of types) {
    checkSize(type)
    metasIn(type, found)
  }
  return found
}

/// Decides unknown number types as Haskell does; complains about what nothing decides. (Haskell 2010 report §4.3.4)
function applyDefaults(s: InferenceState, constraints: readonly Wanted[], constants: boolean): void {
  const groups = new Map<Meta, Wanted[]>()
  for (const c of constraints) {
    const [first] = metasIn(c.type)
    if (first === undefined || c.name === "Ends") continue
    groups.set(first, [...(groups.get(first) ?? []), c])
  }
  // All unknown types of the program are gone through only where there is something to decide.
  if (groups.size === 0) return
  const holes = undecided(s.holes, undecided(s.improvable))
  for (const [meta, group] of groups) {
    if (meta.is !== undefined) continue
    const numeric = group.some(c => numberClasses.has(c.name)) && group.every(c => prune(c.type) === meta)
    const standard = group.every(c => standardClasses.has(c.name))
    if (holes.has(meta)) continue
    if (numeric && (standard || constants)) {
      const whole =
        group.some(c => c.name === "Integral") ||
        (!constants && !group.some(c => fractionClasses.has(c.name)))
      meta.is = con(whole ? "Integer" : "Double")
      for (const c of group) {
        const r = reduce(c, s.env)
        if (r.kind === "no") s.problems.push({kind: "no-instance", node: c.node, constraint: r.constraint})
      }
      continue
    }
    const [first] = group
    const command = group.find(c => commandClasses.has(c.name) && prune(c.type) === meta)
    if (command !== undefined && numeric && !s.lenient) {
      s.problems.push({
        kind: "no-instance",
        node: command.node,
        constraint: {...command, type: con("Double")},
      })
      continue
    }
    if (first !== undefined && !s.lenient)
      s.problems.push({kind: "ambiguous", node: first.node, constraint: first})
  }
}

export function solveRemaining(s: InferenceState): void {
  const {stuck} = reduceConstraints(s, s.wanted, [])
  s.wanted = []
  // Constants whose number type no use decided: a measure, so a Double unless something asks for whole numbers.
  applyDefaults(
    s,
    stuck.filter(c => metasIn(c.type).size > 0),
    true,
  )
}

/// Whether a constraint may become part of an inferred type, as `Num [a]` does with FlexibleContexts.
function mayStandInType({type}: Constraint, {env}: InferenceState): boolean {
  return env.extensions?.has("FlexibleContexts") === true && metasIn(type).size > 0
}

export function reduceConstraints(
  s: InferenceState,
  wanted: readonly Wanted[],
  givens: readonly Constraint[],
): {stuck: Wanted[]} {
  for (const w of wanted) checkSize(w.type)
  let stuck: Wanted[] = []
  let todo = wanted
  // `Ends` decides types while it is reduced, so what was stuck before it may be known after it.
  do {
    stuck = []
    for (const w of todo) {
      const r = reduce(w, s.env, givens)
      if (r.kind === "no" && mayStandInType(r.constraint, s)) s.env.assumed.push(r.constraint)
      else if (r.kind === "no") s.problems.push({kind: "no-instance", node: w.node, constraint: r.constraint})
      else for (const c of r.constraints) stuck.push({...c, node: w.node})
    }
    todo = stuck
  } while (stuck.some(isKnownNow))
  return {stuck}
}
