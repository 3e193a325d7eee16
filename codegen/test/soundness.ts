/// Generates programs and asks GHC about those that are finished.

import {blockView} from "../src/blocks/language.ts"
import type {SavedBlock} from "../src/index.ts"
import {checker, plug, toHaskell} from "../src/index.ts"
import {everyBlock, solve} from "../src/workspace/infer.ts"
import {generateProgram, randomFrom} from "./generate.ts"
import type {Candidate} from "./ghc.ts"
import {compileAll} from "./ghc.ts"

export interface Soundness {
  readonly programs: number
  /// Without an empty socket or an open question.
  readonly whole: number
  readonly blocks: number
  /// Seed, program and GHC's complaint.
  readonly refused: readonly string[]
}

/// Programs handed to GHC at once.
const batch = 250

export function soundness(database: string, from: number, count: number): Soundness {
  let whole = 0
  let blocks = 0
  const refused: string[] = []
  for (let start = from; start < from + count; start += batch) {
    const candidates: Candidate[] = []
    for (let seed = start; seed < Math.min(start + batch, from + count); seed++) {
      const generated = generateProgram(seed, sizeOf(seed))
      blocks += generated.blocks
      if (!generated.whole) continue
      candidates.push({
        name: `P${seed}`,
        text: toHaskell(generated.workspace).text,
        program: solve(generated.workspace).read.program,
      })
    }
    whole += candidates.length
    for (const [name, complaint] of compileAll(database, candidates))
      refused.push(`seed ${name}\n${candidates.find(c => c.name === name)?.text ?? ""}\n${complaint}`)
  }
  return {programs: count, whole, blocks, refused}
}

export interface Completeness {
  /// Moves in finished programs that the checker refused and that leave no socket empty.
  readonly refusals: number
  /// Those whose program GHC would have taken: the checker was stricter than it had to be.
  readonly needless: readonly string[]
}

/// Tries random leaves in random sockets of finished programs and asks GHC about the refused ones.
export function completeness(database: string, from: number, count: number): Completeness {
  const candidates: Candidate[] = []
  for (let seed = from; seed < from + count; seed++) {
    const {workspace, whole} = generateProgram(seed, sizeOf(seed))
    if (!whole) continue
    const check = checker(workspace)
    const random = randomFrom(seed)
    const pick = <T>(items: readonly T[]): T | undefined => items[Math.floor(random() * items.length)]
    const parents = [...everyBlock(workspace)].filter(b => Object.keys(b.inputs ?? {}).length > 0)
    for (let i = 0; i < 8; i++) {
      const parent = pick(parents)
      const input = pick(Object.keys(parent?.inputs ?? {}))
      const leaf = pick(leaves)
      if (parent?.id === undefined || input === undefined || leaf === undefined) continue
      const place = {block: parent.id, input}
      const block = {...leaf, id: "leaf"}
      // A value where a pattern goes is not Haskell at all, so there is nothing to ask.
      const old = parent.inputs?.[input]?.block
      if (old === undefined || blockView(old.type)?.meaning.as !== "expression") continue
      if (check.fits(place, block).fits) continue
      const changed = plug(workspace, place, block)
      candidates.push({
        name: `R${seed}x${i}`,
        text: toHaskell(changed).text,
        program: solve(changed).read.program,
      })
    }
  }
  const complaints = compileAll(database, candidates)
  return {
    refusals: candidates.length,
    needless: candidates.filter(c => !complaints.has(c.name)).map(c => `${c.name}\n${c.text}`),
  }
}

const leaves: readonly SavedBlock[] = [
  {type: "number", extraState: {value: "1"}},
  {type: "number", extraState: {value: "0.5"}},
  {type: "text", extraState: {value: "hi"}},
  {type: "choice", extraState: {of: "Bool", value: "True"}},
  {type: "choice", extraState: {of: "Sound", value: "ErrorSound"}},
  {type: "construct", extraState: {con: "Nothing", args: 0}},
  {type: "tuple", extraState: {items: 0}},
  {type: "list", extraState: {items: 0}},
  {type: "name", extraState: {name: "pi", args: 0}},
  {type: "name", extraState: {name: "say", args: 0}},
]

/// 5 to 40 blocks, and one in fifty up to 150.
function sizeOf(seed: number): number {
  return seed % 50 === 49 ? 100 + (seed % 51) : 5 + ((seed * 7) % 36)
}
