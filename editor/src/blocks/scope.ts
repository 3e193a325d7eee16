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

/// The chosen place: the socket with the focus, the first empty socket of the chosen block, or the place the block
/// itself is in. Opening the toolbox takes the focus away, but Blockly marks where it came from.
export function chosenPlace(workspace: Blockly.WorkspaceSvg): Place | undefined {
  const node = chosenNode(workspace)
  if (node instanceof Blockly.RenderedConnection) return placeOf(node)
  const block = node instanceof Blockly.Field ? node.getSourceBlock() : node
  if (!(block instanceof Blockly.BlockSvg)) return undefined
  for (const input of block.inputList) {
    if (input.connection !== null && input.connection.targetBlock() === null) return placeOf(input.connection)
  }
  // A step is followed by another, and so is a definition inside one.
  const stacked = block.nextConnection?.getCheck()
  const inside = block.getSurroundParent() !== null
  if (
    block.nextConnection !== null &&
    (stacked?.includes("step") || (stacked?.includes("definition") && inside))
  ) {
    return placeOf(block.nextConnection)
  }
  const above = block.outputConnection?.targetConnection
  return above == null ? undefined : placeOf(above)
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

/// The next place that is empty, as one reads: after the one with the focus, and from the beginning again.
export function nextEmpty(workspace: Blockly.WorkspaceSvg): Blockly.RenderedConnection | undefined {
  const node = chosenNode(workspace)
  const from = node instanceof Blockly.BlockSvg ? node : ownerOf(node)
  const start = from === undefined ? [] : placesIn(from.getRootBlock() as Blockly.BlockSvg)
  const others = workspace.getTopBlocks(true).flatMap(block => placesIn(block))
  const all = [...start, ...others.filter(place => !start.includes(place))]
  const inside = node instanceof Blockly.RenderedConnection ? all.indexOf(node) + 1 : -1
  const after =
    inside > 0
      ? inside
      : from === undefined
        ? 0
        : Math.max(
            0,
            all.findIndex(place => isAtOrAfter(place, from)),
          )
  const turned = [...all.slice(after), ...all.slice(0, after)]
  return turned.find(place => place.targetBlock() === null && place.canBeFocused())
}

function ownerOf(node: Blockly.IFocusableNode | null): Blockly.BlockSvg | undefined {
  if (!(node instanceof Blockly.Field) && !(node instanceof Blockly.RenderedConnection)) return undefined
  return (node.getSourceBlock() ?? undefined) as Blockly.BlockSvg | undefined
}

/// Every place of a block and of what it carries, filled or not, as one reads.
function placesIn(block: Blockly.BlockSvg): Blockly.RenderedConnection[] {
  const own = block.inputList.flatMap(input => {
    if (input.connection === null) return []
    const inside = input.connection.targetBlock() as Blockly.BlockSvg | null
    return [input.connection as Blockly.RenderedConnection, ...(inside === null ? [] : placesIn(inside))]
  })
  const next = block.getNextBlock() as Blockly.BlockSvg | null
  return next === null ? own : [...own, ...placesIn(next)]
}

/// Whether a place is one of `block` or comes after it.
function isAtOrAfter(place: Blockly.RenderedConnection, block: Blockly.BlockSvg): boolean {
  if (place.getSourceBlock() === block) return true
  const order = place.getSourceBlock().getRootBlock().getDescendants(true)
  return order.indexOf(place.getSourceBlock()) > order.indexOf(block)
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

/// Names and ready blocks that fit at a place: first the names, then what is of the family that the socket wants.
export function suggest(
  session: Session,
  workspace: SavedWorkspace,
  place: Place,
  categories: readonly ToolboxCategory[],
): readonly ToolboxItem[] {
  const names = session.namesInScope(workspace, place).filter(name => name.fits)
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

export function nameItem(name: InScope): ToolboxItem {
  return {label: name.name, block: name.block}
}
