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

/// The camera, and what it does when the size of the view has changed.
export function cameraOf(
  workspace: Blockly.WorkspaceSvg,
  deferred: DeferredCreation,
): {readonly camera: Camera; readonly resized: () => void} {
  /// The scale at which the blocks were shown when they were opened, and the one that the learner had before.
  let fitted: {
    readonly scale: number
    readonly own: number
    readonly scrollY: number
    readonly inLesson: boolean
  } | null = null
  const goToStart = (inLesson: boolean) => {
    Blockly.renderManagement.triggerQueuedRenders(workspace)
    const content = workspace.getMetricsManager().getContentMetrics(true)
    const own = fitted !== null && workspace.scale === fitted.scale ? fitted.own : workspace.scale
    const {width} = workspace.getMetricsManager().getViewMetrics()
    const least = inLesson ? leastLessonScale : leastScale
    const scale = scaleToFit(content.width, width - 2 * startMargin, own, least)
    if (scale !== workspace.scale) workspace.setScale(scale)
    const fromStart = startMargin - content.left * scale
    const fromEnd = width - startMargin - (content.left + content.width) * scale
    workspace.scroll(workspace.RTL ? fromEnd : fromStart, startMargin - content.top * scale)
    // Blockly may have taken a scale a little beside the one that was asked for.
    fitted = {scale: workspace.scale, own, scrollY: workspace.scrollY, inLesson}
    deferred.makeNear()
  }
  const camera: Camera = {
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
    goToStart,
    zoomToFit() {
      deferred.makeAll()
      showAll(workspace)
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
  // The panel of a lesson appears after its program. A size or a place that the learner has chosen stays.
  const resized = () => {
    if (workspace.scale !== fitted?.scale) return
    // The panel of a lesson may have moved the blocks.
    if (fitted.inLesson || workspace.scrollY === fitted.scrollY) goToStart(fitted.inLesson)
  }
  return {camera, resized}
}

/// Shows all blocks in the middle of the view, none of them larger than it is.
export function showAll(workspace: Blockly.WorkspaceSvg): void {
  workspace.zoomToFit()
  if (workspace.scale <= 1) return
  workspace.setScale(1)
  workspace.scrollCenter()
}

/// The smallest scale at which the blocks of a program are shown by themselves: 15 px become 11. In a lesson, whose panel takes a part
/// of the width, 15 px become 8.
const leastScale = 0.75
const leastLessonScale = 0.55

/// The scale at which so many workspace units are seen in so many pixels: not larger than `own`, and not less than `least` by itself.
export const scaleToFit = (units: number, pixels: number, own: number, least: number): number =>
  units <= 0 ? own : Math.min(own, Math.max(least, pixels / units))

/// Pixels between the edge of the view and the first block of a program that was opened.
const startMargin = 12

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
