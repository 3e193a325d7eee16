/// Generates programs and asks GHC about those that are finished.

import {setImmediate} from "node:timers/promises"
import {blockView} from "../src/blocks/language.ts"
import {printProgram} from "../src/haskell/print.ts"
import type {SavedWorkspace} from "../src/index.ts"
import {checker, plug, toHaskell} from "../src/index.ts"
import type {Program} from "../src/model/tree.ts"
import {everyBlock, solve} from "../src/workspace/infer.ts"
import {find} from "../src/workspace/plug.ts"
import {Maker} from "./generate/blocks.ts"
import {generateProgram, sizeOf} from "./generate/program.ts"
import {Dice} from "./generate/random.ts"
import {Values} from "./generate/values.ts"
import type {Candidate} from "./ghc.ts"
import {compileAll} from "./ghc.ts"

export interface Soundness {
  readonly programs: number
  /// Without an empty socket or an open question.
  readonly whole: number
  readonly blocks: number
  /// How many finished programs have up to 10, 20, … blocks.
  readonly sizes: readonly number[]
  /// How often each kind of block stands in finished programs.
  readonly kinds: ReadonlyMap<string, number>
  readonly refused: readonly Refused[]
}

/// A finished program that GHC does not take.
export interface Refused {
  readonly seed: number
  readonly workspace: SavedWorkspace
  readonly complaint: string
}

/// Programs handed to GHC at once. Between them the test runner hears that the test is alive.
export const batch = 125

/// A workspace as GHC gets it.
export function candidate(name: string, workspace: SavedWorkspace): Candidate {
  return {name, text: toHaskell(workspace).text, program: solve(workspace).read.program}
}

export async function soundness(database: string, from: number, count: number): Promise<Soundness> {
  let whole = 0
  let blocks = 0
  const sizes: number[] = Array.from({length: 15}, () => 0)
  const kinds = new Map<string, number>()
  const refused: Refused[] = []
  for (let start = from; start < from + count; start += batch) {
    const made = new Map<string, {seed: number; workspace: SavedWorkspace}>()
    for (let seed = start; seed < Math.min(start + batch, from + count); seed++) {
      if (seed % 20 === 0) await setImmediate()
      const generated = generateProgram(seed, sizeOf(seed))
      if (!generated.whole) continue
      blocks += generated.blocks
      const size = Math.ceil(generated.blocks / 10) - 1
      sizes[size] = (sizes[size] ?? 0) + 1
      for (const b of everyBlock(generated.workspace)) kinds.set(b.type, (kinds.get(b.type) ?? 0) + 1)
      made.set(`P${seed}`, {seed, workspace: generated.workspace})
    }
    whole += made.size
    const complaints = compileAll(
      database,
      [...made].map(([name, {workspace}]) => candidate(name, workspace)),
    )
    for (const [name, complaint] of complaints) {
      const program = made.get(name)
      if (program !== undefined) refused.push({...program, complaint})
      else throw new Error(`expected a complaint about a program, found: ${complaint}`)
    }
  }
  return {programs: count, whole, blocks, sizes, kinds, refused}
}

export interface Completeness {
  /// Random moves into finished programs, sorts apart.
  readonly moves: number
  /// Those that the checker allows.
  readonly allowed: number
  /// Those that would make a function that nothing can ever call: GHC minds only once something does.
  readonly unusable: number
  /// Those that it refuses and GHC would have taken: the checker was stricter than it had to be.
  readonly needless: readonly string[]
}

/// Tries random blocks in random sockets of finished programs, also blocks of the program itself, and asks GHC about the refused ones.
export async function completeness(database: string, from: number, count: number): Promise<Completeness> {
  const needless: string[] = []
  let moves = 0
  let allowed = 0
  let unusable = 0
  for (let start = from; start < from + count; start += batch) {
    const candidates: Candidate[] = []
    const whys = new Map<string, string>()
    for (let seed = start; seed < Math.min(start + batch, from + count); seed++) {
      if (seed % 20 === 0) await setImmediate()
      const {workspace, whole} = generateProgram(seed, sizeOf(seed))
      if (!whole) continue
      for (const [i, {move, fits, why}] of randomMoves(seed, workspace).entries()) {
        moves++
        if (fits) allowed++
        else {
          whys.set(`R${seed}x${i}`, why)
          // What the program's author wrote, without the types that inference would add to it.
          const program = derivingAll(move)
          candidates.push({name: `R${seed}x${i}`, text: printProgram(program).text, program})
        }
      }
    }
    const complaints = compileAll(database, candidates)
    const taken = candidates.filter(c => !complaints.has(c.name))
    // Haskell 2010 has no constraint like `Num (Maybe a)`; GHC takes it, until the function that has it is used.
    const plain =
      taken.length === 0 ? new Map<string, string>() : compileAll(database, taken, ["-XNoFlexibleContexts"])
    for (const c of taken)
      if (/Non type-variable argument/.test(plain.get(c.name) ?? "")) unusable++
      else needless.push(`${c.name}: ${whys.get(c.name)}\n${c.text}`)
  }
  return {moves, allowed, unusable, needless}
}

/// Sockets of one program that are tried.
const movesEach = 8

interface Move {
  readonly move: SavedWorkspace
  readonly fits: boolean
  readonly why: string
}

function randomMoves(seed: number, workspace: SavedWorkspace): Move[] {
  const dice = new Dice(seed)
  const maker = new Maker(dice)
  const values = new Values(maker)
  const check = checker(workspace)
  const all = [...everyBlock(workspace)]
  const isValue = (type: string) => blockView(type)?.meaning.as === "expression"
  const parents = all.filter(b =>
    Object.values(b.inputs ?? {}).some(i => i.block !== undefined && isValue(i.block.type)),
  )
  const complete = all.filter(b => isValue(b.type))
  const moves: Move[] = []
  for (let i = 0; i < movesEach; i++) {
    const parent = dice.pick(parents)
    const [input] = dice.pick(
      Object.entries(parent.inputs ?? {}).filter(([, c]) => c.block !== undefined && isValue(c.block.type)),
    )
    // A value where a pattern goes is not Haskell at all, so there is nothing to ask.
    if (parent.id === undefined) continue
    const place = {block: parent.id, input}
    const old = find(workspace, parent.id)?.inputs?.[input]?.block
    const other = dice.once(2) ? dice.pick(complete) : values.leaf()
    const block = {...structuredClone(other), id: "moved"}
    if (old === undefined || JSON.stringify(old.inputs) === JSON.stringify(block.inputs)) continue
    const verdict = check.fits(place, block)
    const why = verdict.fits
      ? ""
      : `${JSON.stringify(place)} ${block.type} ${JSON.stringify(block.extraState)}: ${verdict.why}`
    moves.push({move: plug(workspace, place, block), fits: verdict.fits, why})
  }
  return moves
}

/// Its own types with all they can derive, so that a refused program is not GHC's to refuse for that alone.
function derivingAll(workspace: SavedWorkspace): Program {
  const {read, inferrer} = solve(workspace)
  const able = (name: string, of: string) => inferrer.env.instances.get(of)?.get(name) !== "none"
  return {
    ...read.program,
    declarations: read.program.declarations.map(d =>
      d.kind === "data" ? {...d, deriving: ["Eq", "Ord", "Show"].filter(c => able(d.name, c))} : d,
    ),
  }
}
