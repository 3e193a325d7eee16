/// Generates programs and asks GHC about those that are finished.

import type {SavedWorkspace} from "../src/index.ts"
import {toHaskell} from "../src/index.ts"
import {everyBlock, inferWorkspace} from "../src/workspace/inference/workspace_inference.ts"
import {generateProgram, sizeOf} from "./generate/program.ts"
import type {Candidate} from "./ghc.ts"
import {compileAll} from "./ghc.ts"
import {breathe} from "./process.ts"

export interface Soundness {
  /// Generated.
  readonly programs: number
  /// Of these, finished: without an empty socket or an open question.
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

/// Programs handed to GHC at once.
export const batch = 125

/// A workspace as GHC gets it.
export function candidate(name: string, workspace: SavedWorkspace): Candidate {
  return {name, text: toHaskell(workspace).text, program: inferWorkspace(workspace).read.program}
}

/// Generates from a first seed on until there are `count` finished programs, and asks GHC about each.
export async function soundness(database: string, from: number, count: number): Promise<Soundness> {
  let whole = 0
  let blocks = 0
  const sizes: number[] = Array.from({length: 15}, () => 0)
  const kinds = new Map<string, number>()
  const refused: Refused[] = []
  let seed = from
  while (whole < count) {
    const made = new Map<string, {seed: number; workspace: SavedWorkspace}>()
    for (; made.size < Math.min(batch, count - whole); seed++) {
      if (seed % 20 === 0) await breathe()
      const generated = generateProgram(seed, sizeOf(seed))
      if (!generated.whole) continue
      blocks += generated.blocks
      const size = Math.ceil(generated.blocks / 10) - 1
      sizes[size] = (sizes[size] ?? 0) + 1
      for (const b of everyBlock(generated.workspace)) kinds.set(b.type, (kinds.get(b.type) ?? 0) + 1)
      made.set(`P${seed}`, {seed, workspace: generated.workspace})
    }
    whole += made.size
    const complaints = await compileAll(
      database,
      [...made].map(([name, {workspace}]) => candidate(name, workspace)),
    )
    for (const [name, complaint] of complaints) {
      const program = made.get(name)
      if (program !== undefined) refused.push({...program, complaint})
      else throw new Error(`expected a complaint about a program, found: ${complaint}`)
    }
  }
  return {programs: seed - from, whole, blocks, sizes, kinds, refused}
}

/// "5-10: 212, 11-20: 573": how many programs have how many blocks.
export function sizesOf({sizes}: Soundness): string {
  return sizes.map((n, i) => `${i === 0 ? 5 : i * 10 + 1}-${i * 10 + 10}: ${n}`).join(", ")
}
