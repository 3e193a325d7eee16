/// The blocks of the toolbox that a lesson shows: those that say nothing but words that this or an earlier lesson has brought.

import type {SavedBlock, ToolboxCategory} from "@rosy/codegen"

/// Blocks that belong to every lesson: numbers, names, and what stands for anything.
const plain: ReadonlySet<string> = new Set(["number", "pattern_name", "pattern_any", "raw_expression"])

/// What a block and those in it say: names of Haskell, operators, or else the kind of the block.
export function wordsOf(block: SavedBlock): readonly string[] {
  const inner = [...Object.values(block.inputs ?? {}), block.next].flatMap(input =>
    input?.block === undefined ? [] : wordsOf(input.block),
  )
  return plain.has(block.type) ? inner : [wordOf(block), ...inner]
}

function wordOf(block: SavedBlock): string {
  const {con, of, name, op, as} = block.extraState ?? {}
  if (block.type === "main") return "simulate"
  // The name of a definition is the learner's own.
  if (block.type === "define") return `define ${typeof as === "string" ? as : "plain"}`
  const found = [con, of, op, block.type === "name" || block.type === "call" ? name : undefined]
  return found.find(word => typeof word === "string") ?? block.type
}

/// The categories with the blocks of these words only; empty ones are left out.
export function toolboxOf(
  categories: readonly ToolboxCategory[],
  words: readonly string[],
): readonly ToolboxCategory[] {
  const known = new Set(words)
  const hasFunctions = words.some(word => word.startsWith("define "))
  const isKnown = (block: SavedBlock) =>
    wordsOf(block).every(word => known.has(word)) && (hasFunctions || !block.type.startsWith("pattern_"))
  return categories
    .map(category => ({
      ...category,
      items: category.items.filter(({block}) => isKnown(block)),
    }))
    .filter(category => category.items.length > 0)
}
