/// Drops on sockets that a dragged block has no connection for.
///
/// Blockly compares only connections that could join: it never asks about a definition over a socket for a value, or about a
/// value over a stack. This finds such a socket, so that a definition can leave a reference in it, a step can become the first of a
/// task in it, and every other block is refused with a reason.

import * as Blockly from "blockly/core"
import {words} from "../../../words/index.ts"
import type {Box} from "./free_place.ts"

/// Workspace units: the part of an empty socket that takes a drop, and how far beside it the pointer may be.
const socketSize = {width: 48, height: 26}
const reach = 14
/// Workspace units: the first row of a block.
const rowHeight = 40

/// A point of the workspace, in its own units.
export interface Point {
  readonly x: number
  readonly y: number
}

/// How far a point is from a rectangle; 0 inside. Pure.
function distanceToSocket(point: Point, socket: Point, rightToLeft = false): number {
  const left = rightToLeft ? socket.x - socketSize.width : socket.x
  const beside = Math.max(left - point.x, 0, point.x - left - socketSize.width)
  const above = Math.max(socket.y - point.y, 0, point.y - socket.y - socketSize.height)
  return Math.hypot(beside, above)
}

/// How far the corner of a block is from a socket that its first row lies over; infinite where it does not lie over it. Pure.
function distanceOverSocket(block: Box, socket: Point, rightToLeft = false): number {
  const left = rightToLeft ? socket.x - socketSize.width : socket.x
  const right = left + socketSize.width
  const bottom = Math.min(block.bottom, block.top + rowHeight)
  const isOver =
    block.left < right && left < block.right && block.top < socket.y + socketSize.height && socket.y < bottom
  if (!isOver) return Number.POSITIVE_INFINITY
  return Math.hypot(rightToLeft ? block.right - right : left - block.left, socket.y - block.top)
}

/// The empty socket or stack that `block` has no connection for, at the pointer or the corner of the block (`isPointedAt`), or else under its first row.
export function foreignSocketUnder(
  block: Blockly.BlockSvg,
  pointer: PointerEvent,
): {readonly socket: Blockly.RenderedConnection; readonly isPointedAt: boolean} | undefined {
  const {workspace} = block
  const at = Blockly.utils.svgMath.screenToWsCoordinates(
    workspace,
    new Blockly.utils.Coordinate(pointer.clientX, pointer.clientY),
  )
  const corner = block.getRelativeToSurfaceXY()
  const box = block.getBoundingRectangle()
  let best: {readonly socket: Blockly.RenderedConnection; readonly distance: number} | undefined
  for (const other of workspace.getAllBlocks(false)) {
    if (other.isInsertionMarker() || other.getRootBlock() === block) continue
    for (const {connection} of other.inputList) {
      if (!(connection instanceof Blockly.RenderedConnection) || connection.targetBlock() !== null) continue
      if (!isForeign(block, connection)) continue
      const near = Math.min(
        distanceToSocket(at, connection, workspace.RTL),
        distanceToSocket(corner, connection, workspace.RTL),
      )
      const distance = near <= reach ? near : reach + distanceOverSocket(box, connection, workspace.RTL)
      if (Number.isFinite(distance) && (best === undefined || distance < best.distance))
        best = {socket: connection, distance}
    }
  }
  return best && {socket: best.socket, isPointedAt: best.distance <= reach}
}

function isForeign(block: Blockly.BlockSvg, socket: Blockly.Connection): boolean {
  return socket.type === Blockly.ConnectionType.INPUT_VALUE
    ? block.outputConnection === null
    : block.previousConnection === null
}

/// Puts a reference, or the block that holds a step, into a socket; part of the current event group.
export function insertReference(
  socket: Blockly.RenderedConnection,
  reference: Blockly.serialization.blocks.State,
): Blockly.BlockSvg {
  const workspace = socket.getSourceBlock().workspace as Blockly.WorkspaceSvg
  const made = Blockly.serialization.blocks.append(reference, workspace, {
    recordUndo: true,
  }) as Blockly.BlockSvg
  if (made.outputConnection !== null) socket.connect(made.outputConnection)
  Blockly.utils.aria.announceDynamicAriaState(words.blocks.referenceLeft(made.toString()))
  return made
}
