/// Drawer of the toolbox: Blockly's flyout, narrower than the block view. The place that is to be filled stays in sight beside it.

import * as Blockly from "blockly/core"
import {moveToFreePlace} from "../dragging/placement.ts"
import {chosenNode} from "./insertion_points.ts"

/// Size of blocks in the drawer beside those of the program: words of 14 pixels are 12 there.
const drawerScale = 0.86

/// Pixels that the drawer leaves free, and the least part of the block view that it takes where that is narrow.
const leftFree = 140
const leastShare = 0.62

/// Pixels between the drawer and the place that is to be filled.
const beside = 18

/// Pixels by which the workspace moves without being scrolled, when what is in it changes.
const still = 8

class Drawer extends Blockly.VerticalFlyout {
  /// How far the blocks were scrolled for the drawer, and where they were scrolled to by that.
  private moved: {readonly by: number; readonly to: number} | undefined

  override getFlyoutScale(): number {
    return super.getFlyoutScale() * drawerScale
  }

  protected override reflowInternal_(): void {
    super.reflowInternal_()
    // From right to left the blocks have been placed by the width already.
    if (this.targetWorkspace.RTL) return
    const {viewWidth} = this.targetWorkspace.getMetrics()
    const widest = Math.max(viewWidth - leftFree, viewWidth * leastShare)
    if (viewWidth === 0 || this.width_ <= widest) return
    this.width_ = widest
    this.position()
    this.targetWorkspace.recordDragTargets()
  }

  override show(contents: Parameters<Blockly.VerticalFlyout["show"]>[0]): void {
    super.show(contents)
    this.reveal()
  }

  override hide(): void {
    super.hide()
    const {moved, targetWorkspace: workspace} = this
    this.moved = undefined
    if (moved === undefined) return
    const goBack = () => {
      // If the learner has scrolled since then, the blocks stay where they are.
      if (Math.abs(workspace.scrollX - moved.to) <= still)
        workspace.scroll(workspace.scrollX - moved.by, workspace.scrollY)
    }
    if (!workspace.isDragging()) {
      goBack()
      return
    }
    // The drawer closes when a block is dragged out of it: what is under the pointer stays there until it is dropped.
    const onDrop = (event: Blockly.Events.Abstract) => {
      if (!(event instanceof Blockly.Events.BlockDrag) || event.isStart === true) return
      workspace.removeChangeListener(onDrop)
      goBack()
      const dropped = event.blockId === undefined ? null : workspace.getBlockById(event.blockId)
      if (dropped !== null) moveToFreePlace(dropped, true)
    }
    workspace.addChangeListener(onDrop)
  }

  /// Scrolls the place that is to be filled out from behind the drawer.
  private reveal(): void {
    const workspace = this.targetWorkspace
    if (workspace.RTL) return
    const node = chosenNode(workspace)
    const block = node instanceof Blockly.RenderedConnection ? node.getSourceBlock() : node
    if (!(block instanceof Blockly.BlockSvg)) return
    const x = node instanceof Blockly.RenderedConnection ? node.x : block.getBoundingRectangle().left
    const behind = this.getWidth() + beside - (workspace.scrollX + x * workspace.scale)
    if (behind <= 0) return
    const before = workspace.scrollX
    workspace.scroll(before + behind, workspace.scrollY)
    const by = workspace.scrollX - before + (this.moved?.by ?? 0)
    this.moved = {by, to: workspace.scrollX}
  }
}

/// Once for the page.
export function registerDrawer(): void {
  const {registry} = Blockly
  registry.register(registry.Type.FLYOUTS_VERTICAL_TOOLBOX, registry.DEFAULT, Drawer, true)
}
