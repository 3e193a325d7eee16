/// Putting a ready block down without aiming: at the place that is chosen, or beside the others when it fits nowhere.

import type {Checker, Place, SavedBlock} from "@rosy/codegen"
import * as Blockly from "blockly/core"
import {beginMovement, endMovement, Movement} from "./checker.ts"

/// Pixels from the corner of an empty workspace, and between blocks, where a new one comes that nobody places by hand.
const freePlace = 30
const freeGap = 28

/// Below all others: definitions are read, and printed, from top to bottom.
export function moveBelowOthers(block: Blockly.BlockSvg): void {
  const others = block.workspace.getTopBlocks(false).filter(other => other !== block)
  const boxes = others.map(other => other.getBoundingRectangle())
  const box = block.getBoundingRectangle()
  const x = Math.min(...boxes.map(other => other.left), box.left + freePlace)
  const y = Math.max(...boxes.map(other => other.bottom), freePlace - freeGap) + freeGap
  block.moveBy(x - box.left, y - box.top, ["cleanup"])
}

/// Puts a new block into the first of `places` that takes it, else below all others, and gives it the focus. One step
/// of undo. What was in the place goes into the new block if it fits there, and lies beside it if not.
export function putDown(
  workspace: Blockly.WorkspaceSvg,
  wanted: SavedBlock,
  places: readonly Place[],
  ask: () => Checker,
): void {
  const before = ask()
  const place = places.find(one => before.fits(one, wanted).fits)
  Blockly.Events.setGroup(true)
  try {
    const block = Blockly.serialization.blocks.append(
      wanted as Blockly.serialization.blocks.State,
      workspace,
      {recordUndo: true},
    ) as Blockly.BlockSvg
    Blockly.renderManagement.triggerQueuedRenders(workspace)
    const socket = place && socketAt(workspace, place)
    if (socket == null) moveBelowOthers(block)
    else {
      beginMovement(workspace, new Movement(ask(), place))
      socket.connect((block.outputConnection ?? block.previousConnection)!)
      endMovement(workspace)
    }
    // Only what is drawn can have the focus.
    Blockly.renderManagement.triggerQueuedRenders(workspace)
    Blockly.getFocusManager().focusNode(block)
    workspace.scrollBoundsIntoView(block.getBoundingRectangleWithoutChildren())
  } finally {
    Blockly.Events.setGroup(false)
  }
}

function socketAt(workspace: Blockly.WorkspaceSvg, place: Place): Blockly.Connection | null | undefined {
  return "below" in place
    ? workspace.getBlockById(place.below)?.nextConnection
    : workspace.getBlockById(place.block)?.getInput(place.input)?.connection
}
