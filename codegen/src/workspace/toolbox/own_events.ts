/// Reactions to events of the program's own: the ready block takes the event, where there is exactly one to take.

import type {SavedBlock, SavedWorkspace} from "../../serialized_blocks.ts"
import {make} from "./block_builders.ts"

const name = "onEvent"

/// A constructor in the state of a `data` block.
interface Constructor {
  readonly name: string
  readonly fields: readonly unknown[]
}

/// The ready block, without an event.
export const ownEventReaction = (): SavedBlock =>
  make("define", {name, as: "event", arity: 1, equations: [{}]})

/// The ready block with the event of the program that it is to take. Any other block, and one in a program with no event of its own or with
/// several, stays as it is.
export function withOnlyEvent(block: SavedBlock, workspace: SavedWorkspace): SavedBlock {
  if (block.type !== "define" || block.extraState?.["name"] !== name || block.inputs !== undefined)
    return block
  const [only, ...others] = workspace.blocks.blocks
    .filter(one => one.type === "data")
    .flatMap(one => one.extraState?.["constructors"] as unknown as readonly Constructor[])
  if (only === undefined || others.length > 0 || only.fields.length > 0) return block
  return {...block, inputs: {P0_0: {block: make("pattern_construct", {con: only.name, args: 0})}}}
}
