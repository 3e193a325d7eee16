/// Random edits as a hand makes them on the page: small buttons, blocks out of the toolbox, blocks that are pulled out and put elsewhere.

import type {Item} from "../../src/block_shape.ts"
import {blockView} from "../../src/blocks/block_registry.ts"
import {plug, toolbox} from "../../src/index.ts"
import type {Place, SavedBlock, SavedWorkspace} from "../../src/serialized_blocks.ts"
import {without} from "../../src/workspace/moves/block_moves.ts"
import type {Dice} from "../generate/random.ts"
import {everyBlock} from "./agreement.ts"

export const pageEdits = ["press", "put", "pull", "move", "empty", "number", "copy"] as const
export type PageEdit = (typeof pageEdits)[number]

/// The workspace after an edit, and what was done; undefined when there is no place for it.
export interface EditedPage {
  readonly step: string
  readonly workspace: SavedWorkspace
}

interface Spot {
  readonly place: Place
  readonly sort: string
  readonly inside: SavedBlock | undefined
}

const itemsOf = (block: SavedBlock): readonly Item[] =>
  (blockView(block.type)?.shape(block.extraState ?? {}).rows ?? []).flat()

function spotsOf(block: SavedBlock): Spot[] {
  const id = block.id ?? ""
  const spots = itemsOf(block).flatMap((item): Spot[] =>
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

function renamed(block: SavedBlock, dice: Dice): SavedBlock {
  const copy = structuredClone(block)
  for (const b of everyBlock(copy)) b.id = `p${dice.below(1e12)}`
  return copy
}

const blocksOf = (workspace: SavedWorkspace) => workspace.blocks.blocks.flatMap(everyBlock)

function withTop(workspace: SavedWorkspace, ...tops: readonly SavedBlock[]): SavedWorkspace {
  const placed = tops.map((block, i) => ({...block, x: 700, y: 40 * (workspace.blocks.blocks.length + i)}))
  return {...workspace, blocks: {...workspace.blocks, blocks: [...workspace.blocks.blocks, ...placed]}}
}

/// A block at a place; what was in the socket falls out.
function put(workspace: SavedWorkspace, {place, inside}: Spot, block: SavedBlock): SavedWorkspace {
  const after = plug(workspace, place, block)
  return inside === undefined ? after : withTop(after, inside)
}

export function editPage(workspace: SavedWorkspace, dice: Dice, edit: PageEdit): EditedPage | undefined {
  const all = blocksOf(workspace)
  if (all.length === 0) return undefined
  const block = dice.pick(all)
  const spotFor = (taken: SavedBlock, among: SavedWorkspace): Spot | undefined => {
    const sort = blockView(taken.type)?.meaning.as
    const within = new Set(everyBlock(taken).map(b => b.id))
    const spots = blocksOf(among)
      .flatMap(spotsOf)
      .filter(s => s.sort === sort && !within.has("below" in s.place ? s.place.below : s.place.block))
    return spots.length === 0 ? undefined : dice.pick(spots)
  }
  switch (edit) {
    case "press": {
      const buttons = all.flatMap(b =>
        itemsOf(b).flatMap(item => (item.kind === "button" ? [{block: b, action: item.action}] : [])),
      )
      if (buttons.length === 0) return undefined
      const {block: on, action} = dice.pick(buttons)
      const copy = structuredClone(workspace)
      const own = blocksOf(copy).find(b => b.id === on.id)
      if (own === undefined) return undefined
      own.extraState = blockView(own.type)?.press(own.extraState ?? {}, action) ?? {}
      const names = new Set(itemsOf(own).flatMap(item => ("name" in item ? [item.name] : [])))
      const fallen = Object.entries(own.inputs ?? {}).filter(([name]) => !names.has(name))
      for (const [name] of fallen) delete own.inputs?.[name]
      return {
        step: `press ${action} on ${on.id}`,
        workspace: withTop(copy, ...fallen.flatMap(([, {block: b}]) => (b === undefined ? [] : [b]))),
      }
    }
    case "put": {
      const {block: offered} = dice.pick(dice.pick(toolbox("haskell").filter(c => c.items.length > 0)).items)
      const taken = renamed(offered, dice)
      const spot = dice.once(4) ? undefined : spotFor(taken, workspace)
      if (spot === undefined)
        return {step: `a new ${taken.type} ${taken.id} stands alone`, workspace: withTop(workspace, taken)}
      return {
        step: `a new ${taken.type} ${taken.id} to ${JSON.stringify(spot.place)}`,
        workspace: put(workspace, spot, taken),
      }
    }
    case "pull":
      return {
        step: `pull ${block.id} out`,
        workspace: withTop(without(workspace, block.id ?? ""), structuredClone(block)),
      }
    case "move": {
      const rest = without(workspace, block.id ?? "")
      const spot = spotFor(block, rest)
      if (spot === undefined) return undefined
      return {
        step: `move ${block.id} to ${JSON.stringify(spot.place)}`,
        workspace: put(rest, spot, structuredClone(block)),
      }
    }
    case "empty":
      return {step: `delete ${block.id}`, workspace: without(workspace, block.id ?? "")}
    case "number": {
      const numbers = all.filter(b => b.type === "number")
      if (numbers.length === 0) return undefined
      const {id} = dice.pick(numbers)
      const value = dice.pick(["7", "-3", "0.25", "1e3", "-0.5"])
      const copy = structuredClone(workspace)
      for (const b of blocksOf(copy)) if (b.id === id) b.extraState = {...b.extraState, value}
      return {step: `number ${id} becomes ${value}`, workspace: copy}
    }
    case "copy": {
      const {next: _, ...alone} = block
      const twin = renamed(alone, dice)
      return {step: `copy ${block.id}`, workspace: withTop(workspace, twin)}
    }
  }
}
