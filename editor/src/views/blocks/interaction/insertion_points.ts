/// Insertion points: the selected place, the names in scope there, and suggestions that fit.

import {
  asTask,
  type Checker,
  type Family,
  type InScope,
  type Place,
  type SavedBlock,
  type SavedWorkspace,
  type Session,
  socketKey,
  type ToolboxCategory,
  type ToolboxItem,
} from "@rosy/codegen"
import * as Blockly from "blockly/core"
import {words} from "../../../words/index.ts"
import {isNumberField} from "../construction/text_fields.ts"
import {placeOf} from "../dragging/connection_checker.ts"
import {flyoutBlock} from "./toolbox.ts"

/// The chosen place: the first of `chosenPlaces`.
export function selectedPlace(workspace: Blockly.WorkspaceSvg): Place | undefined {
  return selectedPlaces(workspace)[0]
}

/// Where something new may go, best first: the socket with the focus; or else the empty sockets of the chosen block and
/// below it; or else the place that the block itself is in. Opening the toolbox takes the focus away, but Blockly marks
/// where it came from.
export function selectedPlaces(workspace: Blockly.WorkspaceSvg): readonly Place[] {
  const node = chosenNode(workspace)
  if (node instanceof Blockly.RenderedConnection) return [placeOf(node)]
  const block = node instanceof Blockly.Field ? node.getSourceBlock() : node
  if (!(block instanceof Blockly.BlockSvg)) return []
  const places = block.inputList.flatMap(({connection}) =>
    connection !== null && connection.targetBlock() === null ? [placeOf(connection)] : [],
  )
  // A step is followed by another, and so is a definition inside one.
  const stacked = block.nextConnection?.getCheck()
  const inside = block.getSurroundParent() !== null
  if (
    block.nextConnection !== null &&
    (stacked?.includes("step") || (stacked?.includes("definition") && inside))
  ) {
    places.push(placeOf(block.nextConnection))
  }
  if (places.length > 0) return places
  const above = block.outputConnection?.targetConnection
  return above == null ? [] : [placeOf(above)]
}

/// The block with the focus, or the one that had it before the toolbox.
export function selectedBlock(workspace: Blockly.WorkspaceSvg): Blockly.Block | undefined {
  const node = chosenNode(workspace)
  return node instanceof Blockly.BlockSvg ? node : undefined
}

/// What is chosen on the workspace, also while the focus is in the toolbox.
export function chosenNode(workspace: Blockly.WorkspaceSvg): Blockly.IFocusableNode | null {
  const marked = workspace
    .getSvgGroup()
    .querySelector(
      `.${Blockly.FocusManager.PASSIVE_FOCUS_NODE_CSS_CLASS_NAME}, .${Blockly.FocusManager.ACTIVE_FOCUS_NODE_CSS_CLASS_NAME}`,
    )
  return marked?.id ? workspace.lookUpFocusableNode(marked.id) : null
}

/// The next place that is empty, as one reads: after what has the focus, then in the other stacks, and from the
/// beginning again. `back`: the one before.
export function nextEmpty(
  workspace: Blockly.WorkspaceSvg,
  back = false,
): Blockly.RenderedConnection | undefined {
  return onward(workspace, back).find(
    (one): one is Blockly.RenderedConnection =>
      one instanceof Blockly.RenderedConnection && one.targetBlock() === null && one.canBeFocused(),
  )
}

/// The next number that can be changed, in the same order: its field, or the block that is nothing else.
export function nextNumber(
  workspace: Blockly.WorkspaceSvg,
  back = false,
): Blockly.Field | Blockly.BlockSvg | undefined {
  const node = chosenNode(workspace)
  return onward(workspace, back)
    .filter((one): one is Blockly.Field => isNumberField(one) && one.isClickable())
    .map(field => {
      const block = field.getSourceBlock()
      return field.isFullBlockField() && block instanceof Blockly.BlockSvg ? block : field
    })
    .find(target => target !== node)
}

/// The number that has the focus: a field, or the field of a block that is nothing else.
export function focusedNumber(node: Blockly.IFocusableNode | undefined): Blockly.Field | undefined {
  const fields: readonly unknown[] =
    node instanceof Blockly.BlockSvg && !node.isInFlyout ? [...node.getFields()] : [node]
  return fields.find(
    (field): field is Blockly.Field =>
      isNumberField(field) && field.isClickable() && (field === node || field.isFullBlockField()),
  )
}

/// All focusable parts of the blocks in reading order, starting after the focused one and wrapping around; in reverse order with `back`.
function onward(
  workspace: Blockly.WorkspaceSvg,
  back: boolean,
): readonly (Blockly.Block | Blockly.Field | Blockly.Connection)[] {
  const all = workspace.getTopBlocks(true).flatMap(block => [...asRead(block)])
  const node = chosenNode(workspace)
  const at = all.findIndex(one => one === node)
  const turned = [...all.slice(at + 1), ...all.slice(0, at + 1)]
  return back ? turned.reverse() : turned
}

/// A block, its fields and places, and what it carries.
function* asRead(block: Blockly.Block): Generator<Blockly.Block | Blockly.Field | Blockly.Connection> {
  yield block
  for (const input of block.inputList) {
    yield* input.fieldRow
    if (input.connection === null) continue
    yield input.connection
    const inside = input.connection.targetBlock()
    if (inside !== null) yield* asRead(inside)
  }
  const next = block.getNextBlock()
  if (next !== null) yield* asRead(next)
}

/// The flyout's contents for the names at a place; those whose type fits come first.
export function scopeItems(names: readonly InScope[] | undefined): Blockly.utils.toolbox.FlyoutItemInfoArray {
  const label = (text: string) => ({kind: "label", text})
  const items: object[] = []
  if (names === undefined) items.push(label(words.blocks.chooseFirst))
  else if (names.length === 0) items.push(label(words.blocks.noNames))
  else {
    const fitting = names.filter(name => name.fits)
    const others = names.filter(name => !name.fits)
    items.push(...fitting.map(flyoutBlock))
    if (others.length > 0) items.push(label(words.blocks.otherNames), ...others.map(flyoutBlock))
  }
  return items as unknown as Blockly.utils.toolbox.FlyoutItemInfoArray
}

/// More than this is a list to read, not an answer.
const mostSuggestions = 14

/// Names and ready blocks that fit at a place: first the names, those that run already behind the others, then what is of the family that the socket wants. For
/// `simulate` the ready-made pieces come next, definitions too: steps first where the level begins with tasks. The definition that the place is in comes after
/// them: to call itself is seldom meant. Last is a new own type, where its constructor fits.
export function suggest(
  session: Session,
  workspace: SavedWorkspace,
  place: Place,
  categories: readonly ToolboxCategory[],
): readonly ToolboxItem[] {
  const fitting = session.namesInScope(workspace, place).filter(name => name.fits)
  const running = "block" in place ? namesThatRun(workspace, place.block) : []
  const around = definitionAround(workspace, "block" in place ? place.block : place.below)
  const others = fitting.filter(({name}) => name !== around)
  const names = [
    ...others.filter(({name}) => !running.includes(name)),
    ...others.filter(({name}) => running.includes(name)),
  ]
  const wanted: Family | undefined =
    "below" in place
      ? "task"
      : session.infer(workspace).sockets.get(socketKey(place.block, place.input))?.family
  // "own" is the family of a socket that takes many types: it says nothing about what is wanted.
  const preferred = wanted === "own" ? undefined : wanted
  const ordered = [
    ...categories.filter(category => category.family === preferred),
    ...categories.filter(category => category.family !== preferred),
  ]
  const check = session.checker(workspace)
  const found: ToolboxItem[] = names.map(nameItem)
  const seen = new Set<string>()
  for (const item of runnable(check, workspace, place, categories)) {
    if (found.length >= mostRunnable) break
    const isFitting =
      asTask(item.block) === undefined
        ? session.referenceTo(workspace, place, item.block).fits
        : takes(check, place, item.block)
    if (isFitting && !isDefined(workspace, item)) found.push(item)
    seen.add(JSON.stringify(item.block))
  }
  for (const item of ordered.flatMap(category => category.items)) {
    if (found.length >= mostSuggestions) break
    const key = JSON.stringify(item.block)
    if (seen.has(key)) continue
    seen.add(key)
    if (takes(check, place, item.block)) found.push(item)
  }
  found.push(...fitting.filter(({name}) => name === around).map(nameItem))
  const ownType = ordered
    .flatMap(category => category.items)
    .find(item => item.block.type === "data" && session.referenceTo(workspace, place, item.block).fits)
  return ownType === undefined || isDefined(workspace, ownType) ? found : [...found, ownType]
}

/// Of these, how many are offered for `simulate` before other blocks.
const mostRunnable = 10

/// The ready-made pieces of the first category for a socket of `simulate`; its steps, where a step goes.
function runnable(
  check: Checker,
  workspace: SavedWorkspace,
  place: Place,
  [first]: readonly ToolboxCategory[],
): readonly ToolboxItem[] {
  if (first === undefined) return []
  const isMain =
    "block" in place && workspace.blocks.blocks.some(b => b.id === place.block && b.type === "main")
  const steps = first.items.filter(item => asTask(item.block) !== undefined)
  if (!isMain) return steps.filter(item => check.fits(place, item.block).fits)
  const all = first.items.filter(item => item.block.type === "define")
  // What moves the robot by itself comes before what reacts.
  const isDriver = ({block}: ToolboxItem) => block.extraState?.as === "command"
  const definitions = [...all.filter(isDriver), ...all.filter(item => !isDriver(item))]
  return first.family === "task" ? [...steps, ...definitions] : [...definitions, ...steps]
}

function isDefined(workspace: SavedWorkspace, {block}: ToolboxItem): boolean {
  const name = block.extraState?.name
  return (
    (block.type === "define" || block.type === "data") &&
    workspace.blocks.blocks.some(b => b.extraState?.name === name)
  )
}

/// The name of the definition on the canvas that a block is part of.
function definitionAround(workspace: SavedWorkspace, id: string): unknown {
  return workspace.blocks.blocks.find(block => isPartOf(block, id))?.extraState?.name
}

function isPartOf(block: SavedBlock, id: string): boolean {
  const parts = [...Object.values(block.inputs ?? {}), ...(block.next === undefined ? [] : [block.next])]
  return block.id === id || parts.some(part => part.block !== undefined && isPartOf(part.block, id))
}

/// Whether a block fits at a place, as it is or as the only step of a task.
export function takes(check: Checker, place: Place, block: SavedBlock): boolean {
  const task = asTask(block)
  return check.fits(place, block).fits || (task !== undefined && check.fits(place, task).fits)
}

/// The names in the sockets of `simulate`, if that is the block.
function namesThatRun(workspace: SavedWorkspace, block: string): readonly unknown[] {
  const main = workspace.blocks.blocks.find(({id, type}) => id === block && type === "main")
  return Object.values(main?.inputs ?? {}).map(({block}) => block?.extraState?.name)
}

export function nameItem(name: InScope): ToolboxItem {
  return {label: name.name, block: name.block}
}
