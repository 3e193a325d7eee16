/// Tries random moves into finished programs, and asks GHC about those that are refused: what it takes should have been allowed.
///
/// Values, patterns, steps and local definitions are tried, each where such a thing can go, well or badly.

import {blockView} from "../src/blocks/block_registry.ts"
import {printProgram} from "../src/haskell/printer.ts"
import type {SavedBlock, SavedWorkspace} from "../src/index.ts"
import {checker, plug} from "../src/index.ts"
import type {Program} from "../src/model/syntax_tree.ts"
import type {Place} from "../src/serialized_blocks.ts"
import {
  everyBlock,
  everyBlockIn,
  inferWorkspace,
  problemsOf,
} from "../src/workspace/inference/workspace_inference.ts"
import {Maker} from "./generate/blocks.ts"
import {proposePattern} from "./generate/patterns.ts"
import {generateProgram, sizeOf} from "./generate/program.ts"
import {Dice} from "./generate/random.ts"
import {Values} from "./generate/values.ts"
import type {Candidate} from "./ghc.ts"
import {compileAll} from "./ghc.ts"
import {breathe} from "./process.ts"
import {batch, candidate} from "./soundness.ts"

export const sorts = ["expression", "pattern", "step", "definition"] as const
export type Sort = (typeof sorts)[number]

export interface Completeness {
  /// Random moves into finished programs, by what was moved.
  readonly moves: {readonly [sort in Sort]: number}
  /// Those that the checker allows.
  readonly allowed: {readonly [sort in Sort]: number}
  /// Kinds of block that were moved, and kinds whose sockets were tried.
  readonly moved: ReadonlySet<string>
  readonly tried: ReadonlySet<string>
  /// Allowed ones whose program is finished, and GHC refuses it.
  readonly refused: readonly string[]
  /// Those that would make a function that nothing can ever call: GHC minds only once something does.
  readonly unusable: number
  /// Those that it refuses and GHC would have taken: the checker was stricter than it had to be.
  readonly needless: readonly string[]
}

export async function completeness(database: string, from: number, count: number): Promise<Completeness> {
  const none = () => ({expression: 0, pattern: 0, step: 0, definition: 0})
  const [moves, allowed] = [none(), none()]
  const [moved, tried] = [new Set<string>(), new Set<string>()]
  const [needless, refused]: [string[], string[]] = [[], []]
  let unusable = 0
  for (let start = from; start < from + count; start += batch) {
    const candidates: Candidate[] = []
    const whys = new Map<string, string>()
    for (let seed = start; seed < Math.min(start + batch, from + count); seed++) {
      if (seed % 20 === 0) await breathe()
      const {workspace, whole} = generateProgram(seed, sizeOf(seed))
      if (!whole) continue
      for (const [i, move] of randomMoves(seed, workspace).entries()) {
        moves[move.sort]++
        moved.add(move.block.type)
        tried.add(move.into)
        if (move.fits) {
          allowed[move.sort]++
          if (problemsOf(inferWorkspace(move.workspace)).every(p => p.severity !== "error"))
            candidates.push(candidate(`A${seed}x${i}`, move.workspace))
          continue
        }
        whys.set(`R${seed}x${i}`, move.why)
        // What the program's author wrote, without the types that inference would add to it.
        const program = derivingAll(move.workspace)
        candidates.push({name: `R${seed}x${i}`, text: printProgram(program).text, program})
      }
    }
    const complaints = await compileAll(database, candidates)
    for (const c of candidates)
      if (!whys.has(c.name) && complaints.has(c.name)) refused.push(`${c.text}\n${complaints.get(c.name)}`)
    const taken = candidates.filter(c => whys.has(c.name) && !complaints.has(c.name))
    // Haskell 2010 has no constraint like `Num (Maybe a)`; GHC takes it, until the function that has it is used.
    const plain =
      taken.length === 0
        ? new Map<string, string>()
        : await compileAll(database, taken, ["-XNoFlexibleContexts"])
    for (const c of taken)
      if (/Non type-variable argument/.test(plain.get(c.name) ?? "")) unusable++
      else needless.push(`${c.name}: ${whys.get(c.name)}\n${c.text}`)
  }
  return {moves, allowed, moved, tried, refused, unusable, needless}
}

/// How often each sort is moved where a program has a place for it.
const shares: readonly (readonly [number, Sort])[] = [
  [4, "expression"],
  [2, "pattern"],
  [4, "step"],
  [1, "definition"],
]

/// Moves that are tried with one program.
const movesEach = 16

interface Move {
  readonly sort: Sort
  readonly block: SavedBlock
  /// The kind of block that it goes into or below.
  readonly into: string
  readonly workspace: SavedWorkspace
  readonly fits: boolean
  readonly why: string
}

interface Spot {
  readonly place: Place
  readonly into: SavedBlock
  readonly sort: Sort
  readonly old: SavedBlock | undefined
}

function randomMoves(seed: number, workspace: SavedWorkspace): Move[] {
  const dice = new Dice(seed)
  const maker = new Maker(dice)
  const check = checker(workspace)
  const spots = [...everyBlock(workspace)].flatMap(spotsOf)
  const moves: Move[] = []
  for (let i = 0; i < movesEach; i++) {
    // Values are most of a program, so the others get their share.
    const sort = dice.weighed(shares.filter(([, of]) => spots.some(s => s.sort === of)))
    const fitting = spots.filter(s => s.sort === sort)
    // Each kind of place gets its share, too.
    const into = dice.pick([...new Set(fitting.map(s => s.into.type))])
    const {place, old} = dice.pick(fitting.filter(s => s.into.type === into))
    const block = numbered(proposal(sort, maker, workspace), `m${i}_`)
    if (old !== undefined && JSON.stringify(numbered(old, `m${i}_`)) === JSON.stringify(block)) continue
    const verdict = check.fits(place, block)
    moves.push({
      sort,
      block,
      into,
      workspace: plug(workspace, place, block),
      fits: verdict.fits,
      why: verdict.fits ? "" : `${JSON.stringify(place)} ${JSON.stringify(block)}: ${verdict.why}`,
    })
  }
  return moves
}

/// The places in and below a block. A value where a pattern goes is not Haskell at all, so there is nothing to ask.
function spotsOf(into: SavedBlock): Spot[] {
  const id = into.id
  if (id === undefined) return []
  const spots: Spot[] = []
  for (const row of blockView(into.type)?.shape(into.extraState ?? {}).rows ?? [])
    for (const item of row)
      if (item.kind === "socket" || item.kind === "stack")
        spots.push({
          place: {block: id, input: item.name},
          into,
          sort: item.sort,
          old: item.kind === "socket" ? into.inputs?.[item.name]?.block : undefined,
        })
  if (into.type.startsWith("step_")) spots.push({place: {below: id}, into, sort: "step", old: undefined})
  return spots
}

/// A block of the program itself, or a fresh one; without an empty socket.
function proposal(sort: Sort, maker: Maker, workspace: SavedWorkspace): SavedBlock {
  const {dice} = maker
  const values = new Values(maker)
  const own = [...everyBlock(workspace)].filter(b => blockView(b.type)?.meaning.as === sort)
  const usable = own.filter(b => sort !== "definition" || b.type === "define")
  const fresh = (): SavedBlock => {
    switch (sort) {
      case "expression":
        return dice.once(2) ? values.leaf() : values.node()
      case "pattern":
        return proposePattern(maker, {kind: "con", name: dice.pick(["Double", "Maybe", "Bool", "[]"])})
      case "step":
        return maker.steps(1)
      case "definition":
        return maker.definition(maker.name(), dice.below(2), 1, {}, 2)
    }
  }
  const kind = dice.once(2) ? dice.pick([...new Set(usable.map(b => b.type))]) : undefined
  const ofKind = usable.filter(b => kind === undefined || b.type === kind)
  const taken = ofKind.length > 0 && dice.once(2) ? structuredClone(dice.pick(ofKind)) : fresh()
  if (sort === "step") delete taken.next
  // Two definitions of one name below each other would read as two equations.
  if (sort === "definition") taken.extraState = {...taken.extraState, name: "moved"}
  return filled(taken, maker, values)
}

/// Small things go into all empty sockets.
function filled(block: SavedBlock, maker: Maker, values: Values): SavedBlock {
  for (const b of [...everyBlockIn(block)])
    for (const row of blockView(b.type)?.shape(b.extraState ?? {}).rows ?? [])
      for (const item of row) {
        if ((item.kind !== "socket" && item.kind !== "stack") || b.inputs?.[item.name]?.block !== undefined)
          continue
        const inner =
          item.sort === "pattern"
            ? maker.named()
            : item.sort === "expression"
              ? values.leaf()
              : item.sort === "step"
                ? filled(maker.block("step_wait"), maker, values)
                : filled(maker.definition(maker.name(), 0, 1, {}, 2), maker, values)
        b.inputs = {...b.inputs, [item.name]: {block: inner}}
      }
  return block
}

/// With ids of its own.
function numbered(block: SavedBlock, prefix: string): SavedBlock {
  const copy = structuredClone(block)
  let n = 0
  for (const b of everyBlockIn(copy)) b.id = `${prefix}${n++}`
  return copy
}

/// Its own types with all they can derive, so that a refused program is not GHC's to refuse for that alone.
function derivingAll(workspace: SavedWorkspace): Program {
  const {read, inference} = inferWorkspace(workspace)
  const able = (name: string, of: string) => inference.env.instances.get(of)?.get(name) !== "none"
  return {
    ...read.program,
    declarations: read.program.declarations.map(d =>
      d.kind === "data" ? {...d, deriving: ["Eq", "Ord", "Show"].filter(c => able(d.name, c))} : d,
    ),
  }
}
