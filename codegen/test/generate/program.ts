/// Random programs, built as a learner builds them: one block after the other, each only where the checker lets it go.
///
/// What cannot be filled is taken away again, and something small goes in its place, so that nearly every program gets finished.

import type {BlockId, Place, SavedBlock, SavedWorkspace} from "../../src/index.ts"
import {blockView, checker, newWorkspace, plug} from "../../src/index.ts"
import {metasIn, variablesIn} from "../../src/types/syntax/type.ts"
import {parseType} from "../../src/types/syntax/type_parser.ts"
import {InferenceSession} from "../../src/workspace/inference/inference_session.ts"
import {everyBlock, everyBlockIn, problemsOf} from "../../src/workspace/inference/workspace_inference.ts"
import {find, without} from "../../src/workspace/moves/block_moves.ts"
import {Maker} from "./blocks.ts"
import {proposePattern} from "./patterns.ts"
import {Dice} from "./random.ts"
import {signatureFor} from "./signatures.ts"
import type {Known} from "./values.ts"
import {Values} from "./values.ts"

export interface Generated {
  readonly workspace: SavedWorkspace
  readonly blocks: number
  /// 5 to 150 blocks, no socket empty, and nothing left to decide: GHC must accept it.
  readonly whole: boolean
}

export function generateProgram(seed: number, size: number): Generated {
  return new Generator(seed, size).run()
}

/// 5 to 150 blocks, small programs more often than large ones.
export function sizeOf(seed: number): number {
  const dice = new Dice(seed + 77_777)
  return dice.once(10) ? 60 + dice.below(71) : 5 + dice.below(40)
}

/// Names for types, and what they stand for.
const synonyms = {Speed: "Double", "Pair a": "(a, a)", Heard: "Either Bumper Cliff"}

/// An empty socket or stack.
interface Empty {
  readonly block: BlockId
  readonly input: string
  readonly sort: string
  readonly tries: number
}

class Generator {
  private readonly dice: Dice
  private readonly make: Maker
  private readonly values: Values
  private readonly size: number
  private readonly session = new InferenceSession()
  private workspace: SavedWorkspace = newWorkspace()
  private empties: Empty[] = []
  private count = 0
  /// Its synonyms, as signatures write them.
  private readonly called: string[] = []

  constructor(seed: number, size: number) {
    this.dice = new Dice(seed)
    this.make = new Maker(this.dice)
    this.values = new Values(this.make)
    this.size = size
  }

  run(): Generated {
    const {make, dice} = this
    const tops: SavedBlock[] = []
    if (this.size > 8) for (let i = dice.pick([0, 0, 1, 1, 2]); i > 0; i--) tops.push(this.dataType(`T${i}`))
    for (const [name, of] of Object.entries(synonyms))
      if (dice.once(6)) {
        const [head = "", ...parameters] = name.split(" ")
        tops.push(
          make.block("synonym", {name: head, type: of, ...(parameters.length > 0 ? {parameters} : {})}),
        )
        this.called.push([head, ...parameters.map(() => "Double")].join(" "))
      }
    const functions = Math.max(1, Math.min(12, Math.round(this.size / 24) + dice.below(2)))
    for (let i = 0; i < functions; i++) tops.push(this.topLevel(`f${i}`))
    const most = dice.once(12) ? 9 : Math.min(3, functions)
    if (dice.once(3)) tops.push(...this.instance())
    const main = make.block("main", {controllers: 1 + dice.below(most)})
    this.workspace = {blocks: {languageVersion: 0, blocks: [...tops, main]}}
    for (const b of this.workspace.blocks.blocks) this.grew(b)
    this.fillAll()
    const settled = this.settle()
    const blocks = [...everyBlock(this.workspace)].length
    return {workspace: this.workspace, blocks, whole: settled && blocks >= 5 && blocks <= 150}
  }

  private dataType(name: string): SavedBlock {
    const {make, dice} = this
    const parameters = dice.once(4) ? ["a", "b"].slice(0, 1 + dice.below(2)) : []
    const types = [
      "Double",
      "Bool",
      "String",
      "Velocity",
      "Int",
      "Maybe Sound",
      "LedColor",
      "[Int]",
      ...parameters.flatMap(p => [p, p, `Maybe ${p}`, `[${p}]`, `(${p}, Int)`]),
    ]
    const named = dice.once(3)
    const constructors = Array.from({length: 1 + dice.below(dice.once(5) ? 5 : 3)}, (_, i) => {
      const fields = Array.from({length: dice.below(dice.once(5) ? 5 : 3)}, (_, j) => ({
        type: dice.pick(types),
        ...(named ? {name: `${name.toLowerCase()}c${i}${"abcde"[j]}`} : {}),
      }))
      make.own.push({
        con: `${name}C${i}`,
        of: name,
        parameters,
        fields: fields.map(f => parseType(f.type) ?? {kind: "con", name: "()"}),
        fieldNames: fields.map(f => f.name),
      })
      return {name: `${name}C${i}`, fields}
    })
    const one = constructors.length === 1 && constructors[0]?.fields.length === 1
    return make.block("data", {
      name,
      constructors,
      ...(parameters.length > 0 ? {parameters} : {}),
      ...(one && !dice.once(4) ? {newtype: true} : {}),
    })
  }

  /// What one of its types can do, written by hand.
  private instance(): SavedBlock[] {
    const {make, dice} = this
    if (make.own.length === 0) return []
    const {of, parameters} = dice.pick(make.own)
    const whole = [of, ...parameters].join(" ")
    const type = parameters.length > 0 ? `(${whole})` : whole
    const context = parameters.length > 0 && dice.once(2) ? `Show ${parameters[0]} => ` : ""
    const partial =
      parameters.slice(0, -1).length === 0 ? of : `(${[of, ...parameters.slice(0, -1)].join(" ")})`
    const [head, method, arity] = dice.pick<readonly [string, string, number]>([
      [`${context}Show ${type}`, "show", 1],
      [`${context}Eq ${type}`, "==", 2],
      [`Semigroup ${type}`, "<>", 2],
      ...(parameters.length > 0
        ? ([
            [`Functor ${partial}`, "fmap", 2],
            [`Foldable ${partial}`, "foldr", 3],
          ] as const)
        : ([[`Ord ${type}`, "<=", 2]] as const)),
    ])
    const made = make.definition(method, arity, 1 + dice.below(2))
    return [make.block("instance", {head: `instance ${head}`}, {D: made})]
  }

  /// Most definitions of real programs have a type of their own.
  private topLevel(name: string): SavedBlock {
    const {make, dice} = this
    const types = make.own.map(c => [c.of, ...c.parameters.map(() => "Double")].join(" "))
    const own = [...new Set([...types, ...this.called])]
    const comment = dice.once(8) ? {icons: {comment: {text: dice.pick(["what it does", "two\nlines"])}}} : {}
    if (dice.once(5)) return {...make.definition(name, dice.below(3), 1 + dice.below(2)), ...comment}
    const {text, arity} = signatureFor(dice, own)
    return {...make.definition(name, arity, 1 + dice.below(2), {signature: text}), ...comment}
  }

  // --- Filling ----------------------------------------------------------------------------------------------------

  /// New sockets to fill.
  private grew(top: SavedBlock, tries = 0): void {
    for (const b of everyBlockIn(top)) {
      this.count++
      for (const row of blockView(b.type)?.shape(b.extraState ?? {}).rows ?? [])
        for (const item of row) {
          if (item.kind !== "socket" && item.kind !== "stack") continue
          if (b.inputs?.[item.name]?.block !== undefined || b.id === undefined) continue
          this.empties.push({
            block: b.id,
            input: item.name,
            sort: item.kind === "stack" ? `${item.sort}s` : item.sort,
            tries,
          })
        }
    }
  }

  private fillAll(): void {
    for (let step = 0; step < 600 && this.empties.length > 0; step++) {
      // Patterns mostly first, so that names are there to use.
      const patterns = this.empties.filter(e => e.sort === "pattern")
      const at = this.dice.pick(patterns.length > 0 && !this.dice.once(5) ? patterns : this.empties)
      this.empties = this.empties.filter(e => e !== at)
      if (at.sort === "pattern") this.fillPattern(at)
      else if (!this.fill(at)) this.takeBack(at)
    }
  }

  private place(at: Empty): Place {
    return {block: at.block, input: at.input}
  }

  private put(at: Empty, block: SavedBlock, tries = 0): void {
    this.workspace = plug(this.workspace, this.place(at), block)
    this.grew(block, tries)
  }

  private look(at: Empty) {
    const {inference} = this.session.inferWorkspace(this.workspace, {
      watch: {block: at.block, input: at.input},
    })
    const known = (inference.watched?.all() ?? []).flatMap(([name, scheme]): Known[] =>
      name === "main" ? [] : [{name, type: scheme.type}],
    )
    return {wanted: inference.watchedType, known}
  }

  private fillPattern(at: Empty): void {
    const small = this.count > this.size
    if (small && this.dice.once(2)) return
    const {wanted} = this.look(at)
    const check = checker(this.workspace, this.session)
    for (let i = 0; i < 3; i++) {
      const block =
        small || i === 2 || wanted === undefined ? this.make.named() : proposePattern(this.make, wanted)
      if (check.fits(this.place(at), block).fits) {
        this.put(at, block)
        return
      }
    }
  }

  private fill(at: Empty): boolean {
    const {wanted, known} = this.look(at)
    if (wanted === undefined) return false
    const check = checker(this.workspace, this.session)
    const open = this.empties.filter(e => e.sort !== "pattern").length
    const small = at.tries > 0 || this.count + open * (open > 4 ? 1 : 0.5) >= this.size
    const controllers = at.input.startsWith("R") && this.workspace.blocks.blocks.some(b => b.id === at.block)
    const go = (block: SavedBlock | undefined) => {
      if (block === undefined || !check.fits(this.place(at), block).fits) return false
      this.put(at, block, at.tries)
      return true
    }
    // What runs is mostly what was defined.
    const definite = known.filter(k => variablesIn(k.type).size === 0 && metasIn(k.type).size === 0)
    if (controllers) {
      for (let i = 0; i < 4; i++) {
        const from = at.tries > 0 || !this.dice.once(8) ? definite : known
        if (from.length > 0 && go(this.make.call(this.dice.pick(from).name, 0))) return true
      }
      if (at.tries > 0 && go(this.values.least(parseType("Velocity") ?? wanted, []))) return true
    }
    for (let i = 0; i < (small ? 4 : 6); i++)
      if (at.tries < 2 && go(this.values.propose(wanted, known, small || i > 3))) return true
    if (go(this.values.least(wanted, known))) return true
    for (const value of ["1", "0.5"]) if (go(this.make.block("number", {value}))) return true
    if (go(this.make.block("text", {value: "hi"}))) return true
    for (const k of known) if (go(this.make.call(k.name, 0))) return true
    return false
  }

  /// Takes away the block whose socket cannot be filled; something smaller is tried in its place.
  private takeBack(at: Empty): void {
    const parent = this.parentOf(at.block)
    if (parent === undefined) return
    this.workspace = without(this.workspace, at.block)
    const here = new Set([...everyBlock(this.workspace)].map(b => b.id))
    this.empties = this.empties.filter(e => here.has(e.block))
    this.count = here.size
    // A socket that was tried often is left empty: the program stays unfinished.
    if (parent.tries < 4) this.empties.push(parent)
  }

  private readonly retries = new Map<string, number>()

  /// The socket that a block is in. What stands in a stack is not taken out by itself but with the block around it.
  private parentOf(id: BlockId): Empty | undefined {
    for (const b of everyBlock(this.workspace))
      for (const [input, child] of Object.entries(b.inputs ?? {})) {
        if (child.block?.id !== id || b.id === undefined) continue
        if (blockView(child.block.type)?.meaning.as !== "expression") return undefined
        const key = `${b.id}/${input}`
        const tries = (this.retries.get(key) ?? 0) + 1
        this.retries.set(key, tries)
        return {block: b.id, input, sort: "expression", tries}
      }
    return undefined
  }

  // --- Finishing --------------------------------------------------------------------------------------------------

  /// Replaces what is still ambiguous by something definite; says whether all is well in the end.
  private settle(): boolean {
    for (let round = 0; round < 12; round++) {
      const problems = problemsOf(this.session.inferWorkspace(this.workspace)).filter(
        p => p.severity === "error",
      )
      if (problems.length === 0) return true
      const [first] = problems
      if (first?.block === undefined) return false
      const block = find(this.workspace, first.block)
      // A definition is at fault where one of its answers is open, a program where it runs something open.
      const answers = Object.entries(block?.inputs ?? {}).filter(([k]) => /^(?:[EO]\d|R\d)/.test(k))
      const answer = answers[round % Math.max(1, answers.length)]?.[1].block
      const at =
        this.parentOf(first.block) ?? (answer?.id === undefined ? undefined : this.parentOf(answer.id))
      if (at === undefined) return false
      const inside = find(this.workspace, at.block)?.inputs?.[at.input]?.block?.id
      if (inside === undefined) return false
      this.workspace = without(this.workspace, inside)
      this.empties = [{...at, tries: 2 + round}]
      this.fillAll()
    }
    return false
  }
}
