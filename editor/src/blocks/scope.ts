/// The place that the learner has chosen, and what can be used there.

import {
  type Family,
  type InScope,
  type Place,
  type SavedWorkspace,
  type Session,
  socketKey,
  type ToolboxCategory,
  type ToolboxItem,
} from "@rosy/codegen"
import * as Blockly from "blockly/core"
import {words} from "../words/index.ts"
import {placeOf} from "./checker.ts"
import {flyoutBlock} from "./toolbox.ts"

/// The chosen place: the first of `chosenPlaces`.
export function chosenPlace(workspace: Blockly.WorkspaceSvg): Place | undefined {
  return chosenPlaces(workspace)[0]
}

/// Where something new may go, best first: the socket with the focus; or else the empty sockets of the chosen block and
/// below it; or else the place that the block itself is in. Opening the toolbox takes the focus away, but Blockly marks
/// where it came from.
export function chosenPlaces(workspace: Blockly.WorkspaceSvg): readonly Place[] {
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
export function chosenBlock(workspace: Blockly.WorkspaceSvg): Blockly.Block | undefined {
  const node = chosenNode(workspace)
  return node instanceof Blockly.BlockSvg ? node : undefined
}

function chosenNode(workspace: Blockly.WorkspaceSvg): Blockly.IFocusableNode | null {
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
  const all = workspace.getTopBlocks(true).flatMap(block => [...asRead(block)])
  const node = chosenNode(workspace)
  const at = all.findIndex(one => one === node)
  const turned = [...all.slice(at + 1), ...all.slice(0, at + 1)]
  if (back) turned.reverse()
  return turned.find(
    (one): one is Blockly.RenderedConnection =>
      one instanceof Blockly.RenderedConnection && one.targetBlock() === null && one.canBeFocused(),
  )
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

/// Names and ready blocks that fit at a place: first the names, those that run already behind the others, then what is of the family that the socket wants.
export function suggest(
  session: Session,
  workspace: SavedWorkspace,
  place: Place,
  categories: readonly ToolboxCategory[],
): readonly ToolboxItem[] {
  const fitting = session.namesInScope(workspace, place).filter(name => name.fits)
  const running = "block" in place ? namesThatRun(workspace, place.block) : []
  const names = [
    ...fitting.filter(({name}) => !running.includes(name)),
    ...fitting.filter(({name}) => running.includes(name)),
  ]
  const wanted: Family | undefined =
    "below" in place
      ? "task"
      : session.infer(workspace).sockets.get(socketKey(place.block, place.input))?.family
  const ordered = [
    ...categories.filter(category => category.family === wanted),
    ...categories.filter(category => category.family !== wanted),
  ]
  const check = session.checker(workspace)
  const found: ToolboxItem[] = names.map(nameItem)
  const seen = new Set<string>()
  for (const item of ordered.flatMap(category => category.items)) {
    if (found.length >= mostSuggestions) break
    const key = JSON.stringify(item.block)
    if (seen.has(key)) continue
    seen.add(key)
    if (check.fits(place, item.block).fits) found.push(item)
  }
  return found
}

/// The names in the sockets of `simulate`, if that is the block.
function namesThatRun(workspace: SavedWorkspace, block: string): readonly unknown[] {
  const main = workspace.blocks.blocks.find(({id, type}) => id === block && type === "main")
  return Object.values(main?.inputs ?? {}).map(({block}) => block?.extraState?.name)
}

export function nameItem(name: InScope): ToolboxItem {
  return {label: name.name, block: name.block}
}
