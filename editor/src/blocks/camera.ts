/// Camera of the block view: place, zoom, and what is brought into view.

import type {BlockId} from "@rosy/codegen"
import * as Blockly from "blockly/core"
import type {BlocksView} from "./block_view_types.ts"
import {isVisible, moveStraysBack} from "./dragging/placement.ts"
import type {DeferredCreation} from "./workspace/deferred_creation.ts"

export type Camera = Pick<
  BlocksView,
  "select" | "reveal" | "place" | "goTo" | "goToStart" | "zoomToFit" | "bringStraysHome" | "focus" | "resize"
>

export function cameraOf(workspace: Blockly.WorkspaceSvg, deferred: DeferredCreation): Camera {
  return {
    select(id) {
      if (id !== undefined) deferred.makeHolderOf(id)
      const block = id === undefined ? null : workspace.getBlockById(id)
      // What is not drawn cannot have the focus.
      block?.getRootBlock().getSvgRoot().classList.remove("rosyAway")
      if (block === null) {
        Blockly.getFocusManager().focusNode(workspace)
        return
      }
      Blockly.getFocusManager().focusNode(block)
      workspace.centerOnBlock(block.id)
    },
    reveal(id) {
      deferred.makeHolderOf(id)
      const block = workspace.getBlockById(id)
      if (block !== null && !isVisible(workspace, block)) workspace.centerOnBlock(id)
    },
    place: () => ({x: workspace.scrollX, y: workspace.scrollY, scale: workspace.scale}),
    goTo({x, y, scale}) {
      workspace.setScale(scale)
      workspace.scroll(x, y)
      deferred.makeNear()
    },
    goToStart() {
      Blockly.renderManagement.triggerQueuedRenders(workspace)
      const content = workspace.getMetricsManager().getContentMetrics(true)
      const view = workspace.getMetricsManager().getViewMetrics()
      const {scale} = workspace
      const fromStart = startMargin - content.left * scale
      const fromEnd = view.width - startMargin - (content.left + content.width) * scale
      workspace.scroll(workspace.RTL ? fromEnd : fromStart, startMargin - content.top * scale)
      deferred.makeNear()
    },
    zoomToFit() {
      deferred.makeAll()
      workspace.zoomToFit()
    },
    bringStraysHome() {
      deferred.makeAll()
      moveStraysBack(workspace)
    },
    focus: () => Blockly.getFocusManager().focusTree(workspace),
    resize() {
      Blockly.svgResize(workspace)
      deferred.makeNear()
    },
  }
}

/// Pixels between the edge of the view and the first block of a program that was opened.
const startMargin = 18

/// The block that the keyboard is on, if it is on one that loading may replace.
export function focusedBlock(workspace: Blockly.WorkspaceSvg): BlockId | undefined {
  const manager = Blockly.getFocusManager()
  if (manager.getFocusedTree() !== workspace) return undefined
  const node = manager.getFocusedNode()
  if (node instanceof Blockly.BlockSvg) return node.id
  if (node instanceof Blockly.Field || node instanceof Blockly.RenderedConnection) {
    return node.getSourceBlock()?.id
  }
  return undefined
}
