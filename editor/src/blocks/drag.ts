/// How a block is moved, by pointer or by keys: Blockly's own way, with codegen asked where it may go, and a
/// sentence when it may not.

import type {Place} from "@rosy/codegen"
import * as Blockly from "blockly/core"
import {type Asker, beginMovement, endMovement, Movement, movementIn, placeOf} from "./checker.ts"
import {moveBelowOthers} from "./fill.ts"
import type {RefusalLine} from "./refusal.ts"

/// What a movement needs from the view that it happens in.
export interface DragHost {
  /// Codegen's answers about the workspace as it stands now.
  asker(): Asker
  /// The block that was chosen before the toolbox was opened: what the keys bring may take its place.
  chosen(): Blockly.Block | undefined
  readonly refusal: RefusalLine
}

class Dragging extends Blockly.dragging.BlockDragStrategy {
  private readonly moved: Blockly.BlockSvg
  private readonly host: DragHost
  private byKeyboard = false

  constructor(block: Blockly.BlockSvg, host: DragHost) {
    super(block)
    this.moved = block
    this.host = host
  }

  override startDrag(
    event?: PointerEvent | KeyboardEvent,
  ): ReturnType<Blockly.dragging.BlockDragStrategy["startDrag"]> {
    this.byKeyboard = event instanceof KeyboardEvent
    // A block in the toolbox is copied; the copy starts its own movement.
    if (!this.moved.isInFlyout) {
      const steps = this.byKeyboard ? {over: this.host.chosen()} : undefined
      beginMovement(this.moved.workspace, new Movement(this.host.asker(), origin(this.moved), steps))
    }
    return super.startDrag(event)
  }

  protected override positionNewBlock(offered: Blockly.BlockSvg, made: Blockly.BlockSvg): void {
    super.positionNewBlock(offered, made)
    if (this.byKeyboard) moveBelowOthers(made)
  }

  /// Asks about every socket there is. The keys need it to step from one to the next, the pointer does not.
  override cacheAllConnectionPairs(): void {
    if (this.byKeyboard) super.cacheAllConnectionPairs()
  }

  override drag(to: Blockly.utils.Coordinate, event?: PointerEvent | KeyboardEvent): void {
    const movement = movementIn(this.moved.workspace)
    movement?.step()
    super.drag(to, event)
    if (movement === undefined) return
    const nearest = movement.accepted
      ? undefined
      : movement.refusals.reduce<Movement["refusals"][number] | undefined>(
          (best, next) => (best === undefined || next.distance < best.distance ? next : best),
          undefined,
        )
    if (nearest === undefined) this.host.refusal.hide()
    else this.host.refusal.show(nearest.why, this.moved, event instanceof PointerEvent ? event : undefined)
  }

  override endDrag(...end: Parameters<Blockly.dragging.BlockDragStrategy["endDrag"]>): void {
    this.host.refusal.hide()
    try {
      super.endDrag(...end)
    } finally {
      endMovement(this.moved.workspace)
    }
  }

  override revertDrag(): void {
    try {
      super.revertDrag()
    } finally {
      this.host.refusal.hide()
      endMovement(this.moved.workspace)
    }
  }
}

function origin(block: Blockly.BlockSvg): Place | undefined {
  const above = block.outputConnection?.targetConnection ?? block.previousConnection?.targetConnection
  return above == null ? undefined : placeOf(above)
}

/// Gives up what a hand has under way, since the blocks in it are about to be replaced: a block that moves goes back to
/// where it was, and an open field or menu closes.
export function giveUpMovement(workspace: Blockly.WorkspaceSvg): void {
  const mover = Blockly.KeyboardMover.mover
  if (mover.isMoving()) mover.abortMove()
  if (workspace.isDragging()) workspace.cancelCurrentGesture()
  endMovement(workspace)
  Blockly.WidgetDiv.hideIfOwnerIsInWorkspace(workspace)
}

/// Makes a block move our way.
export function makeDraggable(block: Blockly.BlockSvg, host: DragHost): void {
  block.setDragStrategy(new Dragging(block, host))
}
