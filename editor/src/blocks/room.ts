/// Room for a block that grew: what stood below it and would now be covered moves down, just as far as it must.
///
/// Nothing else is moved, and what overlapped before stays where the learner put it.

import type * as Blockly from "blockly/core"

interface Box {
  readonly left: number
  readonly right: number
  readonly top: number
  readonly bottom: number
}

/// Workspace units between a block that grew and the one that made room.
const gap = 20
/// Nearer than this looks like one block.
const near = 8

/// How far each of the boxes `after` has to move down, by id, when those `before` have become them. Pure.
export function makeRoom(
  before: ReadonlyMap<string, Box>,
  after: ReadonlyMap<string, Box>,
): ReadonlyMap<string, number> {
  const moves = new Map<string, number>()
  const now = new Map(after)
  const grown = [...after.keys()].filter(id => {
    const old = before.get(id)
    const box = after.get(id)!
    return old !== undefined && old.top === box.top && old.left === box.left && old.bottom < box.bottom
  })
  // Whoever moves may cover the next one.
  for (const id of grown) {
    const mover = now.get(id)!
    const below = [...now.keys()]
      .filter(other => other !== id && now.get(other)!.top > mover.top)
      .sort((a, b) => now.get(a)!.top - now.get(b)!.top)
    const risen = [id]
    for (const other of below) {
      const box = now.get(other)!
      let needed = 0
      for (const one of risen) {
        const cover = now.get(one)!
        const old = before.get(one) ?? cover
        const was = before.get(other)
        if (
          !overlap({...cover, bottom: cover.bottom + near}, box) ||
          (was !== undefined && overlap(old, was))
        )
          continue
        needed = Math.max(needed, cover.bottom + gap - box.top)
      }
      if (needed === 0) continue
      now.set(other, {...box, top: box.top + needed, bottom: box.bottom + needed})
      moves.set(other, (moves.get(other) ?? 0) + needed)
      risen.push(other)
    }
  }
  return moves
}

function overlap(one: Box, other: Box): boolean {
  return one.left < other.right && other.left < one.right && one.top < other.bottom && other.top < one.bottom
}

/// Where the top-level blocks of a workspace are.
export function boxesOf(workspace: Blockly.WorkspaceSvg): ReadonlyMap<string, Box> {
  return new Map(workspace.getTopBlocks(false).map(block => [block.id, block.getBoundingRectangle()]))
}
