/// Drops on sockets that a dragged block has no connection for.
///
/// Blockly compares only connections that could join: it never asks about a definition over a socket for a value, or about a
/// value over a stack. This finds such a socket, so that a definition can leave a reference in it, a step can become the first of a
/// task in it, and every other block is refused with a reason.

import * as Blockly from "blockly/core"
import {words} from "../../words/index.ts"

/// Workspace units: the part of an empty socket that takes a drop, and how far beside it the pointer may be.
const socketSize = {width: 48, height: 26}
const reach = 14

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

/// The empty socket or stack under the pointer that `block` has no connection for.
export function foreignSocketUnder(
  block: Blockly.BlockSvg,
  pointer: PointerEvent,
): Blockly.RenderedConnection | undefined {
  const {workspace} = block
  const at = Blockly.utils.svgMath.screenToWsCoordinates(
    workspace,
    new Blockly.utils.Coordinate(pointer.clientX, pointer.clientY),
  )
  const corner = block.getRelativeToSurfaceXY()
  let best: {readonly socket: Blockly.RenderedConnection; readonly distance: number} | undefined
  for (const other of workspace.getAllBlocks(false)) {
    if (other.isInsertionMarker() || other.getRootBlock() === block) continue
    for (const {connection} of other.inputList) {
      if (!(connection instanceof Blockly.RenderedConnection) || connection.targetBlock() !== null) continue
      if (!isForeign(block, connection)) continue
      const distance = Math.min(
        distanceToSocket(at, connection, workspace.RTL),
        distanceToSocket(corner, connection, workspace.RTL),
      )
      if (distance <= reach && (best === undefined || distance < best.distance))
        best = {socket: connection, distance}
    }
  }
  return best?.socket
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
