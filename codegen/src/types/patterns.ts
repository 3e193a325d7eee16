/// The types of patterns, and the names they bring into scope.

import {isFractionalLiteral} from "../haskell/lexemes.ts"
import type {Pattern} from "../model/tree.ts"
import {unreachable} from "../model/tree.ts"
import {bindersIn} from "../model/uses.ts"
import {Constraints} from "./constraints.ts"
import type {Scope} from "./scope.ts"
import {mono} from "./state.ts"
import type {Type} from "./type.ts"
import {con, listOf, string, tupleOf} from "./type.ts"

export class Patterns extends Constraints {
  /// A name may stand only once among the patterns that are matched together. (Haskell 2010 report §3.17.1)
  protected distinct(patterns: readonly Pattern[]): void {
    const seen = new Set<string>()
    for (const [name, node] of patterns.flatMap(bindersIn)) {
      if (seen.has(name)) this.problems.push({kind: "twice", node: node as Pattern, name})
      seen.add(name)
    }
  }

  protected pattern(p: Pattern, type: Type, scope: Scope): void {
    this.found.set(p, type)
    switch (p.kind) {
      case "name-pattern":
        scope.set(p.name, mono(type))
        return
      case "wildcard":
        this.look(p.from, type, scope)
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
        if (info === undefined || info.scheme.unknown === true) {
          if (info === undefined && !this.unseen(p.name))
            this.problems.push({kind: "unknown-name", node: p, name: p.name})
          this.holes.push(type)
          for (const f of p.fields) this.pattern(f.pattern, this.unknown(), scope)
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
        // Two dots name all parts of a record.
        for (const [, name = ""] of p.text.matchAll(/([\p{Lu}][\p{L}\p{N}_']*)\s*\{[^{}]*\.\.\s*\}/gu))
          for (const field of this.env.constructors.get(name)?.fieldNames ?? [])
            if (field !== undefined) scope.set(field, mono(this.unknown()))
        return
      default:
        unreachable(p)
    }
  }

  protected constructorPattern(p: Pattern & {kind: "constructor-pattern"}, type: Type, scope: Scope): void {
    if (p.name === "()" && p.args.length === 0) {
      this.same(type, con("()"), p)
      return
    }
    const info = this.env.constructors.get(p.name)
    if (info === undefined || info.scheme.unknown === true) {
      this.opaque++
      if (info === undefined && !this.unseen(p.name))
        this.problems.push({kind: "unknown-name", node: p, name: p.name})
      this.holes.push(type)
      for (const a of p.args) this.pattern(a, this.unknown(), scope)
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
}
