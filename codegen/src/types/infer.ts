/// Hindley-Milner inference over the program tree, with type classes and without giving up at the first problem.
///
/// Levels stand for generalisation: an unknown made inside a binding and not reachable from outside is that binding's own.
/// Every expression and pattern gets a type; an empty socket gets the type that would fit it. What does not go
/// together is recorded at the node where it shows, and inference goes on as if it had been right.

import {isFractionalLiteral} from "../haskell/lexemes.ts"
import {definedBy} from "../model/names.ts"
import type {
  Clause,
  DataDeclaration,
  Declaration,
  Expr,
  FunctionDeclaration,
  Node,
  Origin,
  Pattern,
  PatternBinding,
  RightSide,
  Statement,
  SynonymDeclaration,
} from "../model/tree.ts"
import {unreachable} from "../model/tree.ts"
import {bindersIn, freeInDeclaration} from "../model/uses.ts"
import {components} from "./components.ts"
import type {Environment} from "./environment.ts"
import {expand} from "./environment.ts"
import type {Memo} from "./memo.ts"
import {parseScheme} from "./parse.ts"
import {Scope} from "./scope.ts"
import type {Rigid} from "./solve.ts"
import {reduce, simplify, unify} from "./solve.ts"
import type {Constraint, Meta, Scheme, Type} from "./type.ts"
import {
  app,
  asFunction,
  bool,
  con,
  fun,
  funs,
  listOf,
  metasIn,
  prune,
  showScheme,
  spine,
  string,
  substitute,
  tupleOf,
  variablesIn,
} from "./type.ts"

/// What inference can find wrong. `node` is where it shows.
export type TypeProblem =
  | {readonly kind: "mismatch"; readonly node: Node; readonly wanted: Type; readonly found: Type}
  | {readonly kind: "no-instance"; readonly node: Node; readonly constraint: Constraint}
  | {readonly kind: "unknown-name"; readonly node: Node; readonly name: string}
  | {readonly kind: "taken"; readonly node: Node; readonly name: string}
  | {readonly kind: "twice"; readonly node: Node; readonly name: string}
  | {readonly kind: "too-many-arguments"; readonly node: Node; readonly type: Type}
  | {
      readonly kind: "wrong-field-count"
      readonly node: Node
      readonly name: string
      readonly wanted: number
      readonly found: number
    }
  | {readonly kind: "ambiguous"; readonly node: Node; readonly constraint: Constraint}
  | {readonly kind: "too-general"; readonly node: Node; readonly constraint: Constraint}
  | {readonly kind: "bad-signature"; readonly node: Node; readonly text: string}
  | {readonly kind: "unknown-type"; readonly node: Node; readonly name: string}

export interface Inferred {
  readonly types: ReadonlyMap<Node, Type>
  /// Types of all functions and bound names with a definition, by declaration.
  readonly schemes: ReadonlyMap<Declaration, Scheme>
  /// Constraints on the types that are still unknown or generalised, for display.
  readonly problems: readonly TypeProblem[]
  /// The top level's names.
  readonly globals: Scope
}

export interface Wanted extends Constraint {
  readonly node: Node
}

/// Whether a constraint that was stuck on an unknown type would get further by now.
function isKnownNow(c: Constraint): boolean {
  const {head, args} = spine(prune(c.type))
  if (c.name !== "Ends") return head.kind === "con"
  const controller = args[1]
  return controller !== undefined && spine(controller).head.kind === "con"
}

const mono = (type: Type): Scheme => ({variables: [], constraints: [], type})

/// Classes that Haskell's defaulting rules accept beside a number class. (Haskell 2010 report §4.3.4)
const standardClasses = new Set(
  `Eq Ord Show Enum Bounded Num Real Integral Fractional Floating RealFrac RealFloat Semigroup Monoid Functor Applicative Monad Foldable Traversable Typeable`.split(
    " ",
  ),
)
const numberClasses = new Set(["Num", "Real", "Integral", "Fractional", "Floating", "RealFrac", "RealFloat"])
const fractionClasses = new Set(["Fractional", "Floating", "RealFrac", "RealFloat"])

export class Inferrer {
  private found = new Map<Node, Type>()
  /// Types found before, by an inference that had the same definitions before it.
  private readonly remembered: ReadonlyMap<Node, Type>[] = []
  private merged: ReadonlyMap<Node, Type> | undefined
  readonly schemes = new Map<Declaration, Scheme>()
  readonly problems: TypeProblem[] = []
  private readonly holes: Type[] = []
  private wanted: Wanted[] = []
  private level = 0
  private count = 0
  /// Whether names that nothing defines are accepted; so for blocks that lie loose.
  private lenient = false
  private strays = new Map<string, Type>()
  readonly env: Environment

  private readonly memo: Memo | undefined
  /// What the program's own types are, for the memo.
  private readonly world: string

  constructor(env: Environment, memo?: Memo, world = "") {
    this.env = env
    this.memo = memo
    this.world = world
  }

  /// The type of every expression and pattern, parents before their parts.
  get types(): ReadonlyMap<Node, Type> {
    this.merged ??=
      this.remembered.length === 0
        ? this.found
        : new Map([...this.found, ...this.remembered.flatMap(m => [...m])])
    return this.merged
  }

  /// Top-level declarations; answers the names they define.
  program(declarations: readonly Declaration[], known: Scope = new Scope()): Scope {
    const scope = this.group(declarations, known, true)
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

  /// An empty socket whose scope is asked for, and the answer.
  watch: Origin | undefined
  watched: Scope | undefined
  /// What stands for top-level names until their turn.
  readonly placeholders = new Set<Scheme>()

  /// Constraints that no binding has taken; those on loose blocks show what kind of value is meant.
  readonly pending: Wanted[] = []

  fresh(): Meta {
    return {kind: "meta", id: this.count++, level: this.level, is: undefined}
  }

  // --- Bindings ---------------------------------------------------------------------------------------------------

  /// Definitions that may refer to each other; answers the scope with their names.
  private group(declarations: readonly Declaration[], outer: Scope, top: boolean): Scope {
    const values = declarations.filter(d => d.kind === "function" || d.kind === "binding")
    const scope = outer.inner()
    const signatures = new Map<Declaration, Scheme>()
    const byName = new Map<string, number>()
    values.forEach((d, i) => {
      for (const name of definedBy(d)) {
        if (byName.has(name)) this.problems.push({kind: "twice", node: d, name})
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
      [...(this.memo?.freeIn(d) ?? freeInDeclaration(d))].flatMap(name => {
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

  private component(
    members: readonly Declaration[],
    signatures: ReadonlyMap<Declaration, Scheme>,
    scope: Scope,
    top: boolean,
  ): void {
    const [only] = members
    const signature = only === undefined ? undefined : signatures.get(only)
    if (members.length === 1 && only?.kind === "function" && signature !== undefined)
      this.checkSigned(only, signature, scope, top)
    else this.inferTogether(members, scope, top)
  }

  /// Infers a group of top-level definitions, or takes what was found for the very same group before.
  private remembering(members: readonly Declaration[], scope: Scope, go: () => void): void {
    const memo = this.memo
    const key = memo === undefined || this.watch !== undefined ? undefined : this.keyOf(members, scope, memo)
    const known = key === undefined ? undefined : memo?.groups.get(key)
    if (known !== undefined) {
      for (const [d, scheme] of known.schemes) {
        this.schemes.set(d, scheme)
        if (d.kind === "function") scope.set(d.name, scheme)
      }
      this.problems.push(...known.problems)
      for (const n of known.needs) this.env.needs.add(n)
      this.remembered.push(known.types)
      return
    }
    const outer = {
      found: this.found,
      wanted: this.wanted.length,
      problems: this.problems.length,
      needs: new Set(this.env.needs),
    }
    this.found = new Map()
    go()
    const types = this.found
    this.found = outer.found
    for (const [node, type] of types) this.found.set(node, type)
    const schemes = members.flatMap(d => {
      const scheme = this.schemes.get(d)
      return scheme === undefined ? [] : [[d, scheme] as const]
    })
    // What other definitions may still decide cannot be remembered, nor what binds names by a pattern.
    const closed =
      this.wanted.length === outer.wanted &&
      schemes.every(([d, s]) => d.kind === "function" && metasIn(s.type).size === 0)
    if (key === undefined || !closed) return
    memo?.groups.set(key, {
      schemes,
      types,
      problems: this.problems.slice(outer.problems),
      needs: [...this.env.needs].filter(n => !outer.needs.has(n)),
    })
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

  private signature(text: string, node: Node): Scheme | undefined {
    const scheme = parseScheme(text)
    if (scheme === undefined) {
      if (text.trim() !== "") this.problems.push({kind: "bad-signature", node, text})
      return undefined
    }
    this.knownTypes(scheme.type, node)
    return {
      ...scheme,
      constraints: scheme.constraints.map(c => ({name: c.name, type: expand(c.type, this.env)})),
      type: expand(scheme.type, this.env),
    }
  }

  private knownTypes(type: Type, node: Node): void {
    const t = prune(type)
    if (t.kind === "con" && !this.env.types.has(t.name) && !/^(?:->|\[\]|\(,*\))$/.test(t.name))
      this.problems.push({kind: "unknown-type", node, name: t.name})
    if (t.kind === "app") {
      this.knownTypes(t.fn, node)
      this.knownTypes(t.arg, node)
    }
  }

  private checkSigned(d: FunctionDeclaration, scheme: Scheme, scope: Scope, top: boolean): void {
    this.schemes.set(d, scheme)
    const before = this.wanted
    this.wanted = []
    this.level++
    const rigid = new Map<string, Type>()
    for (const name of scheme.variables) {
      const variable: Rigid = {kind: "var", name, id: this.count++, level: this.level}
      rigid.set(name, variable)
    }
    const givens = scheme.constraints.map(c => ({name: c.name, type: substitute(c.type, rigid)}))
    this.clauses(d, substitute(scheme.type, rigid), scope)
    this.level--
    const {stuck} = this.reduceAll(this.wanted, givens)
    const deferred: Wanted[] = []
    for (const c of stuck) {
      const metas = [...metasIn(c.type)]
      if (metas.length === 0) this.problems.push({kind: "too-general", node: c.node, constraint: c})
      else deferred.push(c)
    }
    this.wanted = before
    this.settle(deferred, new Set(), top)
  }

  private inferTogether(members: readonly Declaration[], scope: Scope, top: boolean): void {
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
  private generalise(
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
    if (restricted || members.some(d => d.kind === "binding"))
      for (const c of stuck)
        for (const m of metasIn(c.type)) {
          own.delete(m)
          if (m.level > this.level && this.reaches(types, m)) m.level = this.level
        }
    if (members.some(d => d.kind === "binding")) {
      for (const m of own) m.level = Math.min(m.level, this.level)
      own.clear()
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
    const taken = new Set<string>()
    for (const type of types.values()) variablesIn(type, taken)
    const alive = [...own].filter(m => m.is === undefined)
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
    }
  }

  private reaches(types: ReadonlyMap<Declaration, Type>, meta: Meta): boolean {
    return [...types.values()].some(t => metasIn(t).has(meta))
  }

  /// Constraints that do not become part of a type: passed outwards, decided by default, or unanswerable.
  private settle(constraints: readonly Wanted[], own: ReadonlySet<Meta>, top: boolean): void {
    const open: Wanted[] = []
    for (const c of constraints) {
      const metas = [...metasIn(c.type)]
      if (metas.some(m => m.level <= this.level || own.has(m))) this.wanted.push(c)
      else open.push(c)
    }
    this.byDefault(open, false)
    if (top && this.level === 0) return
  }

  /// Decides unknown number types as Haskell does; complains about what nothing decides. (Haskell 2010 report §4.3.4)
  private byDefault(constraints: readonly Wanted[], constants: boolean): void {
    const holes = new Set<Meta>()
    for (const h of this.holes) metasIn(h, holes)
    const groups = new Map<Meta, Wanted[]>()
    for (const c of constraints) {
      const [first] = metasIn(c.type)
      if (first === undefined || c.name === "Ends") continue
      groups.set(first, [...(groups.get(first) ?? []), c])
    }
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
          const r = reduce(c, this.env)
          if (r.kind === "no")
            this.problems.push({kind: "no-instance", node: c.node, constraint: r.constraint})
        }
        continue
      }
      const [first] = group
      if (first !== undefined && !this.lenient)
        this.problems.push({kind: "ambiguous", node: first.node, constraint: first})
    }
  }

  private finish(): void {
    const {stuck} = this.reduceAll(this.wanted, [])
    this.wanted = []
    // Constants whose number type no use decided: a measure, so a Double unless something asks for whole numbers.
    this.byDefault(
      stuck.filter(c => metasIn(c.type).size > 0),
      true,
    )
  }

  private reduceAll(wanted: readonly Wanted[], givens: readonly Constraint[]): {stuck: Wanted[]} {
    let stuck: Wanted[] = []
    let todo = wanted
    // `Ends` decides types while it is reduced, so what was stuck before it may be known after it.
    do {
      stuck = []
      for (const w of todo) {
        const r = reduce(w, this.env, givens)
        if (r.kind === "no") this.problems.push({kind: "no-instance", node: w.node, constraint: r.constraint})
        else for (const c of r.constraints) stuck.push({...c, node: w.node})
      }
      todo = stuck
    } while (stuck.some(isKnownNow))
    return {stuck}
  }

  // --- Functions and right sides ----------------------------------------------------------------------------------

  private clauses(d: FunctionDeclaration, type: Type, scope: Scope): void {
    for (const c of d.clauses) this.clause(c, type, scope)
  }

  /// A name may stand only once among the patterns that are matched together. (Haskell 2010 report §3.17.1)
  private distinct(patterns: readonly Pattern[]): void {
    const seen = new Set<string>()
    for (const [name, node] of patterns.flatMap(bindersIn)) {
      if (seen.has(name)) this.problems.push({kind: "twice", node: node as Pattern, name})
      seen.add(name)
    }
  }

  private clause(c: Clause, type: Type, scope: Scope): void {
    this.distinct(c.patterns)
    const inner = scope.inner()
    let result = type
    for (const p of c.patterns) {
      let f = asFunction(result)
      if (f === undefined) {
        f = {from: this.fresh(), to: this.fresh()}
        this.same(result, fun(f.from, f.to), p)
      }
      this.pattern(p, f.from, inner)
      result = f.to
    }
    this.rightSide(c.right, result, inner)
  }

  private rightSide(right: RightSide, type: Type, scope: Scope): void {
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

  private guards(statements: readonly Statement[], scope: Scope): Scope {
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

  // --- Patterns ---------------------------------------------------------------------------------------------------

  private pattern(p: Pattern, type: Type, scope: Scope): void {
    this.found.set(p, type)
    switch (p.kind) {
      case "name-pattern":
        scope.set(p.name, mono(type))
        return
      case "wildcard":
        return
      case "constructor-pattern":
        this.constructorPattern(p, type, scope)
        return
      case "number-pattern":
        this.want(isFractionalLiteral(p.text.replace("-", "")) ? "Fractional" : "Num", type, p)
        this.want("Eq", type, p)
        return
      case "string-pattern":
        this.same(type, string, p)
        return
      case "character-pattern":
        this.same(type, con("Char"), p)
        return
      case "tuple-pattern": {
        const items = p.items.map(() => this.fresh())
        const [only] = items
        this.same(type, items.length === 1 && only !== undefined ? only : tupleOf(items), p)
        for (const [i, item] of p.items.entries()) this.pattern(item, items[i] ?? this.fresh(), scope)
        return
      }
      case "list-pattern": {
        const item = this.fresh()
        this.same(type, listOf(item), p)
        for (const i of p.items) this.pattern(i, item, scope)
        return
      }
      case "infix-pattern":
        if (p.op === ":") {
          const item = this.fresh()
          this.same(type, listOf(item), p)
          this.pattern(p.left, item, scope)
          this.pattern(p.right, type, scope)
        } else
          this.constructorPattern(
            {...p, kind: "constructor-pattern", name: p.op, args: [p.left, p.right]},
            type,
            scope,
          )
        return
      case "as-pattern":
        scope.set(p.name, mono(type))
        this.pattern(p.pattern, type, scope)
        return
      case "record-pattern": {
        const info = this.env.constructors.get(p.name)
        if (info === undefined) {
          this.problems.push({kind: "unknown-name", node: p, name: p.name})
          for (const f of p.fields) this.pattern(f.pattern, this.fresh(), scope)
          return
        }
        const {fields, result} = this.opened(info.scheme, info.fields.length, p)
        this.same(type, result, p)
        for (const f of p.fields) {
          const at = info.fieldNames.indexOf(f.name)
          if (at < 0) this.problems.push({kind: "unknown-name", node: p, name: f.name})
          this.pattern(f.pattern, fields[at] ?? this.fresh(), scope)
        }
        return
      }
      case "raw-pattern":
        for (const [name] of p.text.matchAll(/(?<![\p{L}\p{N}_'])[\p{Ll}_][\p{L}\p{N}_']*/gu))
          scope.set(name, mono(this.unknown()))
        return
      default:
        unreachable(p)
    }
  }

  private constructorPattern(p: Pattern & {kind: "constructor-pattern"}, type: Type, scope: Scope): void {
    if (p.name === "()" && p.args.length === 0) {
      this.same(type, con("()"), p)
      return
    }
    const info = this.env.constructors.get(p.name)
    if (info === undefined) {
      this.problems.push({kind: "unknown-name", node: p, name: p.name})
      for (const a of p.args) this.pattern(a, this.fresh(), scope)
      return
    }
    const {fields, result} = this.opened(info.scheme, info.fields.length, p)
    if (fields.length !== p.args.length)
      this.problems.push({
        kind: "wrong-field-count",
        node: p,
        name: p.name,
        wanted: fields.length,
        found: p.args.length,
      })
    this.same(type, result, p)
    for (const [i, a] of p.args.entries()) this.pattern(a, fields[i] ?? this.fresh(), scope)
  }

  private opened(scheme: Scheme, count: number, node: Node): {fields: Type[]; result: Type} {
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

  // --- Expressions ------------------------------------------------------------------------------------------------

  check(e: Expr, type: Type, scope: Scope): void {
    this.found.set(e, type)
    switch (e.kind) {
      case "variable":
        this.same(type, this.nameType(e.name, e, scope), e)
        return
      case "constructor-name":
        this.same(type, this.constructorType(e.name, e), e)
        return
      case "number":
        this.want(isFractionalLiteral(e.text.replace("-", "")) ? "Fractional" : "Num", type, e)
        return
      case "string":
        this.same(type, string, e)
        return
      case "character":
        this.same(type, con("Char"), e)
        return
      case "apply": {
        const fn = this.fresh()
        this.check(e.fn, fn, scope)
        this.application(fn, e.args, type, e, scope)
        return
      }
      case "infix":
        if (e.op === "$") {
          const fn = this.fresh()
          this.check(e.left, fn, scope)
          this.application(fn, [e.right], type, e, scope)
        } else this.application(this.operatorType(e.op, e, scope), [e.left, e.right], type, e, scope)
        return
      case "negate":
        this.want("Num", type, e)
        this.check(e.expr, type, scope)
        return
      case "section": {
        const [a, b, c] = [this.fresh(), this.fresh(), this.fresh()]
        this.same(this.operatorType(e.op, e, scope), funs([a, b], c), e)
        this.same(type, e.side === "left" ? fun(b, c) : fun(a, c), e)
        this.check(e.operand, e.side === "left" ? a : b, scope)
        return
      }
      case "lambda": {
        this.distinct(e.parameters)
        const inner = scope.inner()
        let result = type
        for (const p of e.parameters) {
          let f = asFunction(result)
          if (f === undefined) {
            f = {from: this.fresh(), to: this.fresh()}
            this.same(result, fun(f.from, f.to), e)
          }
          this.pattern(p, f.from, inner)
          result = f.to
        }
        this.check(e.body, result, inner)
        return
      }
      case "if":
        this.check(e.condition, bool, scope)
        this.check(e.yes, type, scope)
        this.check(e.no, type, scope)
        return
      case "case": {
        const scrutinee = this.fresh()
        this.check(e.scrutinee, scrutinee, scope)
        for (const a of e.alternatives) {
          this.distinct([a.pattern])
          const inner = scope.inner()
          this.pattern(a.pattern, scrutinee, inner)
          this.rightSide(a.right, type, inner)
        }
        return
      }
      case "let":
        this.check(e.body, type, this.group(e.declarations, scope, false))
        return
      case "do":
        this.doBlock(e.statements, type, scope)
        return
      case "tuple": {
        const items = e.items.map(() => this.fresh())
        const [only] = items
        this.same(type, items.length === 1 && only !== undefined ? only : tupleOf(items), e)
        for (const [i, item] of e.items.entries()) this.check(item, items[i] ?? this.fresh(), scope)
        return
      }
      case "list": {
        const item = this.fresh()
        this.same(type, listOf(item), e)
        for (const i of e.items) this.check(i, item, scope)
        return
      }
      case "range": {
        const item = this.fresh()
        this.same(type, listOf(item), e)
        this.want("Enum", item, e)
        for (const part of [e.first, e.second, e.last]) if (part !== undefined) this.check(part, item, scope)
        return
      }
      case "comprehension":
        this.comprehension(e, type, scope)
        return
      case "typed": {
        const scheme = this.signature(e.type.text, e.type)
        const inner = scheme === undefined ? type : this.instantiate(scheme, e)
        this.same(type, inner, e)
        this.check(e.expr, inner, scope)
        return
      }
      case "record":
        this.record(e, type, scope)
        return
      case "update":
        this.check(e.record, type, scope)
        for (const f of e.fields) {
          const field = this.fresh()
          const selector = scope.get(f.name) ?? this.env.values.get(f.name)
          if (selector === undefined) this.problems.push({kind: "unknown-name", node: e, name: f.name})
          else this.same(this.instantiate(selector, e), fun(type, field), e)
          this.check(f.value, field, scope)
        }
        return
      case "hole":
        this.holes.push(type)
        if (e.from?.block === this.watch?.block && e.from?.input === this.watch?.input) this.watched ??= scope
        return
      case "raw":
        // GHC will say; until then it fits anywhere and decides nothing.
        this.holes.push(type)
        return
      default:
        unreachable(e)
    }
  }

  private application(fn: Type, args: readonly Expr[], type: Type, node: Expr, scope: Scope): void {
    const wanted: Type[] = []
    let result = fn
    for (const _ of args) {
      let f = asFunction(result)
      if (f === undefined) {
        f = {from: this.fresh(), to: this.fresh()}
        const clash = unify(result, fun(f.from, f.to))
        if (clash !== undefined) this.problems.push({kind: "too-many-arguments", node, type: fn})
      }
      wanted.push(f.from)
      result = f.to
    }
    // The result first: what is wanted from outside explains best why an argument does not fit.
    this.same(type, result, node)
    for (const [i, a] of args.entries()) this.check(a, wanted[i] ?? this.fresh(), scope)
  }

  private record(e: Expr & {kind: "record"}, type: Type, scope: Scope): void {
    const info = this.env.constructors.get(e.name)
    if (info === undefined) {
      this.problems.push({kind: "unknown-name", node: e, name: e.name})
      for (const f of e.fields) this.check(f.value, this.fresh(), scope)
      return
    }
    const {fields, result} = this.opened(info.scheme, info.fields.length, e)
    this.same(type, result, e)
    for (const f of e.fields) {
      const at = info.fieldNames.indexOf(f.name)
      if (at < 0) this.problems.push({kind: "unknown-name", node: e, name: f.name})
      this.check(f.value, fields[at] ?? this.fresh(), scope)
    }
  }

  private comprehension(e: Expr & {kind: "comprehension"}, type: Type, scope: Scope): void {
    const item = this.fresh()
    this.same(type, listOf(item), e)
    let inner = scope
    for (const s of e.statements) {
      if (s.kind === "statement") this.check(s.expr, bool, inner)
      else if (s.kind === "let-statement") inner = this.group(s.declarations, inner, false)
      else {
        const each = this.fresh()
        this.check(s.expr, listOf(each), inner)
        this.distinct([s.pattern])
        const next = inner.inner()
        this.pattern(s.pattern, each, next)
        inner = next
      }
    }
    this.check(e.body, item, inner)
  }

  private doBlock(statements: readonly Statement[], type: Type, scope: Scope): void {
    const monad = this.fresh()
    let inner = scope
    statements.forEach((s, i) => {
      const last = i === statements.length - 1
      switch (s.kind) {
        case "statement": {
          const result = last ? type : app(monad, this.fresh())
          if (last) this.same(type, app(monad, this.fresh()), s.expr)
          this.check(s.expr, result, inner)
          if (statements.length > 1) this.want("Monad", monad, s.expr)
          break
        }
        case "bind": {
          const each = this.fresh()
          this.check(s.expr, app(monad, each), inner)
          this.want("Monad", monad, s.expr)
          this.distinct([s.pattern])
          const next = inner.inner()
          this.pattern(s.pattern, each, next)
          inner = next
          break
        }
        case "let-statement":
          inner = this.group(s.declarations, inner, false)
          break
        default:
          unreachable(s)
      }
    })
  }

  // --- Names and unification --------------------------------------------------------------------------------------

  private nameType(name: string, node: Node, scope: Scope): Type {
    const scheme = scope.get(name) ?? this.env.values.get(name)
    if (scheme !== undefined) return this.instantiate(scheme, node)
    if (this.lenient) {
      const stray = this.strays.get(name) ?? this.fresh()
      this.strays.set(name, stray)
      return stray
    }
    this.problems.push({kind: "unknown-name", node, name})
    return this.unknown()
  }

  /// The type of something that is wrong or only GHC knows; it decides nothing and is no reason for a second complaint.
  private unknown(): Type {
    const type = this.fresh()
    this.holes.push(type)
    return type
  }

  private operatorType(op: string, node: Expr, scope: Scope): Type {
    if (op === ":") {
      const item = this.fresh()
      return funs([item, listOf(item)], listOf(item))
    }
    return /^[:\p{Lu}]/u.test(op) ? this.constructorType(op, node) : this.nameType(op, node, scope)
  }

  private constructorType(name: string, node: Node): Type {
    if (name === "()") return con("()")
    if (name === "[]") return listOf(this.fresh())
    if (name === ":") return this.operatorType(":", node as Expr, new Scope())
    if (/^\(,+\)$/.test(name)) {
      const items = [...name.slice(1)].map(() => this.fresh())
      return funs(items, tupleOf(items))
    }
    const info = this.env.constructors.get(name)
    if (info !== undefined) return this.instantiate(info.scheme, node)
    this.problems.push({kind: "unknown-name", node, name})
    return this.unknown()
  }

  private instantiate(scheme: Scheme, node: Node): Type {
    if (scheme.variables.length === 0) {
      for (const c of scheme.constraints) this.want(c.name, c.type, node)
      return expand(scheme.type, this.env)
    }
    const by = new Map(scheme.variables.map(v => [v, this.fresh() as Type] as const))
    for (const c of scheme.constraints) this.want(c.name, substitute(c.type, by), node)
    return expand(substitute(scheme.type, by), this.env)
  }

  private want(name: string, type: Type, node: Node): void {
    this.wanted.push({name, type, node})
  }

  private same(wanted: Type, found: Type, node: Node): void {
    if (unify(wanted, found) !== undefined) this.problems.push({kind: "mismatch", node, wanted, found})
  }
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
