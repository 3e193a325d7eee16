/// Placement of new blocks: columns without overlap, never on top of placed blocks.
///
/// Without a page the size of a block is unknown; it is guessed from its shape, rather too large than too small.

import {blockView} from "../../blocks/block_registry.ts"
import type {SavedBlock} from "../../serialized_blocks.ts"

export interface Size {
  /// Workspace units (pixels at scale 1).
  readonly width: number
  readonly height: number
}

interface Box extends Size {
  readonly x: number
  readonly y: number
}

// Zelos, Blockly's renderer that ours builds on: a row of fields is 40 high with its padding, a letter at 12 pt some 8 wide.
const letter = 8
const field = 20
const button = 28
const rowHeight = 48
const padding = 16
const emptySocket = 64
const stackIndent = 28

/// Distance between blocks, and of the first block from the corner.
const gap = 32
const corner = 40
/// A new column starts below this height.
const columnHeight = 1400

export function guessSize(block: SavedBlock, depth = 0): Size {
  const shape = blockView(block.type)?.shape(block.extraState ?? {})
  if (shape === undefined || depth > 200) return {width: 160, height: rowHeight}
  let width = 0
  let height = padding
  for (const row of shape.rows) {
    let w = padding
    let h = rowHeight
    for (const item of row) {
      switch (item.kind) {
        case "label":
          w += item.text.length * letter + field / 2
          break
        case "button":
          w += button
          break
        case "signature":
          w += 40 * letter
          break
        case "socket": {
          const inner = block.inputs?.[item.name]?.block
          const size =
            inner === undefined ? {width: emptySocket, height: rowHeight} : guessSize(inner, depth + 1)
          w += size.width + field / 2
          h = Math.max(h, size.height + padding)
          break
        }
        case "stack": {
          const size = stackSize(block.inputs?.[item.name]?.block, depth + 1)
          w += stackIndent + size.width
          h = Math.max(h, size.height + padding)
          break
        }
        default: {
          const lines = item.value.split("\n")
          w += Math.max(...lines.map(l => l.length)) * letter + field
          h = Math.max(h, lines.length * 20 + padding)
        }
      }
    }
    width = Math.max(width, w)
    height += h
  }
  return {width, height}
}

function stackSize(first: SavedBlock | undefined, depth: number): Size {
  let width = emptySocket
  let height = first === undefined ? rowHeight : 0
  for (let b = first; b !== undefined; b = b.next?.block) {
    const size = guessSize(b, depth)
    width = Math.max(width, size.width)
    height += size.height
  }
  return {width, height}
}

/// The blocks with a place for each that has none. `size` may know better than a guess.
export function place(
  blocks: readonly SavedBlock[],
  size: (block: SavedBlock) => Size = guessSize,
): SavedBlock[] {
  if (blocks.every(b => b.x !== undefined && b.y !== undefined)) return [...blocks]
  const boxes: Box[] = []
  for (const b of blocks) if (b.x !== undefined && b.y !== undefined) boxes.push({...size(b), x: b.x, y: b.y})
  let last: Box | undefined
  return blocks.map(b => {
    const own = size(b)
    if (b.x !== undefined && b.y !== undefined) {
      last = {...own, x: b.x, y: b.y}
      return b
    }
    const box = freePlace(own, last, boxes)
    boxes.push(box)
    last = box
    return {...b, x: box.x, y: box.y}
  })
}

/// Below the block before it, or as far down as it must; at the top of a new column when this one is full.
function freePlace(own: Size, last: Box | undefined, boxes: readonly Box[]): Box {
  let box: Box = {...own, x: last?.x ?? corner, y: last === undefined ? corner : last.y + last.height + gap}
  for (;;) {
    const hit = boxes.find(b => overlap(b, box))
    if (hit !== undefined) box = {...box, y: hit.y + hit.height + gap}
    else if (box.y > corner && box.y + box.height > columnHeight) {
      const right = boxes.reduce((x, b) => Math.max(x, b.x + b.width), 0)
      box = {...box, x: right + gap, y: corner}
    } else return box
  }
}

function overlap(a: Box, b: Box): boolean {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height
}
