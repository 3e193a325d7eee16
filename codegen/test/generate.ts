/// Random programs, built as a learner builds them: one block after the other, each only where the checker lets it go.

import type {BlockId, Place, SavedBlock, SavedWorkspace} from "../src/index.ts"
import {blockView, checker, infer, namesInScope, newWorkspace, plug} from "../src/index.ts"
import {choices} from "../src/blocks/vocabulary.ts"
import {library} from "../src/types/library.ts"
import {asFunction} from "../src/types/type.ts"
import {everyBlock} from "../src/workspace/infer.ts"

/// A small generator of random numbers, the same for the same seed. (Mulberry32)
export function randomFrom(seed: number): () => number {
  let state = seed >>> 0
  return () => {
    state = (state + 0x6d2b79f5) >>> 0
    let t = Math.imul(state ^ (state >>> 15), 1 | state)
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296
  }
}

export interface Generated {
  readonly workspace: SavedWorkspace
  readonly blocks: number
  /// No socket is empty and nothing is left to decide: GHC must accept it.
  readonly whole: boolean
}

export function generateProgram(seed: number, size: number): Generated {
  return new Generator(seed, size).run()
}

class Generator {
  private readonly random: () => number
  private readonly size: number
  private ids = 0
  private names = 0
  private workspace: SavedWorkspace = newWorkspace()
  private readonly own: {con: string; args: number}[] = []

  constructor(seed: number, size: number) {
    this.random = randomFrom(seed)
    this.size = size
  }

  run(): Generated {
    const tops: SavedBlock[] = []
    for (let i = this.below(3); i > 0; i--) tops.push(this.dataType(`T${i}`))
    const functions = 1 + this.below(4)
    for (let i = 0; i < functions; i++) tops.push(this.definition(`f${i}`, this.below(3), 1 + this.below(2)))
    const controllers = 1 + this.below(2)
    const main: SavedBlock = {type: "main", id: this.id(), extraState: {controllers}}
    this.workspace = {blocks: {languageVersion: 0, blocks: [...tops, main]}}
    for (let step = 0; step < this.size * 4; step++) {
      const place = this.emptySocket(step < this.size)
      if (place === undefined) break
      this.fill(place, this.count() > this.size || step > this.size * 2)
    }
    const whole = infer(this.workspace).problems.length === 0
    return {workspace: this.workspace, blocks: this.count(), whole}
  }

  private below(n: number): number {
    return Math.floor(this.random() * n)
  }

  private pick<T>(items: readonly T[]): T {
    return items[this.below(items.length)] as T
  }

  private id(): BlockId {
    return `g${this.ids++}`
  }

  private name(): string {
    return `x${this.names++}`
  }

  private count(): number {
    let n = 0
    for (const _ of everyBlock(this.workspace)) n++
    return n
  }

  private block(type: string, extraState: SavedBlock["extraState"] = {}, inputs: {[name: string]: SavedBlock} = {}): SavedBlock {
    return {type, id: this.id(), extraState, inputs: Object.fromEntries(Object.entries(inputs).map(([k, block]) => [k, {block}]))}
  }

  private dataType(name: string): SavedBlock {
    const types = ["Double", "Bool", "String", "Velocity", "Int", "Maybe Sound", "LedColor"]
    const constructors = Array.from({length: 1 + this.below(3)}, (_, i) => {
      const fields = Array.from({length: this.below(3)}, () => ({type: this.pick(types)}))
      this.own.push({con: `${name}C${i}`, args: fields.length})
      return {name: `${name}C${i}`, fields}
    })
    return this.block("data", {name, constructors})
  }

  private definition(name: string, arity: number, equations: number): SavedBlock {
    const parts = Array.from({length: arity === 0 ? 1 : equations}, () => {
      const dice = this.below(6)
      return dice === 0 ? {guards: 1, otherwise: true} : dice === 1 ? {where: true} : {}
    })
    const block = this.block("define", {name, arity, equations: parts})
    parts.forEach((p, i) => {
      if (p.where === true && block.inputs !== undefined) block.inputs[`W${i}`] = {block: this.definition(this.name(), this.below(2), 1)}
    })
    return block
  }

  /// A random empty socket; patterns before expressions, so that names are there to use.
  private emptySocket(patternsToo: boolean): (Place & {input: string; sort: string}) | undefined {
    const empty: (Place & {input: string; sort: string})[] = []
    for (const b of everyBlock(this.workspace))
      for (const row of blockView(b.type)?.shape(b.extraState ?? {}).rows ?? [])
        for (const item of row) {
          if (item.kind !== "socket" && item.kind !== "stack") continue
          if (b.inputs?.[item.name]?.block !== undefined || b.id === undefined) continue
          const sort = item.kind === "stack" ? `${item.sort}s` : item.sort
          if (sort === "pattern" && !patternsToo) continue
          empty.push({block: b.id, input: item.name, sort})
        }
    const patterns = empty.filter(e => e.sort === "pattern")
    const from = patterns.length > 0 && this.below(3) > 0 ? patterns : empty
    return from.length === 0 ? undefined : this.pick(from)
  }

  private fill(place: Place & {input: string; sort: string}, small: boolean): void {
    const check = checker(this.workspace)
    const at: Place = {block: place.block, input: place.input}
    const tries = small ? 40 : 12
    const scope = place.sort === "expression" ? namesInScope(this.workspace, at).filter(n => n.fits) : []
    for (let i = 0; i < tries; i++) {
      const block =
        scope.length > 0 && this.below(3) === 0
          ? {...this.pick(scope).block, id: this.id()}
          : place.sort === "pattern"
            ? this.somePattern()
            : place.sort === "steps"
              ? this.someStep()
              : place.sort === "definitions"
                ? this.definition(this.name(), this.below(2), 1)
                : this.someExpr(small || i > 6)
      if (!check.fits(at, block).fits) continue
      this.workspace = plug(this.workspace, at, block)
      return
    }
    // A name that fits anywhere rather than a socket that stays empty.
    const last = scope.length > 0 ? {...this.pick(scope).block, id: this.id()} : undefined
    if (last !== undefined) this.workspace = plug(this.workspace, at, last)
  }

  private someExpr(small: boolean): SavedBlock {
    const leaves: (() => SavedBlock)[] = [
      () => this.block("number", {value: this.pick(["0", "1", "0.5", "2", "-3"])}),
      () => this.block("text", {value: this.pick(["", "hi", "a\"b"])}),
      () => {
        const of = this.pick(Object.keys(choices))
        return this.block("choice", {of, value: this.pick(choices[of]?.options ?? ["True"])})
      },
      () => this.constructor_("construct", 0),
      () => this.block("tuple", {items: 0}),
      () => this.block("list", {items: 0}),
      () => this.call(0),
    ]
    const nodes: (() => SavedBlock)[] = [
      () => this.constructor_("construct", undefined),
      () => this.constructor_("construct", undefined),
      () => this.call(undefined),
      () => this.call(undefined),
      () => this.block("infix", {op: this.pick(["+", "-", "*", "/", "==", "<", "&&", "||", "++", ":", "$", ".", "<>", "div", "^", "/="])}),
      () => this.block("if"),
      () => this.block("negate"),
      () => this.block("tuple", {items: 2 + this.below(2)}),
      () => this.block("list", {items: 1 + this.below(2)}),
      () => this.block("lambda", {inputs: 1}, {P0: this.block("pattern_name", {name: this.name()})}),
      () => this.block("section", {op: this.pick(["+", "*", "==", "++", "-"]), side: this.pick(["left", "right"])}),
      () => this.block("let", {}, {D: this.definition(this.name(), this.below(2), 1)}),
      () => this.block("case", {alternatives: [{}, {}]}),
      () => this.block("range", this.pick([{}, {step: true}])),
      () => this.block("do"),
      () => this.block("apply", {args: 1}),
    ]
    return this.pick(small ? leaves : this.below(3) === 0 ? leaves : nodes)()
  }

  private somePattern(): SavedBlock {
    return this.pick<() => SavedBlock>([
      () => this.block("pattern_name", {name: this.name()}),
      () => this.block("pattern_name", {name: this.name()}),
      () => this.block("pattern_any", {what: "thing"}),
      () => this.constructor_("pattern_construct", undefined),
      () => this.constructor_("pattern_construct", undefined),
      () => {
        const of = this.pick(Object.keys(choices))
        return this.block("pattern_choice", {of, value: this.pick(choices[of]?.options ?? ["True"])})
      },
      () => this.block("pattern_tuple", {items: 2}),
      () => this.block("pattern_list", {items: this.below(2)}),
      () => this.block("pattern_infix", {op: ":"}),
      () => this.block("pattern_as", {name: this.name()}),
      () => this.block("pattern_number", {value: this.pick(["0", "1", "-1", "0.5"])}),
      () => this.block("pattern_text", {value: "hi"}),
    ])()
  }

  private someStep(): SavedBlock {
    const last = this.pick<() => SavedBlock>([
      () => this.block("step_do"),
      () => this.block("step_say"),
      () => this.block("step_wait"),
    ])()
    const first = this.pick<() => SavedBlock>([
      () => this.block("step_do"),
      () => this.block("step_bind", {}, {P: this.block("pattern_name", {name: this.name()})}),
      () => this.block("step_repeat"),
      () => this.block("step_forever"),
      () => this.block("step_when"),
      () => this.block("step_unless"),
      () => this.block("step_if"),
      () => this.block("step_let", {}, {D: this.definition(this.name(), this.below(2), 1)}),
    ])()
    return this.below(3) === 0 ? last : {...first, next: {block: last}}
  }

  private constructor_(type: string, args: number | undefined): SavedBlock {
    const all = [...[...library.constructors.values()].map(c => ({con: c.name, args: c.fields.length})), ...this.own, ...this.own]
    const some = args === undefined ? all : all.filter(c => c.args === args)
    const chosen = this.pick(some)
    return this.block(type, {con: chosen.con, args: chosen.args})
  }

  /// A library function with some or all of its inputs.
  private call(args: number | undefined): SavedBlock {
    const [name, scheme] = this.pick([...library.values].filter(([n]) => /^[a-z]/.test(n)))
    let arity = 0
    for (let f = asFunction(scheme.type); f !== undefined; f = asFunction(f.to)) arity++
    return this.block("name", {name, args: args ?? this.pick([arity, arity, this.below(arity + 1)])})
  }
}
