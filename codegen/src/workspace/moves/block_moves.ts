/// Moves of blocks in a serialized workspace, without changing the original.

import {declarationTextOf} from "../../blocks/families/text_declarations.ts"
import type {BlockId, Place, SavedBlock, SavedInput, SavedWorkspace} from "../../serialized_blocks.ts"
import {everyBlock} from "../inference/workspace_inference.ts"

export function find(workspace: SavedWorkspace, id: BlockId): SavedBlock | undefined {
  for (const block of everyBlock(workspace)) if (block.id === id) return block
  return undefined
}

function withBlocks(workspace: SavedWorkspace, blocks: SavedBlock[]): SavedWorkspace {
  return {...workspace, blocks: {...workspace.blocks, blocks}}
}

/// The workspace without a block and all that it carries, also what is stacked below it.
export function without(workspace: SavedWorkspace, id: BlockId): SavedWorkspace {
  return withBlocks(
    workspace,
    workspace.blocks.blocks.flatMap(b => cut(b, id) ?? []),
  )
}

function cut(block: SavedBlock, id: BlockId): SavedBlock | undefined {
  if (block.id === id) return undefined
  return mapChildren(block, child => cut(child, id))
}

function mapChildren(block: SavedBlock, change: (child: SavedBlock) => SavedBlock | undefined): SavedBlock {
  const below = block.next?.block === undefined ? undefined : change(block.next.block)
  let inputs = block.inputs
  for (const [name, input] of Object.entries(block.inputs ?? {})) {
    if (input.block === undefined) continue
    const next = change(input.block)
    if (next === input.block) continue
    if (inputs === block.inputs) inputs = {...block.inputs}
    if (inputs !== undefined) {
      if (next !== undefined) inputs[name] = {...input, block: next}
      else {
        const {block: _, ...rest} = input
        inputs[name] = rest
      }
    }
  }
  if (inputs === block.inputs && below === block.next?.block) return block
  const {next: _, inputs: __, ...rest} = block
  return {
    ...rest,
    ...(inputs === undefined ? {} : {inputs}),
    ...(below === undefined ? {} : {next: {block: below}}),
  }
}

/// The workspace with `block` at `place`. In a socket it replaces what is there; in a stack what is there goes below it.
export function plug(workspace: SavedWorkspace, place: Place, block: SavedBlock): SavedWorkspace {
  const at = "below" in place ? place.below : place.block
  const change = (b: SavedBlock): SavedBlock => {
    if (b.id !== at) return mapChildren(b, change)
    if ("below" in place) return {...b, next: {block: onTop(block, b.next)}}
    const old: SavedInput | undefined = b.inputs?.[place.input]
    // Only stacks have blocks that something can stand below.
    const stacked = old?.block !== undefined && canStack(old.block) ? onTop(block, {block: old.block}) : block
    return {...b, inputs: {...b.inputs, [place.input]: {block: stacked}}}
  }
  return withBlocks(workspace, workspace.blocks.blocks.map(change))
}

function canStack(block: SavedBlock): boolean {
  return (
    block.type.startsWith("step_") ||
    block.type.startsWith("define") ||
    declarationTextOf(block.type, {text: ""}) !== undefined
  )
}

function onTop(block: SavedBlock, below: SavedInput | undefined): SavedBlock {
  if (below?.block === undefined) return block
  return block.next?.block === undefined
    ? {...block, next: below}
    : {...block, next: {block: onTop(block.next.block, below)}}
}
