/// Dragging a name out of its binder.

import * as Blockly from "blockly/core"
import type {Binder} from "./fields.ts"

/// Takes a reference out of its binder and puts it under the pointer, which goes on dragging it.
///
/// One frame later: on the press Blockly asked for the pressed block to be brought to the front, which would take
/// the focus from the new one, and Blockly drags what has the focus.
export function pull(workspace: Blockly.WorkspaceSvg, field: Binder, event: PointerEvent): void {
  const name = field.getValue() ?? ""
  if (name === "") return
  workspace.cancelCurrentGesture()
  let pointer = event
  const over = new AbortController()
  window.addEventListener(
    "pointermove",
    move => {
      if (move.pointerId === event.pointerId) pointer = move
    },
    {capture: true, signal: over.signal},
  )
  for (const end of ["pointerup", "pointercancel"]) {
    window.addEventListener(end, () => over.abort(), {capture: true, signal: over.signal})
  }
  requestAnimationFrame(() => {
    if (over.signal.aborted) return
    over.abort()
    dragReference(workspace, name, pointer)
  })
}

function dragReference(workspace: Blockly.WorkspaceSvg, name: string, pointer: PointerEvent): void {
  const at = Blockly.utils.svgMath.screenToWsCoordinates(
    workspace,
    new Blockly.utils.Coordinate(pointer.clientX, pointer.clientY),
  )
  Blockly.Events.setGroup(true)
  const block = Blockly.serialization.blocks.append({type: "name", extraState: {name}}, workspace, {
    recordUndo: true,
  }) as Blockly.BlockSvg
  // Blocks begin at their right edge where one writes from right to left.
  block.moveTo(new Blockly.utils.Coordinate(at.x + (workspace.RTL ? 24 : -24), at.y - 14))
  // Only what is drawn can have the focus.
  Blockly.renderManagement.triggerQueuedRenders(workspace)
  // A press on the new block at the same spot: from here on it is an ordinary drag.
  block.getSvgRoot().dispatchEvent(
    new PointerEvent("pointerdown", {
      bubbles: true,
      cancelable: true,
      clientX: pointer.clientX,
      clientY: pointer.clientY,
      pointerId: pointer.pointerId,
      pointerType: pointer.pointerType,
      isPrimary: pointer.isPrimary,
      button: 0,
      buttons: 1,
    }),
  )
  Blockly.Events.setGroup(false)
}
