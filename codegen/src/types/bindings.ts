/// Definitions: which belong together, what type each has, and what of it is general.
///
/// Levels stand for generalisation: an unknown made inside a binding and not reachable from outside is that binding's own.

import {definedBy} from "../model/names.ts"
import type {
  Clause,
  Declaration,
  Expr,
  FunctionDeclaration,
  InstanceDeclaration,
  Pattern,
  PatternBinding,
  RightSide,
  Statement,
} from "../model/tree.ts"
import {unreachable} from "../model/tree.ts"
import {bindersIn, freeInDeclaration} from "../model/uses.ts"
import {components} from "./components.ts"
import {expand, unknown} from "./environment.ts"
import {Patterns} from "./patterns.ts"
import type {Wanted} from "./problems.ts"
import type {Scope} from "./scope.ts"
import type {Rigid} from "./solve.ts"
import {simplify} from "./solve.ts"
import {mono} from "./state.ts"
import {instanceHead} from "./texts.ts"
import type {Meta, Scheme, Type} from "./type.ts"
import {asFunction, bool, fun, metasIn, rigidsIn, spine, substitute, variablesIn} from "./type.ts"

type InstanceHead = NonNullable<ReturnType<typeof instanceHead>>

export abstract class Bindings extends Patterns {
  /// What stands for top-level names until their turn.
  readonly placeholders = new Set<Scheme>()
  /// Definitions whose type must not be written out.
  readonly unsignable = new Set<Declaration>()

  /// An expression must have a type.
  abstract check(e: Expr, type: Type, scope: Scope): void

  /// The names that a definition takes from outside.
  protected freeIn(d: Declaration): Set<string> {
    return freeInDeclaration(d)
  }

  /// Infers a group of top-level definitions.
  protected remembering(_members: readonly Declaration[], _scope: Scope, go: () => void): void {
    go()
  }

  /// Definitions that may refer to each other; answers the scope with their names.
  protected group(declarations: readonly Declaration[], outer: Scope, top: boolean): Scope {
    const values = declarations.filter(d => d.kind === "function" || d.kind === "binding")
    const scope = outer.inner()
    const signatures = new Map<Declaration, Scheme>()
    const byName = new Map<string, number>()
    values.forEach((d, i) => {
      for (const name of definedBy(d)) {
        if (byName.has(name) || (top && this.env.fields?.has(name) === true))
          this.problems.push({kind: "twice", node: d, name})
        byName.set(name, i)
        if (top && this.env.fixed.has(name)) this.problems.push({kind: "taken", node: d, name})
        // Known from the start, also to whom asks for the scope before its turn; its type comes with its component.
        const placeholder = mono(this.fresh())
        scope.set(name, placeholder)
        if (top) this.placeholders.add(placeholder)
      }
      if (d.kind !== "function" || d.signature === undefined) return
      const scheme = this.signature(d.signature.text, d.signature)
      if (scheme !== undefined) {
        signatures.set(d, scheme)
        scope.set(d.name, scheme)
      }
    })
    const edges = values.map(d =>
      [...this.freeIn(d)].flatMap(name => {
        const i = byName.get(name)
        const target = i === undefined ? undefined : values[i]
        return i === undefined || target === undefined || signatures.has(target) ? [] : [i]
      }),
    )
    for (const component of components(edges)) {
      const members = component.flatMap(i => values[i] ?? [])
      if (top) this.remembering(members, scope, () => this.component(members, signatures, scope, top))
      else this.component(members, signatures, scope, top)
    }
    return scope
  }

  /// Methods have the types that their class gives them. Where only GHC knows these, what stands inside goes together all the same.
  protected methods(d: InstanceDeclaration, outer: Scope): void {
    const head = /^instance\b/.test(d.head) ? instanceHead(d.head) : undefined
    // What follows from a class of the program's own is not read.
    const plain = head?.instance.constraints.every(c => this.env.classes.has(c.name)) === true
    if (head !== undefined && plain) this.superclasses(d, head)
    const seen = new Set<string>()
    for (const method of d.declarations) {
      if (method.kind === "raw-declaration") continue
      const name = method.kind === "function" ? method.name : ""
      const type = head !== undefined && name !== "" ? this.methodType(name, head, outer) : undefined
      if (head !== undefined && type === undefined && this.listed(head.name, name))
        this.problems.push({kind: "no-method", node: method, name, of: head.name})
      if (name !== "" && seen.has(name)) this.problems.push({kind: "twice", node: method, name})
      seen.add(name)
      if (method.kind === "function" && type !== undefined && plain) this.method(method, type, head, outer)
      else this.unknownMethod(method, outer)
    }
  }

  /// Whether all that belongs to a class is known, and this is not among it.
  private listed(of: string, name: string): boolean {
    const known = this.env.classes.has(of) || this.env.ownClasses?.has(of) === true
    return known && this.env.values.get(name)?.unknown !== true && this.env.open !== true
  }

  /// With a type of its own, which may say more than the class asks for.
  private method(d: FunctionDeclaration, type: Scheme, {instance}: InstanceHead, outer: Scope): void {
    const own = d.signature === undefined ? undefined : this.signature(d.signature.text, d.signature)
    if (own === undefined || d.signature === undefined) {
      this.checkSigned(d, type, outer, true, variablesIn(instance.type))
      return
    }
    const wanted = substitute(type.type, this.rigid(type.variables))
    this.same(wanted, substitute(own.type, new Map(own.variables.map(v => [v, this.fresh()]))), d.signature)
    const constraints = [...instance.constraints, ...own.constraints]
    const variables = [...new Set([...own.variables, ...variablesIn(instance.type)])]
    this.checkSigned(d, {...own, variables, constraints}, outer, true, variablesIn(instance.type))
  }

  /// Variables that a type promises to work for.
  private rigid(names: Iterable<string>): Map<string, Type> {
    const rigid = new Map<string, Type>()
    for (const name of names) {
      const variable: Rigid = {kind: "var", name, id: this.count++, level: this.level + 1}
      rigid.set(name, variable)
    }
    return rigid
  }

  /// A type belongs to a class once: by one instance, or derived.
  protected secondInstances(declarations: readonly Declaration[]): void {
    const seen = new Set(
      declarations.flatMap(d => (d.kind === "data" ? d.deriving.map(of => `${of} ${d.name}`) : [])),
    )
    for (const d of declarations) {
      const head = d.kind === "instance" && /^instance\b/.test(d.head) ? instanceHead(d.head) : undefined
      if (head === undefined) continue
      const {head: type} = spine(expand(head.instance.type, this.env))
      if (type.kind !== "con") continue
      const whole = `${head.name} ${type.name}`
      if (seen.has(whole))
        this.problems.push({kind: "second-instance", node: d, name: type.name, of: head.name})
      seen.add(whole)
    }
  }

  private unknownMethod(method: Declaration, outer: Scope): void {
    const before = this.wanted
    this.level++
    const scope = outer.inner()
    const type = this.unknown()
    if (method.kind === "function") this.clauses(method, type, scope)
    if (method.kind === "binding") {
      this.pattern(method.pattern, type, scope)
      this.rightSide(method.right, type, scope)
    }
    this.level--
    this.wanted = before
  }

  /// `show :: Show a => a -> String` is `Mode -> String` in `instance Show Mode`.
  private methodType(name: string, {name: of, instance}: InstanceHead, outer: Scope): Scheme | undefined {
    const method = outer.get(name) === undefined ? this.env.values.get(name) : undefined
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
        ...rest.map(c => ({name: c.name, type: expand(substitute(c.type, by), this.env)})),
      ],
      type: expand(substitute(method.type, by), this.env),
    }
  }

  /// What belongs to a class belongs to those that it builds on: `Eq` with `Ord`. Such an instance of an own type may be derived.
  private superclasses(d: InstanceDeclaration, {name: of, instance}: InstanceHead): void {
    const rigid = this.rigid(variablesIn(instance.type))
    const type = expand(substitute(instance.type, rigid), this.env)
    const givens = instance.constraints.map(c => ({name: c.name, type: substitute(c.type, rigid)}))
    const wanted = (this.env.classes.get(of) ?? []).map((name): Wanted => ({name, type, node: d}))
    for (const c of this.reduceAll(wanted, givens).stuck)
      this.problems.push({kind: "too-general", node: d, constraint: c})
  }

  protected component(
    members: readonly Declaration[],
    signatures: ReadonlyMap<Declaration, Scheme>,
    scope: Scope,
    top: boolean,
  ): void {
    const [only] = members
    const signature = only === undefined ? undefined : signatures.get(only)
    const {problems, wanted} = {problems: this.problems.length, wanted: this.wanted}
    if (members.length === 1 && only?.kind === "function" && signature !== undefined)
      this.checkSigned(only, signature, scope, top)
    else this.inferTogether(members, scope, top)
    if (!members.some(d => d.kind === "function" && this.beyond(d.signature?.text ?? ""))) return
    this.problems.length = problems
    this.wanted = wanted
    for (const d of members) {
      this.schemes.set(d, unknown)
      if (d.kind === "function") scope.set(d.name, unknown)
    }
  }

  /// The variables of an instance's `head` stand for the same types all through its methods (GHC's ScopedTypeVariables).
  protected checkSigned(
    d: FunctionDeclaration,
    scheme: Scheme,
    scope: Scope,
    top: boolean,
    head: ReadonlySet<string> = new Set(),
  ): void {
    this.schemes.set(d, scheme)
    const before = this.wanted
    this.wanted = []
    const rigid = this.rigid(scheme.variables)
    this.level++
    const {opaque} = this
    const givens = scheme.constraints.map(c => ({name: c.name, type: substitute(c.type, rigid)}))
    const {scoped} = this
    this.scoped = new Map([...scoped, ...[...rigid].filter(([name]) => head.has(name))])
    this.clauses(d, substitute(scheme.type, rigid), scope)
    this.scoped = scoped
    this.level--
    const {stuck} = this.reduceAll(this.wanted, givens)
    const deferred: Wanted[] = []
    const own = new Set([...rigid.values()])
    for (const c of stuck) {
      // Only about variables that this signature promises to work for.
      const mine = metasIn(c.type).size === 0 && [...rigidsIn(c.type)].some(v => own.has(v))
      if (mine && this.opaque > opaque) continue
      if (mine) this.problems.push({kind: "too-general", node: c.node, constraint: c})
      else deferred.push(c)
    }
    this.wanted = before
    this.settle(deferred, new Set(), top)
  }

  protected inferTogether(members: readonly Declaration[], scope: Scope, top: boolean): void {
    const before = this.wanted
    this.wanted = []
    this.level++
    const types = new Map<Declaration, Type>()
    for (const d of members) {
      if (d.kind === "function") {
        const type = this.fresh()
        types.set(d, type)
        scope.set(d.name, mono(type))
      } else if (d.kind === "binding") {
        const type = this.fresh()
        types.set(d, type)
        this.pattern(d.pattern, type, scope)
      }
    }
    for (const d of members) {
      const type = types.get(d)
      if (type === undefined) continue
      if (d.kind === "function") this.clauses(d, type, scope)
      else if (d.kind === "binding") this.rightSide((d as PatternBinding).right, type, scope)
    }
    this.level--
    const {stuck} = this.reduceAll(this.wanted, [])
    this.wanted = before
    this.generalise(members, types, stuck, scope, top)
  }

  /// Turns the unknowns that belong to these definitions into variables of their types. Definitions without parameters keep
  /// constrained unknowns for their uses to decide (Haskell 2010 report §4.5.5, the monomorphism restriction).
  protected generalise(
    members: readonly Declaration[],
    types: ReadonlyMap<Declaration, Type>,
    stuck: readonly Wanted[],
    scope: Scope,
    top: boolean,
  ): void {
    const restricted = members.some(
      d => d.kind === "binding" || (d.kind === "function" && d.clauses.every(c => c.patterns.length === 0)),
    )
    const own = new Set<Meta>()
    for (const type of types.values()) for (const m of metasIn(type)) if (m.level > this.level) own.add(m)
    if (restricted)
      for (const c of stuck)
        for (const m of metasIn(c.type)) {
          own.delete(m)
          if (m.level > this.level && this.reaches(types, m)) m.level = this.level
        }
    // A hole's type is still open: what goes into it may decide it, so it is not everybody's.
    const quantified: Wanted[] = []
    const rest: Wanted[] = []
    for (const c of stuck) {
      const metas = [...metasIn(c.type)]
      if (!metas.some(m => own.has(m))) rest.push(c)
      // Partly about something that no use can ever decide.
      else if (c.name !== "Ends" && metas.some(m => m.level > this.level && !own.has(m)))
        this.problems.push({kind: "ambiguous", node: c.node, constraint: c})
      else quantified.push(c)
    }
    this.settle(rest, own, top)
    const names = new Map<Meta, string>()
    const taken = new Set(this.scoped.keys())
    for (const type of types.values()) variablesIn(type, taken)
    const alive = [...own].filter(m => m.is === undefined)
    // What only GHC knows may turn out to be less general than it looks.
    if (top && this.holes.length > 0) {
      const open = new Set<Meta>()
      for (const h of this.holes) metasIn(h, open)
      if (alive.some(m => open.has(m))) for (const d of members) this.unsignable.add(d)
    }
    for (const m of alive) {
      const name = letterFor(names.size, taken)
      names.set(m, name)
    }
    // GHC settles an open `Ends` with its catch-all instance, so it never stands in a type.
    const constraints = simplify(
      quantified.filter(c => c.name !== "Ends"),
      this.env,
    )
    for (const [m, name] of names) m.is = {kind: "var", name}
    // Definitions that use each other have the same constraints, so the type of each must say what they are about.
    if (types.size > 1)
      for (const c of quantified)
        if (c.name !== "Ends" && [...types.values()].some(type => !within(c.type, type)))
          this.problems.push({kind: "ambiguous", node: c.node, constraint: c})
    for (const d of members) {
      const type = types.get(d)
      if (type === undefined) continue
      const variables = [...variablesIn(type)].filter(v => [...names.values()].includes(v))
      const scheme: Scheme = {
        variables,
        constraints: constraints.filter(c => [...variablesIn(c.type)].every(v => variables.includes(v))),
        type,
      }
      this.schemes.set(d, scheme)
      if (d.kind === "function") scope.set(d.name, scheme)
      // Each name that a pattern takes out is as general by itself.
      else if (d.kind === "binding")
        for (const [name] of bindersIn(d.pattern)) {
          const part = scope.get(name)?.type
          if (part === undefined) continue
          const general = [...variablesIn(part)].filter(v => variables.includes(v))
          scope.set(name, {variables: general, constraints: [], type: part})
        }
    }
    if (top && this.recursive(members)) this.checkSignable(members, scope)
  }

  private recursive(members: readonly Declaration[]): boolean {
    const names = new Set(members.flatMap(definedBy))
    return members.some(d => [...this.freeIn(d)].some(name => names.has(name)))
  }

  /// With its type written out, a definition may use itself at another type each time, and GHC may find that nothing decides
  /// which. Such a definition is better off without a signature.
  private checkSignable(members: readonly Declaration[], scope: Scope): void {
    const {found, schemes, wanted} = this
    const [problems, holes] = [this.problems.length, this.holes.length]
    this.found = new Map()
    this.schemes = new Map()
    this.wanted = []
    for (const d of members) {
      const scheme = schemes.get(d)
      if (d.kind === "function" && scheme !== undefined) this.checkSigned(d, scheme, scope, true)
    }
    if (this.problems.length > problems) for (const d of members) this.unsignable.add(d)
    this.problems.length = problems
    this.holes.length = holes
    this.found = found
    this.schemes = schemes
    this.wanted = wanted
  }

  protected reaches(types: ReadonlyMap<Declaration, Type>, meta: Meta): boolean {
    return [...types.values()].some(t => metasIn(t).has(meta))
  }

  // --- Functions and right sides ----------------------------------------------------------------------------------

  protected clauses(d: FunctionDeclaration, type: Type, scope: Scope): void {
    for (const c of d.clauses) this.clause(c, type, scope)
  }

  protected clause(c: Clause, type: Type, scope: Scope): void {
    const inner = scope.inner()
    const result = this.parameters(c.patterns, type, inner)
    this.rightSide(c.right, result, inner)
  }

  /// Patterns that take the parameters of a function; answers the type of what it makes.
  protected parameters(patterns: readonly Pattern[], type: Type, scope: Scope): Type {
    this.distinct(patterns)
    let result = type
    for (const p of patterns) {
      let f = asFunction(result)
      if (f === undefined) {
        f = {from: this.fresh(), to: this.fresh()}
        this.same(result, fun(f.from, f.to), p)
      }
      this.pattern(p, f.from, scope)
      result = f.to
    }
    return result
  }

  protected rightSide(right: RightSide, type: Type, scope: Scope): void {
    const inner = right.where.length === 0 ? scope : this.group(right.where, scope, false)
    const body = right.body
    if (!Array.isArray(body)) {
      this.check(body as Expr, type, inner)
      return
    }
    for (const g of body) {
      const bound = this.guards(g.guards, inner)
      this.check(g.body, type, bound)
    }
  }

  protected guards(statements: readonly Statement[], scope: Scope): Scope {
    let inner = scope
    for (const s of statements) {
      switch (s.kind) {
        case "statement":
          this.check(s.expr, bool, inner)
          break
        case "bind": {
          const type = this.fresh()
          this.check(s.expr, type, inner)
          this.distinct([s.pattern])
          const next = inner.inner()
          this.pattern(s.pattern, type, next)
          inner = next
          break
        }
        case "let-statement":
          inner = this.group(s.declarations, inner, false)
          break
        default:
          unreachable(s)
      }
    }
    return inner
  }
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
