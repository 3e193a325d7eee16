/// What `simulate` runs: new definitions and steps join it by themselves, and come out of it with one action.
///
/// A definition leaves a reference in the first empty place, or in one more. A step goes below the last step of the task that runs, or becomes a task in such a
/// place. A reaction goes before what would override it. Codegen's verdicts decide; where it refuses, nothing changes.

import type {Reference} from "@rosy/codegen"
import * as Blockly from "blockly/core"
import {shapeOf} from "../construction/block_definitions.ts"
import {ButtonField} from "../construction/fields.ts"
import type {FitChecker} from "./connection_checker.ts"
import {insertReference} from "./reference_drop.ts"

/// Lets a reaction go before what overrides it at every firing, where a new definition in `simulate` is one of the two: it would never be seen.
export function arbitrateInProgram(definition: Blockly.BlockSvg, ask: () => FitChecker): void {
  const program = programOf(definition.workspace)
  if (program === undefined) return
  // Each turn joins two places.
  for (let left = placesOf(program).length; left > 1; left--) {
    const found = ask().overriddenReaction(definition.id)
    const [first, second] = [found?.reaction, found?.driver].map(name =>
      placesOf(program).find(place => isNamedIn(place.targetBlock(), name)),
    )
    const [reaction, driver] = [first?.targetBlock(), second?.targetBlock()]
    if (found === undefined || second === undefined || reaction == null || driver == null || first === second)
      return
    reaction.outputConnection?.disconnect()
    driver.outputConnection?.disconnect()
    const made = insertReference(second, found.priority as Blockly.serialization.blocks.State)
    for (const [input, block] of [
      ["A", reaction],
      ["B", driver],
    ] as const) {
      const socket = made.getInput(input)?.connection
      if (block.outputConnection !== null) socket?.connect(block.outputConnection)
    }
    closeGap(program)
  }
}

const isNamedIn = (inside: Blockly.Block | null, name: string | undefined): boolean =>
  namesIn(inside).some(block => nameOf(block) === name)

/// The names that a place of `simulate` runs: its own, or those on the sides of a `priority`.
function namesIn(inside: Blockly.Block | null): readonly Blockly.Block[] {
  if (inside?.type === "name") return [inside]
  if (inside?.type !== "priority") return []
  return ["A", "B"].flatMap(side => namesIn(inside.getInputTargetBlock(side)))
}

/// Places of `simulate`, in their order.
const placesOf = (program: Blockly.Block): readonly Blockly.RenderedConnection[] =>
  program.inputList.flatMap(({connection}) =>
    connection instanceof Blockly.RenderedConnection ? [connection] : [],
  )

export function programOf(workspace: Blockly.Workspace): Blockly.Block | undefined {
  return workspace.getTopBlocks(true).find(({type}) => type === "main")
}

/// Has `simulate` run a new definition or step that is in no other block. A plain function is a helper of others and does not join. One step of undo with what the event group
/// holds already. Answers whether it runs now.
export function joinProgram(block: Blockly.BlockSvg, ask: () => FitChecker): boolean {
  const as = shapeOf(block)?.connects.as
  const reacts = as === "definition" && nameOf(block) !== undefined && !isPlain(block)
  if (reacts || as === "step") return runInProgram(block, ask)
  return false
}

/// Has `simulate` run a definition or step that is in no other block, a plain function as well.
export function runInProgram(block: Blockly.BlockSvg, ask: () => FitChecker): boolean {
  const program = programOf(block.workspace)
  if (program === undefined || block.isDeadOrDying() || block.getParent() !== null) return false
  if (block.previousConnection !== null && connectBelowLastStep(program, block, ask())) return true
  const [first] = placesOf(program)
  if (first === undefined) return false
  // The places of `simulate` take the same blocks: none is made for a block that is refused.
  const reference = ask().referenceTo(placeIn(program, first), block.id)
  if (!reference.fits) return false
  const place = emptyPlace(program) ?? onePlaceMore(program)
  if (place === undefined) return false
  refer(place, reference, block)
  arbitrateInProgram(block, ask)
  return true
}

/// An empty place of `simulate`, a new one when all are filled; `undefined` where there can be no more.
export function placeToRun(program: Blockly.Block): Blockly.RenderedConnection | undefined {
  return emptyPlace(program) ?? onePlaceMore(program)
}

/// The definition that a block is or is in, or that it names in `simulate`.
export function definitionAround(block: Blockly.Block): Blockly.BlockSvg | undefined {
  const root = block.getRootBlock()
  const found =
    root.type === "main"
      ? block.workspace.getTopBlocks(true).find(top => top.type === "define" && nameOf(top) === nameOf(block))
      : root
  return found instanceof Blockly.BlockSvg && found.type === "define" ? found : undefined
}

/// Whether `simulate` could run a definition.
export function canRunInProgram(definition: Blockly.Block, check: FitChecker): boolean {
  const program = programOf(definition.workspace)
  const [place] = program === undefined ? [] : placesOf(program)
  return (
    program !== undefined &&
    place !== undefined &&
    check.referenceTo(placeIn(program, place), definition.id).fits
  )
}

/// Whether `simulate` runs a definition by its name.
export function runsInProgram(definition: Blockly.Block): boolean {
  return referencesTo(definition).length > 0
}

/// Takes a definition out of `simulate`, with the places that it had there; one stays. The definition stays where it is.
export function leaveProgram(definition: Blockly.Block): void {
  const program = programOf(definition.workspace)
  if (program === undefined) return
  for (const reference of referencesTo(definition)) {
    if (reference.getParent()?.type === "priority") endPriority(reference)
    else {
      reference.dispose(false)
      closeGap(program)
    }
  }
}

/// Takes a side out of a `priority`, whose place the other side gets.
function endPriority(side: Blockly.Block): void {
  const around = side.getParent()
  const place = around?.outputConnection?.targetConnection
  side.dispose(false)
  const other = ["A", "B"].flatMap(name => around?.getInputTargetBlock(name) ?? [])[0]
  other?.outputConnection?.disconnect()
  around?.dispose(false)
  if (other?.outputConnection) place?.connect(other.outputConnection)
}

function referencesTo(definition: Blockly.Block): readonly Blockly.Block[] {
  const program = programOf(definition.workspace)
  const name = nameOf(definition)
  if (program === undefined || name === undefined) return []
  return placesOf(program)
    .flatMap(place => namesIn(place.targetBlock()))
    .filter(inside => nameOf(inside) === name)
}

/// Moves what stands behind the first empty place one place to the front, and removes the last place if there are several.
function closeGap(program: Blockly.Block): void {
  const places = placesOf(program)
  const gap = places.findIndex(place => place.targetBlock() === null)
  for (let at = gap; at < places.length - 1; at++) {
    const moved = places[at + 1]?.targetBlock()?.outputConnection
    moved?.disconnect()
    if (moved != null) places[at]?.connect(moved)
  }
  press(program, "fewer")
}

function emptyPlace(program: Blockly.Block): Blockly.RenderedConnection | undefined {
  return placesOf(program).find(place => place.targetBlock() === null)
}

function onePlaceMore(program: Blockly.Block): Blockly.RenderedConnection | undefined {
  press(program, "more")
  return emptyPlace(program)
}

function press(program: Blockly.Block, action: string): void {
  const button = [...program.getFields()].find(
    field => field instanceof ButtonField && field.action === action,
  )
  button?.showEditor()
}

function refer(
  place: Blockly.RenderedConnection,
  reference: Extract<Reference, {fits: true}>,
  block: Blockly.BlockSvg,
): void {
  const made = insertReference(place, reference.block as Blockly.serialization.blocks.State)
  const stack = reference.holds === undefined ? undefined : made.getInput(reference.holds)?.connection
  if (stack != null && block.previousConnection !== null) stack.connect(block.previousConnection)
}

/// Connects a step below the last step of the task that `simulate` runs; of a loop without an end, inside of it.
function connectBelowLastStep(program: Blockly.Block, step: Blockly.BlockSvg, check: FitChecker): boolean {
  const task = placesOf(program)
    .map(place => place.targetBlock())
    .find(inside => inside?.type === "do")
  let below = task?.getInput("S")?.connection
  for (let last = below?.targetBlock(); last != null; last = below?.targetBlock()) {
    const end = last.type === "step_forever" ? last.getInput("S")?.connection : last.nextConnection
    below = end
  }
  if (below == null || step.previousConnection === null) return false
  const input = below.getParentInput()
  const owner = below.getSourceBlock().id
  const place = input === null ? {below: owner} : {block: owner, input: input.name}
  if (!check.fits(place, step.id).fits) return false
  below.connect(step.previousConnection)
  return true
}

const placeIn = (program: Blockly.Block, place: Blockly.Connection) => ({
  block: program.id,
  input: place.getParentInput()?.name ?? "",
})

interface ExtraState {
  readonly name?: unknown
  readonly as?: unknown
}

const extraOf = (block: Blockly.Block): ExtraState => (block.saveExtraState?.() ?? {}) as ExtraState

function nameOf(block: Blockly.Block): string | undefined {
  const {name} = extraOf(block)
  return typeof name === "string" && name !== "" ? name : undefined
}

const isPlain = (block: Blockly.Block): boolean => (extraOf(block).as ?? "plain") === "plain"
