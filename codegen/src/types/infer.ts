/// Hindley-Milner inference over the program tree, with type classes and without giving up at the first problem.
///
/// Levels stand for generalisation: an unknown made inside a binding and not reachable from outside is that binding's own.
/// Every expression and pattern gets a type; an empty socket gets the type that would fit it. What does not go
/// together is recorded at the node where it shows, and inference goes on as if it had been right.

import {definedBy} from "../model/names.ts"
import type {
  DataDeclaration,
  Declaration,
  Expr,
  Node,
  Pattern,
  Statement,
  SynonymDeclaration,
} from "../model/tree.ts"
import type {Environment} from "./environment.ts"
import {Expressions} from "./expressions.ts"
import type {Memo, Part, Remembered} from "./memo.ts"
import type {Wanted} from "./problems.ts"
import {Scope} from "./scope.ts"
import type {Type} from "./type.ts"
import {app, con, metasIn, showScheme} from "./type.ts"

export class Inferrer extends Expressions {
  /// What was found in each group of top-level definitions, now or by an inference that had the same group before. What was remembered is the very
  /// same value as then.
  readonly parts: Part[] = []
  private merged: ReadonlyMap<Node, Type> | undefined

  private readonly memo: Memo | undefined
  /// What the program's own types are, for the memo.
  private readonly world: string

  constructor(env: Environment, memo?: Memo, world = "") {
    super(env)
    this.memo = memo
    this.world = world
  }

  /// Types of what belongs to no group of definitions.
  get others(): ReadonlyMap<Node, Type> {
    return this.found
  }

  /// The type of every expression and pattern, parents before their parts.
  get types(): ReadonlyMap<Node, Type> {
    this.merged ??= new Map([...this.found, ...this.parts.flatMap(part => [...part.types])])
    return this.merged
  }

  /// Top-level declarations; answers the names they define.
  program(declarations: readonly Declaration[], known: Scope = new Scope()): Scope {
    const scope = this.group(declarations, known, true)
    this.secondInstances(declarations)
    for (const d of declarations)
      if (d.kind === "instance") this.remembering([d], scope, () => this.methods(d, scope))
    this.finish()
    return scope
  }

  /// Looks for unknown types in a type declaration.
  declaredTypes(d: DataDeclaration | SynonymDeclaration): void {
    for (const name of [d.name, ...(d.kind === "data" ? d.constructors.map(c => c.name) : [])])
      if (this.env.fixed.has(name)) this.problems.push({kind: "taken", node: d, name})
    const texts = d.kind === "synonym" ? [d.type] : d.constructors.flatMap(c => c.fields.map(f => f.type))
    for (const t of texts) this.signature(t.text, t)
  }

  /// An expression that belongs to no declaration; names that only a function around it could bind are let be.
  loose(expr: Expr, scope: Scope): Type {
    this.lenient = true
    this.strays = new Map()
    this.level++
    const type = this.fresh()
    this.check(expr, type, scope)
    this.level--
    this.wanted = this.reduceAll(this.wanted, []).stuck
    this.pending.push(...this.wanted)
    this.wanted = []
    this.lenient = false
    return type
  }

  loosePattern(pattern: Pattern): Type {
    this.level++
    const type = this.fresh()
    this.pattern(pattern, type, new Scope())
    this.level--
    this.pending.push(...this.reduceAll(this.wanted, []).stuck)
    this.wanted = []
    return type
  }

  looseStatements(statements: readonly Statement[], scope: Scope): void {
    this.lenient = true
    this.strays = new Map()
    this.level++
    this.doBlock(statements, app(con("Task"), this.fresh()), scope)
    this.level--
    this.pending.push(...this.reduceAll(this.wanted, []).stuck)
    this.wanted = []
    this.lenient = false
  }

  /// Constraints that no binding has taken; those on loose blocks show what kind of value is meant.
  readonly pending: Wanted[] = []

  protected override freeIn(d: Declaration): Set<string> {
    return this.memo?.freeIn(d) ?? super.freeIn(d)
  }

  /// Infers a group of top-level definitions, or takes what was found for the very same group before.
  protected override remembering(members: readonly Declaration[], scope: Scope, go: () => void): void {
    const memo = this.memo
    const watched = this.watch?.block
    // What is looked at must be gone through; all else may be remembered.
    const fresh = memo === undefined || (watched !== undefined && members.some(d => memo.holds(d, watched)))
    const key = fresh ? undefined : this.keyOf(members, scope, memo)
    const known = key === undefined ? undefined : memo?.groups.get(key)
    if (known !== undefined) {
      for (const [d, scheme] of known.schemes) this.schemes.set(d, scheme)
      for (const d of known.members) {
        const scheme = this.schemes.get(d)
        if (d.kind === "function" && scheme !== undefined) scope.set(d.name, scheme)
      }
      this.problems.push(...known.problems)
      for (const n of known.needs) this.env.needs.add(n)
      for (const d of known.unsignable) this.unsignable.add(d)
      this.parts.push(known)
      return
    }
    const outer = {
      found: this.found,
      wanted: this.wanted.length,
      problems: this.problems.length,
      schemes: this.schemes.size,
      needs: [...this.env.needs],
    }
    this.found = new Map()
    this.env.needs.clear()
    go()
    const needs = [...this.env.needs]
    for (const n of outer.needs) this.env.needs.add(n)
    const types = this.found
    this.found = outer.found
    const part = {members, types}
    // What other definitions may still decide cannot be remembered, nor what binds names by a pattern.
    const closed =
      this.wanted.length === outer.wanted &&
      members.every(d => {
        const scheme = this.schemes.get(d)
        return scheme === undefined || (d.kind === "function" && metasIn(scheme.type).size === 0)
      })
    if (key === undefined || !closed) {
      this.parts.push(part)
      return
    }
    const found: Remembered = {
      ...part,
      schemes: [...this.schemes].slice(outer.schemes),
      problems: this.problems.slice(outer.problems),
      needs,
      unsignable: members.filter(d => this.unsignable.has(d)),
    }
    memo?.groups.set(key, found)
    this.parts.push(found)
  }

  private keyOf(members: readonly Declaration[], scope: Scope, memo: Memo): string | undefined {
    const own = new Set(members.flatMap(definedBy))
    const parts = [this.world, ...members.map(d => String(memo.numberOf(d)))]
    for (const d of members)
      for (const name of memo.freeIn(d)) {
        const scheme = own.has(name) ? undefined : scope.get(name)
        if (scheme === undefined) continue
        if (metasIn(scheme.type).size > 0) return undefined
        parts.push(`${name} :: ${showScheme(scheme)}`)
      }
    return parts.join("\n")
  }
}
