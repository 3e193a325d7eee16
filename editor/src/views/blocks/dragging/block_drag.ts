/// Drag strategy of blocks, by pointer or keyboard: Blockly's own, restricted by codegen's answers, with the refusal message; and dragging a reference out of its binder.

import type {Place, SavedBlock} from "@rosy/codegen"
import * as Blockly from "blockly/core"
import type {BinderField} from "../construction/text_fields.ts"
import {giveUniqueNames} from "../construction/unique_names.ts"
import {
  beginMovement,
  endMovement,
  type FitChecker,
  Movement,
  movementIn,
  placeOf,
} from "./connection_checker.ts"
import {moveBelowOthers, moveToFreePlace} from "./placement.ts"
import {arbitrateInProgram, joinProgram} from "./program_membership.ts"
import {foreignSocketUnder, insertReference} from "./reference_drop.ts"

/// What a movement needs from the view that it happens in.
export interface DragHost {
  /// Codegen's answers about the workspace as it stands now.
  asker(): FitChecker
  /// The block that was chosen before the toolbox was opened: what the keys bring may take its place.
  chosen(): Blockly.Block | undefined
  readonly refusal: RefusalMessage
}

/// What a drop puts into a socket; `holds` is the stack of `block` that the moved step goes into.
interface Target {
  readonly socket: Blockly.RenderedConnection
  readonly block: SavedBlock
  readonly holds: string | undefined
}

class RosyDragStrategy extends Blockly.dragging.BlockDragStrategy {
  private readonly moved: Blockly.BlockSvg
  private readonly host: DragHost
  private byKeyboard = false
  /// Where this block leaves a reference if it is let go now.
  private target: Target | undefined

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
      // References are asked for by name: a new definition has one of its own from the beginning.
      if (brandNew.has(this.moved)) giveUniqueNames(this.moved.workspace, new Set([this.moved.id]))
      const steps = this.byKeyboard ? {over: this.host.chosen()} : undefined
      beginMovement(this.moved.workspace, new Movement(this.host.asker(), origin(this.moved), steps))
    }
    return super.startDrag(event)
  }

  protected override positionNewBlock(offered: Blockly.BlockSvg, made: Blockly.BlockSvg): void {
    brandNew.add(made)
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
    const foreign =
      event instanceof PointerEvent && !movement.accepted ? foreignSocketUnder(this.moved, event) : undefined
    const reference =
      foreign === undefined ? undefined : movement.referenceTo(placeOf(foreign.socket), this.moved.id)
    this.aim(
      foreign !== undefined && reference?.fits === true
        ? {socket: foreign.socket, block: reference.block, holds: reference.holds}
        : undefined,
    )
    if (this.target !== undefined) {
      this.host.refusal.hide()
      return
    }
    if (reference?.fits === false && foreign?.isPointedAt === true && movement.refusals.length === 0) {
      this.host.refusal.show(reference.why, this.moved, event instanceof PointerEvent ? event : undefined)
      return
    }
    const nearest = movement.accepted
      ? undefined
      : movement.refusals.reduce<Movement["refusals"][number] | undefined>(
          (best, next) => (best === undefined || next.distance < best.distance ? next : best),
          undefined,
        )
    const doubt = movement.accepted ? this.doubtAboutCandidate(movement) : undefined
    if (doubt !== undefined)
      this.host.refusal.tell(doubt, this.moved, event instanceof PointerEvent ? event : undefined)
    else if (nearest === undefined) this.host.refusal.hide()
    else this.host.refusal.show(nearest.why, this.moved, event instanceof PointerEvent ? event : undefined)
  }

  /// Why only GHC knows whether the connection that would be made now compiles.
  private doubtAboutCandidate(movement: Movement): string | undefined {
    // Blockly's own field has no other access.
    const {connectionCandidate: candidate} = this as unknown as {
      readonly connectionCandidate: {
        readonly local: Blockly.Connection
        readonly neighbour: Blockly.Connection
      } | null
    }
    if (candidate === null || candidate.neighbour.isSuperior() === candidate.local.isSuperior())
      return undefined
    const [socket, plug] = candidate.neighbour.isSuperior()
      ? [candidate.neighbour, candidate.local]
      : [candidate.local, candidate.neighbour]
    const verdict = movement.verdict(placeOf(socket), plug.getSourceBlock().id)
    return verdict.fits ? verdict.doubt : undefined
  }

  private aim(target: Target | undefined): void {
    if (this.target?.socket !== target?.socket) {
      this.target?.socket.unhighlight()
      target?.socket.highlight()
    }
    this.target = target
  }

  override endDrag(...[event, disposition]: Parameters<Blockly.dragging.BlockDragStrategy["endDrag"]>): void {
    this.host.refusal.hide()
    const {target} = this
    this.aim(undefined)
    const leaves =
      target !== undefined && disposition === Blockly.DragDisposition.COMMIT && !this.moved.isDeadOrDying()
    const isNew = brandNew.has(this.moved)
    brandNew.delete(this.moved)
    try {
      // A definition goes back to its place; a new one has none, and comes below the others. A step stays where it is dropped.
      const returns = leaves && target.holds === undefined
      if (returns && !isNew) super.revertDrag()
      super.endDrag(event, returns && !isNew ? Blockly.DragDisposition.REVERT : disposition)
      if (leaves) {
        // The movement knows only the blocks that were there when it began.
        endMovement(this.moved.workspace)
        if (returns && isNew) moveBelowOthers(this.moved)
        const made = insertReference(target.socket, target.block as Blockly.serialization.blocks.State)
        const stack = target.holds === undefined ? undefined : made.getInput(target.holds)?.connection
        if (stack != null && this.moved.previousConnection !== null)
          stack.connect(this.moved.previousConnection)
        if (isNew) arbitrateInProgram(this.moved, () => this.host.asker())
      } else if (disposition === Blockly.DragDisposition.COMMIT) {
        endMovement(this.moved.workspace)
        moveToFreePlace(this.moved, isNew)
        if (isNew) joinProgram(this.moved, () => this.host.asker())
      }
    } finally {
      endMovement(this.moved.workspace)
    }
  }

  override revertDrag(): void {
    try {
      super.revertDrag()
    } finally {
      // Blockly tells only of the beginning of a move by keys that is taken back, and the bin would stay.
      Blockly.Events.fire(new Blockly.Events.BlockDrag(this.moved, false))
      this.aim(undefined)
      this.host.refusal.hide()
      endMovement(this.moved.workspace)
    }
  }
}

/// Blocks that were made by the drag that moves them.
const brandNew = new WeakSet<Blockly.Block>()

function origin(block: Blockly.BlockSvg): Place | undefined {
  const above = block.outputConnection?.targetConnection ?? block.previousConnection?.targetConnection
  return above == null ? undefined : placeOf(above)
}

/// Gives up what a hand has under way, since the blocks in it are about to be replaced: a block that moves goes back to
/// where it was, and an open field or menu closes.
export function cancelMovement(workspace: Blockly.WorkspaceSvg): void {
  const mover = Blockly.KeyboardMover.mover
  if (mover.isMoving()) mover.abortMove()
  if (workspace.isDragging()) workspace.cancelCurrentGesture()
  endMovement(workspace)
  Blockly.WidgetDiv.hideIfOwnerIsInWorkspace(workspace)
}

/// Makes a block move our way.
export function makeDraggable(block: Blockly.BlockSvg, host: DragHost): void {
  block.setDragStrategy(new RosyDragStrategy(block, host))
}

/// Pixels between the pointer and the line, so that neither hand nor block covers it.
const away = {x: 18, y: 26}

export class RefusalMessage {
  private readonly host: HTMLElement
  private readonly line: HTMLElement
  private said = ""
  private leaning: Blockly.BlockSvg | undefined

  constructor(host: HTMLElement) {
    this.host = host
    this.line = document.createElement("div")
    this.line.className = "rosyRefusal"
    // Blockly's live region speaks; this is for the eye.
    this.line.setAttribute("aria-hidden", "true")
    this.line.hidden = true
    host.append(this.line)
  }

  /// Shows `why` for the block that is being moved, at the pointer or else below the block, and that it is refused.
  show(why: string, block: Blockly.BlockSvg, pointer: PointerEvent | undefined): void {
    this.write(why, block, pointer)
    // The block leans around its own corner; Blockly moves it with a transform, which CSS turns after rotating.
    const corner = block.getRelativeToSurfaceXY()
    block.getSvgRoot().style.transformOrigin = `${corner.x}px ${corner.y}px`
    if (this.leaning !== block) {
      this.straighten()
      block.addClass("rosyRefused")
      this.leaning = block
    }
  }

  /// Shows a sentence about a block that may go where it is held.
  tell(sentence: string, block: Blockly.BlockSvg, pointer: PointerEvent | undefined): void {
    this.straighten()
    this.write(sentence, block, pointer)
  }

  private write(why: string, block: Blockly.BlockSvg, pointer: PointerEvent | undefined): void {
    if (why !== this.said) {
      this.said = why
      this.line.replaceChildren(...withInlineCode(why))
      Blockly.utils.aria.announceDynamicAriaState(why.replaceAll("`", ""))
    }
    this.line.hidden = false
    const frame = this.host.getBoundingClientRect()
    const at = pointer ?? below(block)
    const x = at.clientX - frame.left + away.x
    const y = at.clientY - frame.top + away.y
    this.line.style.left = `${Math.max(8, Math.min(x, frame.width - this.line.offsetWidth - 8))}px`
    this.line.style.top = `${Math.max(8, Math.min(y, frame.height - this.line.offsetHeight - 8))}px`
  }

  hide(): void {
    this.said = ""
    this.line.hidden = true
    this.straighten()
  }

  private straighten(): void {
    this.leaning?.removeClass("rosyRefused")
    this.leaning = undefined
  }

  dispose(): void {
    this.hide()
    this.line.remove()
  }
}

function below(block: Blockly.BlockSvg): {clientX: number; clientY: number} {
  const box = block.getSvgRoot().getBoundingClientRect()
  return {clientX: box.left, clientY: box.bottom - away.y}
}

/// Words in backquotes are code.
function withInlineCode(sentence: string): Node[] {
  return sentence.split("`").map((part, at) => {
    if (at % 2 === 0) return document.createTextNode(part)
    const code = document.createElement("code")
    code.textContent = part
    return code
  })
}

/// Takes a reference out of its binder and puts it under the pointer, which goes on dragging it.
///
/// One frame later: on the press Blockly asked for the pressed block to be brought to the front, which would take
/// the focus from the new block, and Blockly drags the focused block.
export function dragReferenceFromBinder(
  workspace: Blockly.WorkspaceSvg,
  field: BinderField,
  event: PointerEvent,
): void {
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
