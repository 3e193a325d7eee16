/// Edits of blocks that were made before the blocks had followed the text: brought into the blocks that the text has by now. Pure.

import type {SavedBlock, SavedWorkspace} from "@rosy/codegen"
import {sameBlock} from "../blocks/order.ts"

/// `now` with what makes `edited` differ from `shown`, top-level block by top-level block. Where both have changed what the
/// same one says, the edit of the blocks counts: it was made last. A block that only moved or folded says what it says by now.
export function merged(shown: SavedWorkspace, edited: SavedWorkspace, now: SavedWorkspace): SavedWorkspace {
  const before = byId(shown)
  const after = byId(edited)
  const touched = (block: SavedBlock) => !sameBlock(before.get(block.id), block)
  const kept = now.blocks.blocks.flatMap(block => {
    const mine = after.get(block.id)
    if (mine === undefined) return before.has(block.id) ? [] : [block]
    if (!touched(mine)) return [block]
    const was = before.get(block.id)
    return [was !== undefined && sameBlock(inPlaceOf(mine, was), mine) ? inPlaceOf(mine, block) : mine]
  })
  const there = new Set(kept.map(block => block.id))
  const added = edited.blocks.blocks.filter(block => !there.has(block.id) && touched(block))
  return {...now, blocks: {...now.blocks, blocks: [...kept, ...added]}}
}

function byId({blocks}: SavedWorkspace): ReadonlyMap<string | undefined, SavedBlock> {
  return new Map(blocks.blocks.map(block => [block.id, block]))
}

/// A block where another one is, and folded as that is.
function inPlaceOf({x, y, collapsed}: SavedBlock, block: SavedBlock): SavedBlock {
  const {x: _x, y: _y, collapsed: _collapsed, ...said} = block
  return {
    ...said,
    ...(x === undefined ? {} : {x}),
    ...(y === undefined ? {} : {y}),
    ...(collapsed === undefined ? {} : {collapsed}),
  }
}
