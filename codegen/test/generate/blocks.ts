/// Blocks with ids, and what a program that is being made may use by name.

import type {BlockId, Extra, SavedBlock} from "../../src/index.ts"
import {library} from "../../src/types/environment/standard_library.ts"
import type {Type} from "../../src/types/syntax/type.ts"
import {asFunction, spine} from "../../src/types/syntax/type.ts"
import type {Dice} from "./random.ts"

/// Types of functions in a `where` or `let`, as an author who knows types writes them there.
const localTypes = [
  "Double -> Double",
  "a -> a",
  "Bool -> Maybe Velocity",
  "Show a => a -> String",
  "Int -> [Int]",
]

/// A constructor of the program's own or the library's.
export interface WithOrigin {
  readonly con: string
  readonly of: string
  readonly parameters: readonly string[]
  readonly fields: readonly Type[]
  readonly fieldNames: readonly (string | undefined)[]
}

/// A function or value of the library.
export interface Named {
  readonly name: string
  readonly arity: number
}

/// Functions that fit everywhere and would be everywhere, and those that read and write files.
const left = new Set(
  `undefined error errorWithoutStackTrace mempty minBound maxBound seq read ioError fail head last appendFile writeFile readFile
  interact getChar getLine getContents readIO readLn userError mzero`.split(/\s+/),
)

function headOf(type: Type): string {
  const {head} = spine(type)
  return head.kind === "con" ? head.name : "*"
}

function reach(type: Type): {arity: number; result: Type} {
  let arity = 0
  let result = type
  for (let f = asFunction(result); f !== undefined; f = asFunction(result)) {
    arity++
    result = f.to
  }
  return {arity, result}
}

/// Library functions by what they make; `*` for those that make anything.
const makers = new Map<string, Named[]>()
export const everyName: Named[] = []
for (const [name, scheme] of library.values) {
  if (!/^[a-z]/.test(name) || left.has(name)) continue
  const {arity, result} = reach(scheme.type)
  everyName.push({name, arity})
  const head = headOf(result)
  makers.set(head, [...(makers.get(head) ?? []), {name, arity}])
}

export function makersOf(head: string): readonly Named[] {
  return makers.get(head) ?? []
}

/// Constructors by their type.
export const libraryConstructors: readonly WithOrigin[] = [...library.constructors.values()].map(c => ({
  con: c.name,
  of: c.of,
  parameters: library.types.get(c.of)?.parameters ?? [],
  fields: c.fields,
  fieldNames: c.fieldNames,
}))

const madeBy = new Map<string, WithOrigin[]>()
for (const c of libraryConstructors) madeBy.set(c.of, [...(madeBy.get(c.of) ?? []), c])

export class Maker {
  readonly dice: Dice
  readonly own: WithOrigin[] = []
  private ids = 0
  private names = 0

  constructor(dice: Dice) {
    this.dice = dice
  }

  id(): BlockId {
    return `g${this.ids++}`
  }

  name(): string {
    return `x${this.names++}`
  }

  block(
    type: string,
    extraState: Extra = {},
    inputs: {readonly [name: string]: SavedBlock} = {},
  ): SavedBlock {
    return {
      type,
      id: this.id(),
      extraState,
      inputs: Object.fromEntries(Object.entries(inputs).map(([k, block]) => [k, {block}])),
    }
  }

  named(): SavedBlock {
    return this.block("pattern_name", {name: this.name()})
  }

  call(name: string, args: number): SavedBlock {
    return this.block("name", {name, args, ...(args > 0 ? {fn: true} : {})})
  }

  constructorsOf(head: string): readonly WithOrigin[] {
    const own = this.own.filter(c => c.of === head)
    return own.length > 0 ? own : (madeBy.get(head) ?? [])
  }

  /// A stack of blocks, the first on top.
  stack(blocks: readonly SavedBlock[]): SavedBlock {
    return blocks.reduceRight((below, b) => ({...b, next: {block: below}}))
  }

  /// What follows `=`: plain, with conditions, or with definitions of its own.
  equation(depth: number): {extra: Extra; inputs: (i: number) => {[name: string]: SavedBlock}} {
    const none = () => ({})
    return this.dice.weighed<() => {extra: Extra; inputs: (i: number) => {[name: string]: SavedBlock}}>([
      [9, () => ({extra: {}, inputs: none})],
      [2, () => ({extra: {guards: 1 + this.dice.below(2), otherwise: true}, inputs: none})],
      [
        1,
        () => ({
          extra: {guards: 1, stacked: [0], otherwise: true},
          inputs: i => ({[`G${i}_0`]: this.question()}),
        }),
      ],
      [
        depth > 2 ? 0 : 2,
        () => {
          const inner = this.localDefinitions(depth + 1)
          const guards = this.dice.once(3) ? {guards: 1, otherwise: true} : {}
          return {extra: {...guards, where: true}, inputs: i => ({[`W${i}`]: inner})}
        },
      ],
    ])()
  }

  /// Definitions for `where` and `let`, mostly one.
  localDefinitions(depth: number): SavedBlock {
    const count = this.dice.once(4) ? 2 : 1
    return this.stack(Array.from({length: count}, () => this.localDefinition(depth)))
  }

  private localDefinition(depth: number): SavedBlock {
    if (this.dice.once(5))
      return this.block(
        "define_pattern",
        {},
        {P: this.block("pattern_tuple", {items: 2}, {I0: this.named(), I1: this.named()})},
      )
    if (this.dice.once(8)) return this.drawn()
    if (this.dice.once(8))
      return this.definition(this.name(), 1, 1, {signature: this.dice.pick(localTypes)}, depth)
    return this.definition(this.name(), this.dice.pick([0, 0, 1, 1, 2]), 1, {}, depth)
  }

  /// A number of chance, and the source to draw from next.
  private drawn(): SavedBlock {
    const pair = this.block("pattern_tuple", {items: 2}, {I0: this.named(), I1: this.named()})
    return this.block("define_pattern", {}, {P: pair, E0_0: this.call("randomR", 2)})
  }

  definition(name: string, arity: number, equations: number, extra: Extra = {}, depth = 0): SavedBlock {
    const parts = Array.from({length: arity === 0 ? 1 : equations}, () => this.equation(depth))
    const inputs = Object.assign({}, ...parts.map((p, i) => p.inputs(i))) as {[name: string]: SavedBlock}
    return this.block("define", {name, arity, equations: parts.map(p => p.extra), ...extra}, inputs)
  }

  /// A condition that is a stack: questions, and values taken apart.
  question(): SavedBlock {
    const ask = this.block("step_do")
    return this.dice.once(2)
      ? this.stack([
          this.block(
            "step_bind",
            {},
            {P: this.block("pattern_construct", {con: "Just", args: 1}, {A0: this.named()})},
          ),
          ask,
        ])
      : ask
  }

  /// Steps of a task; the last one does something.
  steps(depth: number): SavedBlock {
    const last = () =>
      this.dice.weighed<() => SavedBlock>([
        [3, () => this.block("step_do")],
        [2, () => this.block("step_say")],
        [2, () => this.block("step_wait")],
        [depth > 1 ? 0 : 1, () => this.block("step_repeat", {}, {S: this.steps(depth + 1)})],
        [depth > 1 ? 0 : 1, () => this.block("step_forever", {}, {S: this.steps(depth + 1)})],
        [depth > 1 ? 0 : 1, () => this.block("step_when", {}, {S: this.steps(depth + 1)})],
        [depth > 1 ? 0 : 1, () => this.block("step_unless", {}, {S: this.steps(depth + 1)})],
        [
          depth > 1 ? 0 : 1,
          () => this.block("step_if", {}, {T: this.steps(depth + 1), F: this.steps(depth + 1)}),
        ],
      ])()
    const first = () =>
      this.dice.weighed<() => SavedBlock>([
        [2, () => this.block("step_bind", {}, {P: this.named()})],
        [2, () => this.block("step_let", {}, {D: this.localDefinitions(2)})],
        [3, last],
      ])()
    const all = [...Array.from({length: this.dice.pick([0, 0, 1, 1, 2])}, first), last()]
    return this.stack(all.map(b => (this.dice.once(12) ? {...b, icons: {comment: {text: "why"}}} : b)))
  }

  /// Where a comprehension takes its items from.
  sources(): SavedBlock {
    const from = () => this.block("step_bind", {}, {P: this.named()})
    const where = () => this.block("step_do")
    return this.stack(this.dice.pick([() => [from()], () => [from(), where()], () => [from(), from()]])())
  }
}
