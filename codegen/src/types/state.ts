/// What every part of inference works on: unknown types, what was found, what is wanted, and the names that are known.

import type {Declaration, Expr, Node, Origin} from "../model/tree.ts"
import type {Environment} from "./environment.ts"
import {expand} from "./environment.ts"
import {beyond, parseScheme} from "./parse.ts"
import type {TypeProblem, Wanted} from "./problems.ts"
import {Scope} from "./scope.ts"
import {unify} from "./solve.ts"
import type {Meta, Scheme, Type} from "./type.ts"
import {asFunction, con, funs, listOf, prune, substitute, tupleOf} from "./type.ts"

/// Types and classes as they are written without a module's name before them.
const unqualifiedNames = /(?<![\p{L}\p{N}_'.])\p{Lu}[\p{L}\p{N}_']*(?![\p{L}\p{N}_'.])/gu

export class State {
  protected found = new Map<Node, Type>()
  schemes = new Map<Declaration, Scheme>()
  readonly problems: TypeProblem[] = []
  protected readonly holes: Type[] = []
  protected wanted: Wanted[] = []
  protected level = 0
  protected count = 0
  /// Whether names that nothing defines are accepted; so for blocks that lie loose.
  protected lenient = false
  /// How many patterns took apart what only GHC knows, and so may have learnt more about a type than is known here.
  protected opaque = 0
  protected strays = new Map<string, Type>()
  /// The type variables that mean one type here, also in signatures.
  protected scoped: ReadonlyMap<string, Type> = new Map()
  readonly env: Environment

  constructor(env: Environment) {
    this.env = env
  }

  /// An empty socket that is asked about, and the answers: the names known there, and the type that it wants.
  watch: Origin | undefined
  watched: Scope | undefined
  watchedType: Type | undefined

  protected look(from: Origin | undefined, type: Type, scope: Scope): void {
    if (this.watch === undefined || this.watched !== undefined) return
    if (from?.block !== this.watch.block || from.input !== this.watch.input) return
    this.watched = scope
    this.watchedType = type
  }

  fresh(): Meta {
    return {kind: "meta", id: this.count++, level: this.level, is: undefined}
  }

  /// A type with variables of its own inside, which is GHC's to judge.
  protected beyond(text: string): boolean {
    return beyond(text, this.env.ranked)
  }

  // --- Types as they are written -----------------------------------------------------------------------------------

  protected signature(text: string, node: Node): Scheme | undefined {
    if (this.beyond(text)) return undefined
    const scheme = parseScheme(text)
    if (scheme === undefined) {
      if (text.trim() !== "") this.problems.push({kind: "bad-signature", node, text})
      return undefined
    }
    this.knownTypes(scheme.type, node)
    for (const [name] of text.matchAll(unqualifiedNames))
      if (this.env.hidden.has(name)) this.problems.push({kind: "unknown-type", node, name})
    const here = (type: Type) => substitute(expand(type, this.env), this.scoped)
    return {
      variables: scheme.variables.filter(name => !this.scoped.has(name)),
      constraints: scheme.constraints.map(c => ({name: c.name, type: here(c.type)})),
      type: here(scheme.type),
    }
  }

  protected knownTypes(type: Type, node: Node): void {
    const t = prune(type)
    if (this.env.open === true) return
    if (t.kind === "con" && !this.env.types.has(t.name) && !/^(?:->|\[\]|\(,*\))$/.test(t.name))
      this.problems.push({kind: "unknown-type", node, name: t.name})
    if (t.kind === "app") {
      this.knownTypes(t.fn, node)
      this.knownTypes(t.arg, node)
    }
  }

  // --- Names and unification --------------------------------------------------------------------------------------

  protected nameType(name: string, node: Node, scope: Scope): Type {
    const scheme = scope.get(name) ?? this.env.values.get(name)
    if (scheme !== undefined) return this.instantiate(scheme, node)
    if (this.lenient) {
      const stray = this.strays.get(name) ?? this.fresh()
      this.strays.set(name, stray)
      return stray
    }
    if (!this.unseen(name)) this.problems.push({kind: "unknown-name", node, name})
    return this.unknown()
  }

  /// Whether a name may come from a module that nobody told us about.
  protected unseen(name: string): boolean {
    const qualifier = /^(.*)\.[^.]/.exec(name)?.[1]
    return this.env.open === true || (qualifier !== undefined && this.env.qualifiers?.has(qualifier) === true)
  }

  /// The type of something that is wrong or only GHC knows; it decides nothing and is no reason for a second complaint.
  protected unknown(): Type {
    const type = this.fresh()
    this.holes.push(type)
    return type
  }

  protected operatorType(op: string, node: Expr, scope: Scope): Type {
    if (op === ":") {
      const item = this.fresh()
      return funs([item, listOf(item)], listOf(item))
    }
    return /^[:\p{Lu}]/u.test(op) ? this.constructorType(op, node) : this.nameType(op, node, scope)
  }

  protected constructorType(name: string, node: Node): Type {
    if (name === "()") return con("()")
    if (name === "[]") return listOf(this.fresh())
    if (name === ":") return this.operatorType(":", node as Expr, new Scope())
    if (/^\(,+\)$/.test(name)) {
      const items = [...name.slice(1)].map(() => this.fresh())
      return funs(items, tupleOf(items))
    }
    const info = this.env.constructors.get(name)
    if (info !== undefined) return this.instantiate(info.scheme, node)
    if (!this.unseen(name)) this.problems.push({kind: "unknown-name", node, name})
    return this.unknown()
  }

  protected instantiate(scheme: Scheme, node: Node): Type {
    if (scheme.unknown === true) return this.unknown()
    if (scheme.variables.length === 0) {
      for (const c of scheme.constraints) this.want(c.name, c.type, node)
      return expand(scheme.type, this.env)
    }
    const by = new Map(scheme.variables.map(v => [v, this.fresh() as Type] as const))
    for (const c of scheme.constraints) this.want(c.name, substitute(c.type, by), node)
    return expand(substitute(scheme.type, by), this.env)
  }

  protected want(name: string, type: Type, node: Node): void {
    this.wanted.push({name, type, node})
  }

  protected same(wanted: Type, found: Type, node: Node): void {
    if (unify(wanted, found) !== undefined) this.problems.push({kind: "mismatch", node, wanted, found})
  }

  protected opened(scheme: Scheme, count: number, node: Node): {fields: Type[]; result: Type} {
    let result = this.instantiate(scheme, node)
    const fields: Type[] = []
    for (let i = 0; i < count; i++) {
      const f = asFunction(result)
      if (f === undefined) break
      fields.push(f.from)
      result = f.to
    }
    return {fields, result}
  }
}

export const mono = (type: Type): Scheme => ({variables: [], constraints: [], type})
