/// Placement of top-level blocks: inserting a block at the selected place or below the others, spacing after a block grew, and strays outside of the visible area.

import {asTask, type BlockId, type Checker, type Place, type Reference, type SavedBlock} from "@rosy/codegen"
import * as Blockly from "blockly/core"

import {shapeOf} from "../construction/block_definitions.ts"
import {giveUniqueNames} from "../construction/unique_names.ts"
import {beginMovement, endMovement, type FitChecker, Movement} from "./connection_checker.ts"
import {type Box, nearestFreePlace, shiftIntoView} from "./free_place.ts"
import {arbitrateInProgram, joinProgram} from "./program_membership.ts"
import {insertReference} from "./reference_drop.ts"

/// Pixels from the corner of an empty workspace, and between blocks, where a new one comes that is not placed by hand.
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

/// Moves a definition that was dropped on other blocks to the nearest place where it covers none. One from the drawer, which leaves little
/// room to drop anything, first comes into view as far as it fits.
export function moveToFreePlace(block: Blockly.BlockSvg, isNew: boolean): void {
  const as = shapeOf(block)?.connects.as
  if (block.isDeadOrDying() || block.getParent() !== null || (as !== "definition" && as !== "top")) return
  Blockly.renderManagement.triggerQueuedRenders(block.workspace)
  if (isNew) {
    const view = block.workspace.getMetricsManager().getViewMetrics(true)
    const aside = shiftIntoView(block.getBoundingRectangle(), {
      left: view.left,
      right: view.left + view.width,
    })
    if (aside !== 0) block.moveBy(aside, 0, ["cleanup"])
  }
  const others = block.workspace.getTopBlocks(false).filter(other => other !== block)
  const {right, down} = nearestFreePlace(
    block.getBoundingRectangle(),
    others.map(other => other.getBoundingRectangle()),
  )
  if (right !== 0 || down !== 0) block.moveBy(right, down, ["cleanup"])
}

/// Puts a new block into the first of `places` that takes it, else below all others, and gives it the focus. One step
/// of undo. A step becomes a task of one step where a value goes. What was in the place goes into the new block if it fits there, and lies beside it if not. A new definition
/// leaves a reference in the first place, if that is an empty socket that takes one. `joins`: else it joins `simulate` where that is possible.
export function insertBlock(
  workspace: Blockly.WorkspaceSvg,
  wanted: SavedBlock,
  places: readonly Place[],
  ask: () => FitChecker & Checker,
  joins = false,
): void {
  const before = ask()
  const choices = [wanted, asTask(wanted)].flatMap(block =>
    block === undefined ? [] : places.map(place => ({place, block})),
  )
  const chosen = choices.find(({place, block}) => before.fits(place, block).fits)
  const place = chosen?.place
  Blockly.Events.setGroup(true)
  try {
    const block = Blockly.serialization.blocks.append(
      (chosen?.block ?? wanted) as Blockly.serialization.blocks.State,
      workspace,
      {recordUndo: true},
    ) as Blockly.BlockSvg
    Blockly.renderManagement.triggerQueuedRenders(workspace)
    const socket = place && socketAt(workspace, place)
    if (socket == null) {
      moveBelowOthers(block)
      giveUniqueNames(workspace, new Set([block.id]))
      if (referFrom(workspace, places[0], block.id, ask())) arbitrateInProgram(block, ask)
      else if (joins) joinProgram(block, ask)
    } else {
      beginMovement(workspace, new Movement(ask(), place))
      socket.connect((block.outputConnection ?? block.previousConnection)!)
      endMovement(workspace)
    }
    // Only what is drawn can have the focus.
    Blockly.renderManagement.triggerQueuedRenders(workspace)
    const held = chosen === undefined || chosen.block === wanted ? null : block.getInputTargetBlock("S")
    Blockly.getFocusManager().focusNode(held instanceof Blockly.BlockSvg ? held : block)
    workspace.scrollBoundsIntoView(block.getBoundingRectangleWithoutChildren())
  } finally {
    Blockly.Events.setGroup(false)
  }
}

/// Puts definitions below all others, in their order, as one step of undo. The first gets the focus.
export function insertDefinitions(workspace: Blockly.WorkspaceSvg, definitions: readonly SavedBlock[]): void {
  Blockly.Events.setGroup(true)
  try {
    const made = definitions.map(definition => {
      const block = Blockly.serialization.blocks.append(
        definition as Blockly.serialization.blocks.State,
        workspace,
        {recordUndo: true},
      ) as Blockly.BlockSvg
      Blockly.renderManagement.triggerQueuedRenders(workspace)
      moveBelowOthers(block)
      return block
    })
    const [first] = made
    if (first === undefined) return
    Blockly.renderManagement.triggerQueuedRenders(workspace)
    Blockly.getFocusManager().focusNode(first)
    workspace.scrollBoundsIntoView(first.getBoundingRectangleWithoutChildren())
  } finally {
    Blockly.Events.setGroup(false)
  }
}

function referFrom(
  workspace: Blockly.WorkspaceSvg,
  place: Place | undefined,
  block: BlockId,
  asker: FitChecker,
): boolean {
  const socket = place && socketAt(workspace, place)
  if (!(socket instanceof Blockly.RenderedConnection) || socket.targetBlock() !== null) return false
  const reference: Reference = asker.referenceTo(place!, block)
  if (reference.fits) insertReference(socket, reference.block as Blockly.serialization.blocks.State)
  return reference.fits
}

function socketAt(workspace: Blockly.WorkspaceSvg, place: Place): Blockly.Connection | null | undefined {
  return "below" in place
    ? workspace.getBlockById(place.below)?.nextConnection
    : workspace.getBlockById(place.block)?.getInput(place.input)?.connection
}

/// Workspace units between a block that grew and the one that made room.
const gap = 20
/// Nearer than this looks like one block.
const near = 8

/// How far each of the boxes `after` has to move down, by id, when those `before` have become them. Pure.
export function spacingMoves(
  before: ReadonlyMap<string, Box>,
  after: ReadonlyMap<string, Box>,
): ReadonlyMap<string, number> {
  const moves = new Map<string, number>()
  const now = new Map(after)
  const grown = [...after.keys()].filter(id => {
    const old = before.get(id)
    const box = after.get(id)!
    return old !== undefined && old.top === box.top && old.left === box.left && old.bottom < box.bottom
  })
  // A block that moves may cover the next one.
  for (const id of grown) {
    const mover = now.get(id)!
    const below = [...now.keys()]
      .filter(other => other !== id && now.get(other)!.top > mover.top)
      .sort((a, b) => now.get(a)!.top - now.get(b)!.top)
    const risen = [id]
    for (const other of below) {
      const box = now.get(other)!
      let needed = 0
      for (const one of risen) {
        const cover = now.get(one)!
        const old = before.get(one) ?? cover
        const was = before.get(other)
        if (
          !overlap({...cover, bottom: cover.bottom + near}, box) ||
          (was !== undefined && overlap(old, was))
        )
          continue
        needed = Math.max(needed, cover.bottom + gap - box.top)
      }
      if (needed === 0) continue
      now.set(other, {...box, top: box.top + needed, bottom: box.bottom + needed})
      moves.set(other, (moves.get(other) ?? 0) + needed)
      risen.push(other)
    }
  }
  return moves
}

function overlap(one: Box, other: Box): boolean {
  return one.left < other.right && other.left < one.right && one.top < other.bottom && other.top < one.bottom
}

/// Where the top-level blocks of a workspace are.
export function boxesOf(workspace: Blockly.WorkspaceSvg): ReadonlyMap<string, Box> {
  return new Map(workspace.getTopBlocks(false).map(block => [block.id, block.getBoundingRectangle()]))
}

export function isVisible(workspace: Blockly.WorkspaceSvg, block: Blockly.BlockSvg): boolean {
  const view = workspace.getMetricsManager().getViewMetrics(true)
  const box = block.getBoundingRectangle()
  return (
    box.left >= view.left &&
    box.top >= view.top &&
    box.left < view.left + view.width &&
    box.top < view.top + view.height
  )
}

/// Pixels between a stray that was brought home and the blocks it comes to.
const homeGap = 28

/// A stray is a top-level block that is further from the middle one than a learner would scroll.
export function straysOf(workspace: Blockly.WorkspaceSvg): readonly Blockly.BlockSvg[] {
  const tops = workspace.getTopBlocks(true)
  if (tops.length < 2) return []
  const view = workspace.getMetricsManager().getViewMetrics(true)
  const boxes = tops.map(block => block.getBoundingRectangle())
  const median = (values: number[]) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)]!
  const middle = {x: median(boxes.map(box => box.left)), y: median(boxes.map(box => box.top))}
  return tops.filter((_, at) => {
    const box = boxes[at]!
    return (
      Math.abs(box.left - middle.x) > view.width * 1.5 || Math.abs(box.top - middle.y) > view.height * 2.5
    )
  })
}

export function moveStraysBack(workspace: Blockly.WorkspaceSvg): void {
  const strays = straysOf(workspace)
  if (strays.length === 0) return
  const home = workspace.getTopBlocks(true).filter(block => !strays.includes(block))
  const boxes = home.map(block => block.getBoundingRectangle())
  let y = Math.max(...boxes.map(box => box.bottom)) + homeGap
  const x = Math.min(...boxes.map(box => box.left))
  Blockly.Events.setGroup(true)
  for (const block of strays) {
    const box = block.getBoundingRectangle()
    block.moveBy(x - box.left, y - box.top, ["cleanup"])
    y += box.getHeight() + homeGap
  }
  Blockly.Events.setGroup(false)
}
