/// Generates programs and asks GHC about those that are finished.

import {toHaskell} from "../src/index.ts"
import {solve} from "../src/workspace/infer.ts"
import {generateProgram} from "./generate.ts"
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

/// 5 to 40 blocks, and one in fifty up to 150.
function sizeOf(seed: number): number {
  return seed % 50 === 49 ? 100 + (seed % 51) : 5 + ((seed * 7) % 36)
}
