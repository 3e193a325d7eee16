/// Equality, differences and merge of saved workspaces. Pure: no Blockly.

import type {SavedBlock, SavedWorkspace} from "@rosy/codegen"

/// Whether two saved blocks are equal, independent of the writer: Blockly and codegen order keys in their own ways, Blockly writes an `extraState` also
/// where there is nothing to say, and adds to a remark how large its bubble is. Blocks are values, and untouched ones are the very same one as a rule.
export function sameBlock(one: SavedBlock | undefined, other: SavedBlock | undefined): boolean {
  return same(one, other, "")
}

function same(one: unknown, other: unknown, key: string): boolean {
  if (one === other) return true
  if (typeof one !== "object" || typeof other !== "object" || one === null || other === null) return false
  if (Array.isArray(one) || Array.isArray(other)) {
    if (!Array.isArray(one) || !Array.isArray(other) || one.length !== other.length) return false
    return one.every((item, i) => same(item, other[i], ""))
  }
  const [mine, others] = [one as {[name: string]: unknown}, other as {[name: string]: unknown}]
  if (key === "comment") return mine.text === others.text
  for (const name in mine) if (!same(mine[name], partOf(others, name), name)) return false
  for (const name in others)
    if (mine[name] === undefined && !same(partOf(mine, name), others[name], name)) return false
  return true
}

const nothing = {}

const partOf = (block: {[name: string]: unknown}, name: string): unknown =>
  block[name] ?? (name === "extraState" ? nothing : undefined)

/// The blocks of `wanted` that say something else about themselves than in `now`, if that is all in which the two trees differ.
export function changesOf(now: SavedBlock, wanted: SavedBlock): readonly SavedBlock[] | undefined {
  if (now === wanted) return []
  const {extraState: mine = nothing, inputs = {}, next, ...own} = now
  const {extraState: others = nothing, inputs: wantedInputs = {}, next: wantedNext, ...wantedOwn} = wanted
  if (!same(own, wantedOwn, "") || (next === undefined) !== (wantedNext === undefined)) return undefined
  const names = Object.keys(wantedInputs)
  if (names.length !== Object.keys(inputs).length) return undefined
  const below = [
    ...names.map(name => [inputs[name], wantedInputs[name]] as const),
    ...(next === undefined ? [] : [[next, wantedNext] as const]),
  ]
  const changes = same(mine, others, "") ? [] : [wanted]
  for (const [one, other] of below) {
    const inner = one?.block && other?.block && changesOf(one.block, other.block)
    if (inner === undefined || one?.shadow !== undefined || other?.shadow !== undefined) return undefined
    changes.push(...inner)
  }
  return changes
}

/// Whether two workspaces hold the same blocks, in any order.
export function sameBlocks(one: SavedWorkspace, other: SavedWorkspace): boolean {
  if (one === other) return true
  const [mine, others] = [one.blocks.blocks, other.blocks.blocks]
  if (one.header !== other.header || mine.length !== others.length) return false
  if (mine.every((block, i) => block === others[i])) return true
  const byId = new Map(others.map(block => [block.id, block]))
  return mine.every(block => sameBlock(block, byId.get(block.id)))
}

/// `now` with what makes `edited` differ from `shown`, top-level block by top-level block. Where both have changed what the
/// same one says, the edit of the blocks counts: it was made last. A block that only moved or folded says what it says by now.
export function mergeWorkspaces(
  shown: SavedWorkspace,
  edited: SavedWorkspace,
  now: SavedWorkspace,
): SavedWorkspace {
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
