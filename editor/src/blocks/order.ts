/// When two saved blocks are the same. Pure: no Blockly.

import type {SavedBlock} from "@rosy/codegen"

/// A block as text that is the same whoever wrote it: Blockly and codegen order keys in their own ways, and Blockly
/// adds to a remark how large its bubble is.
export function inOneOrder(block: SavedBlock): string {
  let text = written.get(block)
  if (text === undefined) {
    text = write(block)
    written.set(block, text)
  }
  return text
}

/// Saved blocks are values, and those of definitions that nobody touched come again and again.
const written = new WeakMap<SavedBlock, string>()

function write(block: SavedBlock): string {
  return JSON.stringify(block, (key, value: unknown) => {
    if (typeof value !== "object" || value === null || Array.isArray(value)) return value
    const entries = Object.entries(value).filter(([name]) => key !== "comment" || name === "text")
    return Object.fromEntries(entries.sort(([a], [b]) => (a < b ? -1 : a > b ? 1 : 0)))
  })
}
