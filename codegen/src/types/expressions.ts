/// The types of expressions and of the steps of a `do`.

import {isFractionalLiteral} from "../haskell/lexemes.ts"
import type {Alternative, Expr, Statement} from "../model/tree.ts"
import {unreachable} from "../model/tree.ts"
import {Bindings} from "./bindings.ts"
import {expand} from "./environment.ts"
import type {Scope} from "./scope.ts"
import {unify} from "./solve.ts"
import type {Type} from "./type.ts"
import {
  app,
  asFunction,
  bool,
  con,
  fun,
  funs,
  listOf,
  spine,
  string,
  substitute,
  tupleOf,
  variablesIn,
} from "./type.ts"

export class Expressions extends Bindings {
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
        const inner = scope.inner()
        const result = this.parameters(e.parameters, type, inner)
        this.check(e.body, result, inner)
        return
      }
      case "if":
        this.check(e.condition, bool, scope)
        this.check(e.yes, type, scope)
        this.check(e.no, type, scope)
        return
      case "branches":
        for (const g of e.branches) this.check(g.body, type, this.guards(g.guards, scope))
        return
      case "case": {
        const scrutinee = this.fresh()
        this.check(e.scrutinee, scrutinee, scope)
        this.alternatives(e.alternatives, scrutinee, type, scope)
        return
      }
      case "lambda-case": {
        const [from, to] = [this.fresh(), this.fresh()]
        this.same(type, fun(from, to), e)
        this.alternatives(e.alternatives, from, to, scope)
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
        this.update(e, type, scope)
        return
      case "hole":
        this.holes.push(type)
        this.look(e.from, type, scope)
        return
      case "raw":
        // GHC will say; until then it fits anywhere and decides nothing, but that it is a function where it says so.
        this.holes.push(type)
        if (/^\\ *case(?![\p{L}\p{N}_'])/u.test(e.text.trim()))
          this.same(type, fun(this.unknown(), this.unknown()), e)
        return
      default:
        unreachable(e)
    }
  }

  private alternatives(all: readonly Alternative[], of: Type, type: Type, scope: Scope): void {
    for (const a of all) {
      this.distinct([a.pattern])
      const inner = scope.inner()
      this.pattern(a.pattern, of, inner)
      this.rightSide(a.right, type, inner)
    }
  }

  protected application(fn: Type, args: readonly Expr[], type: Type, node: Expr, scope: Scope): void {
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

  protected record(e: Expr & {kind: "record"}, type: Type, scope: Scope): void {
    const info = this.env.constructors.get(e.name)
    if (info === undefined || info.scheme.unknown === true) {
      if (info === undefined && !this.unseen(e.name))
        this.problems.push({kind: "unknown-name", node: e, name: e.name})
      this.holes.push(type)
      for (const f of e.fields) this.check(f.value, this.unknown(), scope)
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

  /// A changed copy may have another type: all that no kept part is made of is open again. (Haskell 2010 report §3.15.3)
  protected update(e: Expr & {kind: "update"}, type: Type, scope: Scope): void {
    const names = e.fields.map(f => f.name)
    const of = this.recordWith(names)
    if (of === undefined) {
      const [unknown] = names.filter(n => this.recordWith([n]) === undefined)
      const name = unknown ?? names[0] ?? ""
      const known = this.env.values.get(name)?.unknown === true || this.unseen(name)
      if (!known) this.problems.push({kind: "unknown-name", node: e, name})
      this.holes.push(type)
      this.check(e.record, this.unknown(), scope)
      for (const f of e.fields) this.check(f.value, this.unknown(), scope)
      return
    }
    const {name, parameters, constructors} = of
    const kept = new Set<string>()
    const changed = new Map<string, Type>()
    for (const c of constructors)
      c.fields.forEach((field, i) => {
        const at = c.fieldNames[i]
        if (at !== undefined && names.includes(at)) changed.set(at, field)
        else for (const v of variablesIn(field)) kept.add(v)
      })
    const before = new Map(parameters.map(p => [p, this.fresh() as Type]))
    const after = new Map([...before].map(([p, t]) => [p, kept.has(p) ? t : this.fresh()]))
    this.same(type, app(con(name), ...after.values()), e)
    this.check(e.record, app(con(name), ...before.values()), scope)
    for (const f of e.fields) {
      const field = changed.get(f.name)
      this.check(
        f.value,
        field === undefined ? this.fresh() : expand(substitute(field, after), this.env),
        scope,
      )
    }
  }

  /// The type whose constructors have all these fields, with the constructors that have them.
  private recordWith(names: readonly string[]) {
    const [first = ""] = names
    const selector = this.env.values.get(first)
    const head = selector === undefined ? undefined : asFunction(selector.type)
    const name = head === undefined ? undefined : spine(head.from).head
    const entry = name?.kind === "con" ? this.env.types.get(name.name) : undefined
    if (name?.kind !== "con" || entry === undefined) return undefined
    const constructors = entry.constructors
      .flatMap(c => this.env.constructors.get(c) ?? [])
      .filter(c => names.every(n => c.fieldNames.includes(n)))
    return constructors.length === 0
      ? undefined
      : {name: name.name, parameters: entry.parameters, constructors}
  }

  protected comprehension(e: Expr & {kind: "comprehension"}, type: Type, scope: Scope): void {
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

  protected doBlock(statements: readonly Statement[], type: Type, scope: Scope): void {
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
}
