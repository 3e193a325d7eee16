/// Blocks that are moved or copied to another place of a program, also out of the function whose names they use: what is allowed compiles, what is refused says
/// why, and nothing is lost.

import {beforeAll, expect, test} from "vitest"
import {packageDatabase} from "../scripts/ghc.ts"
import {blockView} from "../src/blocks/block_registry.ts"
import type {Place, SavedBlock, SavedWorkspace} from "../src/index.ts"
import {checker, plug, toHaskell} from "../src/index.ts"
import {everyNode} from "../src/model/child_nodes.ts"
import type {Reader} from "../src/reader/index.ts"
import {
  everyBlock,
  everyBlockIn,
  inferWorkspace,
  problemsOf,
} from "../src/workspace/inference/workspace_inference.ts"
import {without} from "../src/workspace/moves/block_moves.ts"
import {cases, isNightly, seed} from "./extent.ts"
import {generateProgram, sizeOf} from "./generate/program.ts"
import {Dice} from "./generate/random.ts"
import type {Candidate} from "./ghc.ts"
import {compileAll} from "./ghc.ts"
import {breathe} from "./process.ts"
import {testReader} from "./reader/open.ts"
import {candidate} from "./soundness.ts"

// More programs, each other ones: `PROGRAMS=2000 SEED=5 npx vitest run test/moves.test.ts`.
const programs = cases(4)
const first = seed
const movesEach = 10

const database = packageDatabase()
let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

interface Spot {
  readonly place: Place
  readonly sort: string
  readonly inside: SavedBlock | undefined
}

/// The places in and below a block.
function spotsOf(block: SavedBlock): Spot[] {
  const id = block.id ?? ""
  const spots = (blockView(block.type)?.shape(block.extraState ?? {}).rows ?? []).flat().flatMap(item =>
    item.kind === "socket" || item.kind === "stack"
      ? [
          {
            place: {block: id, input: item.name},
            sort: item.sort,
            inside: item.kind === "socket" ? block.inputs?.[item.name]?.block : undefined,
          },
        ]
      : [],
  )
  return block.type.startsWith("step_")
    ? [...spots, {place: {below: id}, sort: "step", inside: undefined}]
    : spots
}

/// A block by itself, without what stands below it; a copy has ids of its own.
function lone(block: SavedBlock, copy: boolean): SavedBlock {
  const {next: _, ...taken} = structuredClone(block)
  if (copy) for (const b of everyBlockIn(taken)) b.id = `copy-${b.id}`
  return taken
}

const idsOf = (blocks: Iterable<SavedBlock>) => new Set([...blocks].map(b => b.id))

test("a moved or copied block fits and compiles, or it is said why not; nothing else changes", async () => {
  const candidates: Candidate[] = []
  const counts = {moved: 0, copied: 0, refused: 0, open: 0}
  for (let seed = first; seed < first + programs; seed++) {
    await breathe()
    const {workspace, whole} = generateProgram(seed, sizeOf(seed))
    if (!whole) continue
    const dice = new Dice(seed)
    const all = [...everyBlock(workspace)].filter(b => b.type !== "main")
    for (let i = 0; i < movesEach; i++) {
      const block = dice.pick(all)
      const copy = dice.once(2)
      const taken = lone(block, copy)
      // What stood below it goes up to where it was.
      const rest = copy ? workspace : withoutOne(workspace, block)
      const within = idsOf(everyBlockIn(taken))
      const sort = blockView(block.type)?.meaning.as
      const spots = [...everyBlock(rest)]
        .flatMap(spotsOf)
        .filter(s => s.sort === sort && !within.has(idOf(s.place)))
      if (spots.length === 0) continue
      const {place, inside} = dice.pick(spots)
      const verdict = checker(rest).fits(place, taken)
      const what = `seed ${seed}, ${copy ? "a copy of " : ""}${block.id} to ${JSON.stringify(place)}`
      if (!verdict.fits) {
        counts.refused++
        expect(verdict.why, what).toMatch(/^\p{Lu}|^`/u)
        expect(verdict.why, what).toMatch(/[.!]$/)
        continue
      }
      counts[copy ? "copied" : "moved"]++
      const after = plug(rest, place, taken)
      // All that was there is there, but for what the page lets fall out of the socket.
      const fallen = inside === undefined ? new Set() : idsOf(everyBlockIn(inside))
      const before = [...idsOf(everyBlock(workspace))].filter(id => !fallen.has(id))
      const now = idsOf(everyBlock(after))
      expect(
        before.filter(id => !now.has(id)),
        what,
      ).toEqual([])
      const {text} = toHaskell(after)
      const pieces = reader.read(text).pieces
      expect(
        pieces.filter(p => p.broken).map(p => p.slice),
        what,
      ).toEqual([])
      const solved = inferWorkspace(after)
      const problems = problemsOf(solved).filter(p => p.severity === "error")
      for (const p of problems) expect(p.message, what).toMatch(/[.!]$/)
      // What the emptied socket would decide is unknown.
      const open = [...everyNode(solved.read.program)].some(node => node.kind === "hole")
      if (problems.length > 0 || open) counts.open++
      else candidates.push(candidate(`M${seed}x${i}`, after))
    }
  }
  console.log(
    `${counts.moved} blocks moved, ${counts.copied} copied, ${counts.refused} refused; ${candidates.length} programs for GHC, ${counts.open} with something open`,
  )
  if (database === undefined) return
  const complaints = [...(await compileAll(database, candidates))]
  expect(complaints.map(([name, said]) => `${candidates.find(c => c.name === name)?.text}\n${said}`)).toEqual(
    [],
  )
  if (!isNightly) return
  expect(candidates.length).toBeGreaterThan(programs)
  expect(counts.refused).toBeGreaterThan(programs)
})

function idOf(place: Place): string {
  return "below" in place ? place.below : place.block
}

function withoutOne(workspace: SavedWorkspace, block: SavedBlock): SavedWorkspace {
  const below = block.next?.block
  const id = block.id ?? ""
  if (below === undefined) return without(workspace, id)
  const change = (b: SavedBlock): SavedBlock => {
    if (b.id === id) return below
    const inputs = Object.fromEntries(
      Object.entries(b.inputs ?? {}).map(([name, input]) => [
        name,
        input.block === undefined ? input : {...input, block: change(input.block)},
      ]),
    )
    const {next, ...own} = b
    const after = next?.block === undefined ? undefined : change(next.block)
    return {...own, inputs, ...(after === undefined ? {} : {next: {block: after}})}
  }
  return {...workspace, blocks: {...workspace.blocks, blocks: workspace.blocks.blocks.map(change)}}
}
