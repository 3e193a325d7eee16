/// Random programs, built as a learner builds them: one block after the other, each only where the checker lets it go.

import {choices} from "../src/blocks/vocabulary.ts"
import type {BlockId, Place, SavedBlock, SavedWorkspace} from "../src/index.ts"
import {blockView, checker, infer, namesInScope, newWorkspace, plug, socketKey} from "../src/index.ts"
import {expand} from "../src/types/environment.ts"
import {library} from "../src/types/library.ts"
import {parseType} from "../src/types/parse.ts"
import {asFunction, showType, spine} from "../src/types/type.ts"
import {everyBlock, inferenceOf} from "../src/workspace/infer.ts"
import {Session} from "../src/workspace/session.ts"

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

/// An empty socket or stack.
interface Empty {
  readonly block: BlockId
  readonly input: string
  readonly sort: string
}

export function generateProgram(seed: number, size: number): Generated {
  return new Generator(seed, size).run()
}

/// Functions that fit everywhere and would be everywhere.
const fitsAnything = new Set([
  "undefined",
  "error",
  "errorWithoutStackTrace",
  "mempty",
  "minBound",
  "maxBound",
  "seq",
  "read",
  "ioError",
  "fail",
  "head",
  "last",
])

class Generator {
  private readonly random: () => number
  private readonly size: number
  private ids = 0
  private readonly session = new Session()
  private names = 0
  private workspace: SavedWorkspace = newWorkspace()
  private readonly own: {con: string; args: number; of: string}[] = []

  constructor(seed: number, size: number) {
    this.random = randomFrom(seed)
    this.size = size
  }

  run(): Generated {
    const tops: SavedBlock[] = []
    for (let i = this.below(3); i > 0; i--) tops.push(this.dataType(`T${i}`))
    const functions = 1 + this.below(4)
    for (let i = 0; i < functions; i++)
      tops.push(
        this.below(5) === 0
          ? this.definition(`f${i}`, this.below(3), 1 + this.below(2))
          : this.typed(`f${i}`),
      )
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

  private block(
    type: string,
    extraState: SavedBlock["extraState"] = {},
    inputs: {[name: string]: SavedBlock} = {},
  ): SavedBlock {
    return {
      type,
      id: this.id(),
      extraState,
      inputs: Object.fromEntries(Object.entries(inputs).map(([k, block]) => [k, {block}])),
    }
  }

  private dataType(name: string): SavedBlock {
    const types = ["Double", "Bool", "String", "Velocity", "Int", "Maybe Sound", "LedColor"]
    const constructors = Array.from({length: 1 + this.below(3)}, (_, i) => {
      const fields = Array.from({length: this.below(3)}, () => ({type: this.pick(types)}))
      this.own.push({con: `${name}C${i}`, args: fields.length, of: name})
      return {name: `${name}C${i}`, fields}
    })
    return this.block("data", {name, constructors})
  }

  /// A top-level definition with a type of its own, as most in real programs.
  private typed(name: string): SavedBlock {
    const own = this.own.map(c => c.of)
    const sensors = [
      "Bumper",
      "Cliff",
      "Wheel",
      "Velocity",
      "Orientation",
      "Memory Bool",
      "Seconds",
      "Either Bumper Wheel",
      "(Velocity, Bumper)",
      "()",
      ...own,
    ]
    const commands = [
      "Velocity",
      "Led1",
      "Maybe Sound",
      "(Led1, Led2)",
      "Either Velocity Sound",
      "Memory Bool",
      "[Say]",
      "Say",
      ...own,
    ]
    const plain = [
      "Double",
      "Int",
      "Bool",
      "String",
      "[Int]",
      "Maybe Double",
      "Task ()",
      "Double -> Double",
      "Task Bool",
      ...own,
    ]
    const inputs = Array.from({length: this.below(3)}, () => this.pick(this.below(4) === 0 ? plain : sensors))
    const bracket = (t: string) => (t.includes("->") ? `(${t})` : t)
    const result = this.pick(this.below(3) === 0 ? plain : commands)
    const arity = inputs.length
    const block = this.definition(name, arity, 1 + this.below(2))
    return {
      ...block,
      extraState: {...block.extraState, signature: [...inputs.map(bracket), result].join(" -> ")},
    }
  }

  private definition(name: string, arity: number, equations: number): SavedBlock {
    const parts = Array.from({length: arity === 0 ? 1 : equations}, () => {
      const dice = this.below(6)
      return dice === 0 ? {guards: 1, otherwise: true} : dice === 1 ? {where: true} : {}
    })
    const block = this.block("define", {name, arity, equations: parts})
    parts.forEach((p, i) => {
      if (p.where === true && block.inputs !== undefined)
        block.inputs[`W${i}`] = {block: this.definition(this.name(), this.below(2), 1)}
    })
    return block
  }

  /// A random empty socket; patterns before expressions, so that names are there to use.
  private emptySocket(patternsToo: boolean): Empty | undefined {
    const empty: Empty[] = []
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

  private fill(place: Empty, small: boolean): void {
    const check = checker(this.workspace, this.session)
    const at: Place = {block: place.block, input: place.input}
    const tries = small ? 40 : 12
    const wanted =
      inferenceOf(this.workspace, this.session.solve(this.workspace)).sockets.get(
        socketKey(place.block, place.input),
      )?.type ?? "a"
    const scope =
      place.sort === "expression" && this.below(2) === 0
        ? namesInScope(this.workspace, at, this.session).filter(n => n.fits)
        : []
    for (let i = 0; i < tries; i++) {
      const block =
        scope.length > 0 && (place.input.startsWith("R") || this.below(3) === 0)
          ? {...this.pick(scope).block, id: this.id()}
          : place.sort === "pattern"
            ? this.somePattern(wanted)
            : place.sort === "steps"
              ? this.someStep()
              : place.sort === "definitions"
                ? this.definition(this.name(), this.below(2), 1)
                : i % 3 === 2
                  ? this.someExpr(small || i > 6)
                  : (this.forType(wanted, small, "construct") ?? this.someExpr(small || i > 6))
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
      () => this.block("text", {value: this.pick(["", "hi", 'a"b'])}),
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
      () =>
        this.block("infix", {
          op: this.pick([
            "+",
            "-",
            "*",
            "/",
            "==",
            "<",
            "&&",
            "||",
            "++",
            ":",
            "$",
            ".",
            "<>",
            "div",
            "^",
            "/=",
          ]),
        }),
      () => this.block("if"),
      () => this.block("negate"),
      () => this.block("tuple", {items: 2 + this.below(2)}),
      () => this.block("list", {items: 1 + this.below(2)}),
      () => this.block("lambda", {inputs: 1}, {P0: this.block("pattern_name", {name: this.name()})}),
      () =>
        this.block("section", {
          op: this.pick(["+", "*", "==", "++", "-"]),
          side: this.pick(["left", "right"]),
        }),
      () => this.block("let", {}, {D: this.definition(this.name(), this.below(2), 1)}),
      () => this.block("case", {alternatives: [{}, {}]}),
      () => this.block("range", this.pick([{}, {step: true}])),
      () => this.block("do"),
      () => this.block("apply", {args: 1}),
    ]
    return this.pick(small ? leaves : this.below(3) === 0 ? leaves : nodes)()
  }

  /// A literal, constructor or call whose result has the wanted type's head.
  private forType(
    wanted: string,
    small: boolean,
    kind: "construct" | "pattern_construct",
  ): SavedBlock | undefined {
    const type = parseType(wanted)
    if (type === undefined) return undefined
    const {head, args} = spine(expand(type, library))
    if (head.kind !== "con") return undefined
    const pattern = kind === "pattern_construct"
    const [first] = args
    if (
      ["Double", "Int", "Integer", "Seconds", "Orientation"].includes(head.name) &&
      this.below(small ? 1 : 2) === 0
    )
      return this.block(pattern ? "pattern_number" : "number", {value: this.pick(["0", "1", "2", "10"])})
    if (/^\(,+\)$/.test(head.name))
      return this.block(pattern ? "pattern_tuple" : "tuple", {items: args.length})
    if (head.name === "()") return this.block(pattern ? "pattern_tuple" : "tuple", {items: 0})
    if (head.name === "[]" && first !== undefined) {
      if (showType(type) === "String") return this.block(pattern ? "pattern_text" : "text", {value: "hi"})
      return this.block(pattern ? "pattern_list" : "list", {items: small ? 0 : this.below(3)})
    }
    if (head.name === "->" && !pattern)
      return this.block("lambda", {inputs: 1}, {P0: this.block("pattern_name", {name: this.name()})})
    if (head.name === "Task" && !pattern && this.below(2) === 0) return this.block("do")
    const of = choices[head.name]
    if (of !== undefined)
      return this.block(pattern ? "pattern_choice" : "choice", {of: head.name, value: this.pick(of.options)})
    const made = [
      ...[...library.constructors.values()].map(c => ({con: c.name, args: c.fields.length, of: c.of})),
      ...this.own,
    ].filter(c => c.of === head.name)
    const leaves = made.filter(c => c.args === 0)
    if (made.length > 0) {
      const c = this.pick(small && leaves.length > 0 ? leaves : made)
      return this.block(kind, {con: c.con, args: c.args})
    }
    if (pattern) return undefined
    const makers = [...library.values].flatMap(([name, scheme]) => {
      let arity = 0
      let result = scheme.type
      for (let f = asFunction(result); f !== undefined; f = asFunction(result)) {
        arity++
        result = f.to
      }
      const {head: h} = spine(result)
      return h.kind === "con" && h.name === head.name && /^[a-z]/.test(name) && !fitsAnything.has(name)
        ? [{name, arity}]
        : []
    })
    if (makers.length === 0) return undefined
    const maker = this.pick(makers)
    return this.block("name", {name: maker.name, args: maker.arity})
  }

  private somePattern(wanted: string): SavedBlock {
    const fitting = this.below(2) === 0 ? this.forType(wanted, false, "pattern_construct") : undefined
    if (fitting !== undefined) return fitting
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
    const all = [
      ...[...library.constructors.values()].map(c => ({con: c.name, args: c.fields.length})),
      ...this.own,
      ...this.own,
    ]
    const some = args === undefined ? all : all.filter(c => c.args === args)
    const chosen = this.pick(some)
    return this.block(type, {con: chosen.con, args: chosen.args})
  }

  /// A library function with some or all of its inputs.
  private call(args: number | undefined): SavedBlock {
    const [name, scheme] = this.pick(
      [...library.values].filter(([n]) => /^[a-z]/.test(n) && !fitsAnything.has(n)),
    )
    let arity = 0
    for (let f = asFunction(scheme.type); f !== undefined; f = asFunction(f.to)) arity++
    return this.block("name", {name, args: args ?? this.pick([arity, arity, this.below(arity + 1)])})
  }
}
