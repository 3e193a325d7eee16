/// Blocks that a robot can do nothing with: they name a sensor or a command that it lacks, or call a ready-made task
/// that does.

import type {ToolboxCategory, ToolboxItem} from "../../api.ts"
import type {SavedBlock} from "../../serialized_blocks.ts"
import {generated} from "./library_definitions.generated.ts"

const definitions = generated as readonly {readonly name: string; readonly block: SavedBlock}[]

/// The categories without the blocks that need a part which the robot lacks; empty ones are left out. `lacks`: types
/// and constructors, as in `robot.simulated`.
export function withoutMissingParts(
  categories: readonly ToolboxCategory[],
  lacks: readonly string[],
): readonly ToolboxCategory[] {
  if (lacks.length === 0) return categories
  const usable = usableWith(lacks)
  return categories
    .map(category => ({...category, items: category.items.filter(({block}) => usable(block))}))
    .filter(category => category.items.length > 0)
}

/// The items without those that need a part which the robot lacks.
export function usableItems(items: readonly ToolboxItem[], lacks: readonly string[]): readonly ToolboxItem[] {
  if (lacks.length === 0) return items
  const usable = usableWith(lacks)
  return items.filter(({block}) => usable(block))
}

/// Whether a robot that lacks these names can do something with a block. It reads all definitions of the library: for
/// many blocks it is called once.
export function usableWith(lacks: readonly string[]): (block: SavedBlock) => boolean {
  const missing = new Set(lacks)
  const isUsable = (block: SavedBlock) => !namesIn(block).some(name => missing.has(name))
  // A task is as unusable as the tasks that it calls.
  for (let known = -1; known < missing.size; ) {
    known = missing.size
    for (const {name, block} of definitions) if (!isUsable(block)) missing.add(name)
  }
  return isUsable
}

/// All names in a block and those in it, in signatures as well.
const namesIn = (block: SavedBlock): readonly string[] => JSON.stringify(block).match(/\w+/g) ?? []
