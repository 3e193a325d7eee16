/// Generated block programs, to Haskell and back: the blocks that come back print the same text, to the last character.

import {expect, test} from "vitest"
import type {SavedBlock, SavedWorkspace} from "../src/index.ts"
import {toHaskell} from "../src/index.ts"
import {openView, workspaceOf} from "../src/reader/index.ts"
import {everyBlock} from "../src/workspace/inference/workspace_inference.ts"
import {generateProgram} from "./generate/program.ts"
import {testReader} from "./reader/open.ts"

const reader = await testReader()

/// Blocks that say nothing of their own: the text has no trace of them. Inputs that are given one after the other are given together.
const silent = new Set(["pattern_any", "do", "step_do", "apply"])

function kinds(workspace: SavedWorkspace): {[type: string]: number} {
  const counted: {[type: string]: number} = {}
  for (const block of everyBlock(workspace)) {
    // `Red` chosen from a menu and `Red` as a constructor without parts are the same word.
    const type = block.type.replace("choice", "construct")
    // What is run together may be one tuple, or several sockets of `simulate`.
    if (block.type === "main") {
      const [only, ...more] = Object.values(block.inputs ?? {}).flatMap(i => i.block ?? [])
      if (only?.type === "tuple" && only.extraState?.items !== 0 && more.length === 0)
        counted.tuple = (counted.tuple ?? 0) - 1
    }
    // The negative of a number is written as a negative number.
    if (type === "negate" && block.inputs?.X?.block?.type === "number") continue
    // One step alone is written without its stack, as the call that it is: `unless hit $ do …`.
    if (type === "infix" && block.extraState?.op === "$" && block.inputs?.R?.block?.type === "do") continue
    if (!silent.has(type) && !type.startsWith("step_") && type !== "name")
      counted[type] = (counted[type] ?? 0) + 1
  }
  return Object.fromEntries(Object.entries(counted).filter(([, count]) => count !== 0))
}

test("blocks to text to blocks to text is the same text and as many blocks of each kind", () => {
  for (let seed = 0; seed < 30; seed++) {
    const {workspace, whole} = generateProgram(seed, 5 + ((seed * 7) % 36))
    if (!whole) continue
    const {text} = toHaskell(workspace)
    const again = workspaceOf(openView(reader, text))
    expect(toHaskell(again).text, `seed ${seed}`).toBe(text)
    expect(kinds(again), `seed ${seed}`).toEqual(kinds(workspace))
    const raw = [...everyBlock(again)].filter((b: SavedBlock) => b.type.startsWith("raw_"))
    expect(raw, `seed ${seed}`).toEqual([])
  }
})
