/// Connection checker: blocks connect only where codegen accepts them.
///
/// Types are checked only while the learner moves a block: loading, undo and paste restore any state, and problems in it are shown afterwards. At other times only the
/// sort is checked (an expression is not a pattern), which Blockly needs in order to connect at all.

import type {BlockId, OverriddenReaction, Place, Reference, Verdict} from "@rosy/codegen"
import * as Blockly from "blockly/core"

/// The name to give to `Blockly.inject` under `plugins.connectionChecker`.
export const checkerName = "rosy"

/// Answers for one movement of one block.
export interface FitChecker {
  /// May `block` go to `place`, as codegen sees it?
  fits(place: Place, block: BlockId): Verdict
  /// The reference to the definition `block` that may go to `place`.
  referenceTo(place: Place, block: BlockId): Reference
  /// The reaction that the definition `block` overrides in `simulate`, or is.
  overriddenReaction(block: BlockId): OverriddenReaction | undefined
}

/// A socket that said no, and how far away it was, in workspace units.
export interface Refusal {
  readonly why: string
  readonly distance: number
  readonly socket: Blockly.Connection
}

/// One movement. Verdicts are remembered: a drag asks the same again with every move of the pointer.
export class Movement {
  /// Whether some socket in reach accepted, and those that refused, since `step`.
  accepted = false
  refusals: Refusal[] = []
  /// For the keys, which step from place to place: filled sockets are passed over, but for that of this block, so
  /// that a step leads to where something is missing and picking a block up does not ask about every socket there is.
  readonly steps: {readonly over: Blockly.Block | undefined} | undefined
  private readonly asker: FitChecker
  private readonly origin: string | undefined
  private readonly verdicts = new Map<string, Verdict>()
  private readonly references = new Map<string, Reference>()

  /// `origin` is the place that the block is taken from: it may always go back, even if it never fitted.
  constructor(asker: FitChecker, origin: Place | undefined, steps?: Movement["steps"]) {
    this.asker = asker
    this.steps = steps
    this.origin = origin === undefined ? undefined : placeKey(origin)
  }

  step(): void {
    this.accepted = false
    this.refusals = []
  }

  verdict(place: Place, block: BlockId): Verdict {
    const at = placeKey(place)
    if (at === this.origin) return {fits: true}
    const key = `${at}<${block}`
    let verdict = this.verdicts.get(key)
    if (verdict === undefined) {
      verdict = this.asker.fits(place, block)
      this.verdicts.set(key, verdict)
    }
    return verdict
  }

  referenceTo(place: Place, block: BlockId): Reference {
    const key = `${placeKey(place)}<${block}`
    const known = this.references.get(key) ?? this.asker.referenceTo(place, block)
    this.references.set(key, known)
    return known
  }
}

const placeKey = (place: Place) => ("below" in place ? `${place.below}|` : `${place.block}/${place.input}`)

const movements = new WeakMap<Blockly.Workspace, Movement>()

export function beginMovement(workspace: Blockly.Workspace, movement: Movement): void {
  movements.set(workspace, movement)
}

export function endMovement(workspace: Blockly.Workspace): void {
  movements.delete(workspace)
}

export function movementIn(workspace: Blockly.Workspace): Movement | undefined {
  return movements.get(workspace)
}

/// The place that a socket, or the underside of a stacked block, is in codegen's words.
export function placeOf(connection: Blockly.Connection): Place {
  const block = connection.getSourceBlock().id
  const input = connection.getParentInput()
  return input === null ? {below: block} : {block, input: input.name}
}

/// Pixels: a refusal is told when the socket is this near. Nearer than Blockly's snapping radius (48), so that
/// sockets that a block only passes by stay silent.
const refusalReach = 30

class Checker extends Blockly.ConnectionChecker {
  override canConnectWithReason(
    a: Blockly.Connection | null,
    b: Blockly.Connection | null,
    isDragging: boolean,
    distance = 0,
  ): number {
    const safety = this.doSafetyChecks(a, b)
    if (safety !== Blockly.Connection.CAN_CONNECT || a === null || b === null) return safety
    // Distance first: it is free, and types are not.
    if (
      isDragging &&
      !this.doDragChecks(a as Blockly.RenderedConnection, b as Blockly.RenderedConnection, distance)
    ) {
      return Blockly.Connection.REASON_DRAG_CHECKS_FAILED
    }
    const movement = movements.get(a.getSourceBlock().workspace)
    const sorted = super.doTypeChecks(a, b)
    const [socket, plug] = a.isSuperior() ? [a, b] : [b, a]
    if (movement !== undefined && distance === Number.POSITIVE_INFINITY && passedOver(socket, movement)) {
      return Blockly.Connection.REASON_DRAG_CHECKS_FAILED
    }
    const marker = a.getSourceBlock().isInsertionMarker() || b.getSourceBlock().isInsertionMarker()
    if (movement === undefined || marker) {
      return sorted ? Blockly.Connection.CAN_CONNECT : Blockly.Connection.REASON_CHECKS_FAILED
    }
    if (standsAlone(socket)) return Blockly.Connection.REASON_CHECKS_FAILED
    const near = isDragging && Number.isFinite(distance) ? gap(a, b) : Number.POSITIVE_INFINITY
    // The sentence of a refusal is computed only when it will be shown.
    if (!sorted && near > refusalReach) return Blockly.Connection.REASON_CHECKS_FAILED
    const verdict = movement.verdict(placeOf(socket), plug.getSourceBlock().id)
    if (verdict.fits && sorted) {
      movement.accepted = true
      return Blockly.Connection.CAN_CONNECT
    }
    if (!verdict.fits && near <= refusalReach) {
      movement.refusals.push({why: verdict.why, distance: near, socket})
    }
    return Blockly.Connection.REASON_CHECKS_FAILED
  }

  override doTypeChecks(a: Blockly.Connection, b: Blockly.Connection): boolean {
    const movement = movements.get(a.getSourceBlock().workspace)
    if (!super.doTypeChecks(a, b)) return false
    if (movement === undefined) return true
    const [socket, plug] = a.isSuperior() ? [a, b] : [b, a]
    if (standsAlone(socket)) return false
    return movement.verdict(placeOf(socket), plug.getSourceBlock().id).fits
  }
}

function passedOver(socket: Blockly.Connection, movement: Movement): boolean {
  if (movement.steps === undefined || socket.type !== Blockly.ConnectionType.INPUT_VALUE) return false
  const inside = socket.targetBlock()
  return inside !== null && !inside.isInsertionMarker() && inside !== movement.steps.over
}

/// Definitions stack in `where` and `let` only: on the workspace each stands alone.
function standsAlone(socket: Blockly.Connection): boolean {
  return (
    socket.getParentInput() === null &&
    (socket.getCheck()?.includes("definition") ?? false) &&
    socket.getSourceBlock().getSurroundParent() === null
  )
}

function gap(a: Blockly.Connection, b: Blockly.Connection): number {
  return (a as Blockly.RenderedConnection).distanceFrom(b as Blockly.RenderedConnection)
}

/// Tells Blockly about the checker; once for the page.
export function registerChecker(): void {
  Blockly.registry.register(Blockly.registry.Type.CONNECTION_CHECKER, checkerName, Checker, true)
}
