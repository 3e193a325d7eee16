/// Makes a counterexample small: as long as GHC still refuses what inference accepts, definitions and blocks are taken away. And keeps it.

import {writeFileSync} from "node:fs"
import {blockView} from "../src/blocks/block_registry.ts"
import {printProgram} from "../src/haskell/printer.ts"
import type {SavedBlock, SavedWorkspace} from "../src/index.ts"
import {plug} from "../src/index.ts"
import {everyBlock, inferWorkspace, problemsOf} from "../src/workspace/inference/workspace_inference.ts"
import {without} from "../src/workspace/moves/block_moves.ts"
import {compileAll} from "./ghc.ts"
import type {Refused} from "./soundness.ts"
import {candidate} from "./soundness.ts"

export const cases = new URL("cases/", import.meta.url)

/// Writes a counterexample, shrunk, to the cases that every later test run tries. It can get a name of its own once it is mended.
export async function keep(database: string, {seed, workspace, complaint}: Refused): Promise<string> {
  const said = complaint
    .split("\n")
    .slice(0, 3)
    .map(l => `-- ${l.replace(/^\w+\.hs:\d+:\d+: /, "").trim()}\n`)
  const text = `${said.join("")}${await shrink(database, workspace)}`
  writeFileSync(new URL(`found-${seed}.hs.txt`, cases), text)
  return `seed ${seed}, kept in test/cases/found-${seed}.hs.txt\n${text}\n${complaint}`
}

/// The Haskell of the smallest program found that is still refused, without inferred signatures.
export async function shrink(database: string, workspace: SavedWorkspace): Promise<string> {
  let smallest = workspace
  for (let round = 0; round < 40; round++) {
    const smaller = steps(smallest).filter(isWhole).slice(0, 120)
    const complaints = await compileAll(
      database,
      smaller.map((w, i) => candidate(`S${i}`, w)),
    )
    const still = smaller.filter((_, i) => complaints.has(`S${i}`))
    const [best] = still.sort((a, b) => sizeOf(a) - sizeOf(b))
    if (best === undefined) break
    smallest = best
  }
  return printProgram(inferWorkspace(smallest).read.program).text
}

function sizeOf(workspace: SavedWorkspace): number {
  return [...everyBlock(workspace)].length
}

function isWhole(workspace: SavedWorkspace): boolean {
  return problemsOf(inferWorkspace(workspace)).every(p => p.severity !== "error")
}

const unit: SavedBlock = {type: "tuple", id: "unit", extraState: {items: 0}}

/// Every workspace with one thing less.
function steps(workspace: SavedWorkspace): SavedWorkspace[] {
  const isValue = (b: SavedBlock | undefined) =>
    b !== undefined && blockView(b.type)?.meaning.as === "expression"
  const found: SavedWorkspace[] = []
  for (const b of everyBlock(workspace)) {
    if (b.id === undefined || b.type === "main") continue
    if (!isValue(b)) {
      found.push(without(workspace, b.id))
      if (b.type === "define" && Array.isArray(b.extraState?.equations) && b.extraState.equations.length > 1)
        found.push(
          changed(workspace, b, {
            ...b,
            extraState: {...b.extraState, equations: b.extraState.equations.slice(0, -1)},
          }),
        )
      continue
    }
    for (const other of [
      unit,
      ...Object.values(b.inputs ?? {}).flatMap(i =>
        isValue(i.block) && i.block !== undefined ? [i.block] : [],
      ),
    ])
      if (b.type !== "tuple" || b.extraState?.items !== 0) found.push(changed(workspace, b, other))
  }
  return found
}

/// The workspace with one block in place of another.
function changed(workspace: SavedWorkspace, old: SavedBlock, next: SavedBlock): SavedWorkspace {
  for (const parent of everyBlock(workspace))
    for (const [input, child] of Object.entries(parent.inputs ?? {}))
      if (child.block === old && parent.id !== undefined)
        return plug(without(workspace, old.id ?? ""), {block: parent.id, input}, next)
  return {
    ...workspace,
    blocks: {...workspace.blocks, blocks: workspace.blocks.blocks.map(b => (b === old ? next : b))},
  }
}
