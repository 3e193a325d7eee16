/// Deferred blocks: top-level blocks far outside of the visible area, which Blockly has not made yet. A program of 1,000 lines is 2,300 blocks, and
/// Blockly needs a millisecond of processor time for each, most of it for drawings outside of the visible area.
///
/// Until they are made (`deferred_creation.ts`) their saved form stands for them: a workspace is saved with them, so that types, text and files always have
/// the whole program.

import type {BlockId, SavedBlock} from "@rosy/codegen"
import type * as Blockly from "blockly/core"

/// Programs with fewer top-level blocks are made at once.
const few = 40

/// Pixels by which each block in it may make a top-level block higher or wider: an equation takes several rows, a menu some words.
const heightOfOne = 60
const widthOfOne = 150

const deferred = new WeakMap<Blockly.Workspace, ReadonlyMap<BlockId, SavedBlock>>()

const none: ReadonlyMap<BlockId, SavedBlock> = new Map()

export function deferredBlocks(workspace: Blockly.Workspace): ReadonlyMap<BlockId, SavedBlock> {
  return deferred.get(workspace) ?? none
}

export function setDeferredBlocks(workspace: Blockly.Workspace, blocks: readonly SavedBlock[]): void {
  if (blocks.length === 0) deferred.delete(workspace)
  else deferred.set(workspace, new Map(blocks.map(block => [block.id ?? "", block])))
}

/// The visible part of a workspace, in its own pixels.
export interface VisibleArea {
  readonly left: number
  readonly top: number
  readonly width: number
  readonly height: number
}

/// Which of the `fresh` blocks of a program can be made later. The outermost ones of the program are made at once: they say how far the workspace can be scrolled.
export function deferrable(
  fresh: readonly SavedBlock[],
  all: readonly SavedBlock[],
  view: VisibleArea,
): ReadonlySet<SavedBlock> {
  if (all.length < few) return new Set()
  const placed = (blocks: readonly SavedBlock[]) =>
    blocks.filter(block => block.id !== undefined && (block.x ?? block.y) !== undefined)
  // Of the whole program: of the fresh ones, which are fewer with each load, others would be outermost each time.
  const outermost = (["x", "y"] as const).flatMap(axis => {
    const along = placed(all).sort((one, other) => (one[axis] ?? 0) - (other[axis] ?? 0))
    return [along[0], along.at(-1)]
  })
  return new Set(placed(fresh).filter(block => !outermost.includes(block) && isFarFrom(view, block)))
}

/// Whether a saved block is surely more than half a view away from the visible area. How large it is, is not known before it is made.
export function isFarFrom(view: VisibleArea, block: SavedBlock): boolean {
  return (
    isOutside(block.x ?? 0, view.left, view.width, () => contentsOf(block).count * widthOfOne) ||
    isOutside(block.y ?? 0, view.top, view.height, () => contentsOf(block).count * heightOfOne)
  )
}

function isOutside(start: number, from: number, length: number, size: () => number): boolean {
  return start > from + 1.5 * length || start + size() < from - 0.5 * length
}

/// Whether a saved block is or holds the one with this id.
export function holdsBlock(block: SavedBlock, id: BlockId): boolean {
  return contentsOf(block).ids.has(id)
}

/// What a saved block is and holds: how many blocks, and their ids.
interface Contents {
  readonly count: number
  readonly ids: ReadonlySet<BlockId>
}

/// Saved blocks do not change, and each key in a large program asks about all that are deferred.
const contents = new WeakMap<SavedBlock, Contents>()

function contentsOf(block: SavedBlock): Contents {
  const known = contents.get(block)
  if (known !== undefined) return known
  const ids: BlockId[] = []
  const count = collect(block, ids)
  const made = {count, ids: new Set(ids)}
  contents.set(block, made)
  return made
}

function collect({id, inputs = {}, next}: SavedBlock, ids: BlockId[]): number {
  if (id !== undefined) ids.push(id)
  let count = 1
  for (const {block} of [...Object.values(inputs), ...(next === undefined ? [] : [next])])
    if (block !== undefined) count += collect(block, ids)
  return count
}
