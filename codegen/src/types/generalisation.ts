/// Generalisation: the unknowns that belong to definitions become variables of their types.

import {bindersIn} from "../model/name_resolution.ts"
import type {Declaration} from "../model/syntax_tree.ts"
import {deferConstraints, undecided} from "./class_constraints.ts"
import {simplify} from "./environment/unification.ts"
import type {InferenceState} from "./inference_state.ts"
import type {Scope} from "./syntax/scope.ts"
import type {Meta, Scheme, Type} from "./syntax/type.ts"
import {checkSize, metasIn, variablesIn} from "./syntax/type.ts"
import type {Wanted} from "./syntax/type_problems.ts"

/// Turns the unknowns that belong to these definitions into variables of their types. Definitions without parameters keep
/// constrained unknowns for their uses to decide (Haskell 2010 report §4.5.5, the monomorphism restriction).
export function generalise(
  s: InferenceState,
  members: readonly Declaration[],
  types: ReadonlyMap<Declaration, Type>,
  stuck: readonly Wanted[],
  scope: Scope,
  top: boolean,
): void {
  const restricted = members.some(
    d => d.kind === "binding" || (d.kind === "function" && d.clauses.every(c => c.patterns.length === 0)),
  )
  for (const type of types.values()) checkSize(type)
  const own = new Set<Meta>()
  for (const type of types.values()) for (const m of metasIn(type)) if (m.level > s.level) own.add(m)
  if (restricted)
    for (const c of stuck)
      for (const m of metasIn(c.type)) {
        own.delete(m)
        if (m.level > s.level && isReachable(types, m)) m.level = s.level
      }
  // A hole's type is still open: what goes into it may decide it, so it is not general.
  const quantified: Wanted[] = []
  const rest: Wanted[] = []
  const improvable = undecided(s.improvable)
  for (const c of stuck) {
    const metas = [...metasIn(c.type)]
    if (!metas.some(m => own.has(m))) rest.push(c)
    // Partly about something that no use can ever decide.
    else if (c.name !== "Ends" && metas.some(m => m.level > s.level && !own.has(m) && !improvable.has(m)))
      s.problems.push({kind: "ambiguous", node: c.node, constraint: c})
    else quantified.push(c)
  }
  deferConstraints(s, rest, own)
  const names = new Map<Meta, string>()
  const taken = new Set(s.scoped.keys())
  for (const type of types.values()) variablesIn(type, taken)
  const alive = [...own].filter(m => m.is === undefined)
  // What only GHC knows may turn out to be less general than it looks.
  const open = new Set<Meta>()
  const foreign = new Set<Meta>()
  if (alive.length > 0)
    for (const h of s.holes) {
      checkSize(h)
      metasIn(h, open)
      if (!s.sockets.has(h)) metasIn(h, foreign)
    }
  if (top && alive.some(m => open.has(m))) for (const d of members) s.unsignable.add(d)
  const openNames = new Set<string>()
  for (const m of alive) {
    const name = letterFor(names.size, taken)
    names.set(m, name)
    if (foreign.has(m)) openNames.add(name)
  }
  // GHC settles an open `Ends` with its catch-all instance, so it never stands in a type.
  const constraints = simplify(
    quantified.filter(c => c.name !== "Ends"),
    s.env,
  )
  for (const [m, name] of names) m.is = {kind: "var", name}
  // Definitions that use each other have the same constraints, so the type of each must say what they are about.
  if (types.size > 1)
    for (const c of quantified)
      if (c.name !== "Ends" && [...types.values()].some(type => !within(c.type, type)))
        s.problems.push({kind: "ambiguous", node: c.node, constraint: c})
  setSchemes(s, members, types, constraints, names, openNames, scope)
}

/// Records the general type of each definition, and of each name that a pattern binds.
function setSchemes(
  s: InferenceState,
  members: readonly Declaration[],
  types: ReadonlyMap<Declaration, Type>,
  constraints: Scheme["constraints"],
  names: ReadonlyMap<Meta, string>,
  openNames: ReadonlySet<string>,
  scope: Scope,
): void {
  for (const d of members) {
    const type = types.get(d)
    if (type === undefined) continue
    const variables = [...variablesIn(type)].filter(v => [...names.values()].includes(v))
    const scheme: Scheme = {
      variables,
      constraints: constraints.filter(c => [...variablesIn(c.type)].every(v => variables.includes(v))),
      type,
      ...openIn(variables, openNames),
    }
    s.schemes.set(d, scheme)
    if (d.kind === "function") scope.set(d.name, scheme)
    // Each name that a pattern takes out is as general by itself.
    else if (d.kind === "binding")
      for (const [name] of bindersIn(d.pattern)) {
        const part = scope.get(name)?.type
        if (part === undefined) continue
        const general = [...variablesIn(part)].filter(v => variables.includes(v))
        scope.set(name, {variables: general, constraints: [], type: part, ...openIn(general, openNames)})
      }
  }
}

/// The variables of a scheme that stand for something that only GHC knows.
function openIn(variables: readonly string[], open: ReadonlySet<string>): Pick<Scheme, "open"> {
  const found = variables.filter(v => open.has(v))
  return found.length === 0 ? {} : {open: found}
}

function isReachable(types: ReadonlyMap<Declaration, Type>, meta: Meta): boolean {
  return [...types.values()].some(t => metasIn(t).has(meta))
}

/// Whether a type has all the variables of a constraint.
function within(constraint: Type, type: Type): boolean {
  const has = variablesIn(type)
  return [...variablesIn(constraint)].every(v => has.has(v))
}

function letterFor(index: number, taken: Set<string>): string {
  for (let i = index; ; i++) {
    const name = `${"abcdefghijklmnopqrstuvwxyz"[i % 26]}${i < 26 ? "" : Math.floor(i / 26)}`
    if (!taken.has(name)) {
      taken.add(name)
      return name
    }
  }
}
