/// Keyboard shortcuts that fill empty places: to the next one, to what fits there, to the next number, a number typed directly, and one more place in `simulate`.

import * as Blockly from "blockly/core"
import {words} from "../../../words/index.ts"
import {placeToRun, programOf} from "../dragging/program_membership.ts"
import {focusedNumber, nextEmpty, nextNumber} from "./insertion_points.ts"
import {say} from "./toast.ts"

/// Once for the page. Blockly keeps shortcuts per document, so the actions are looked up in the current view.
export function fillingKeys(
  actions: () => {offerBlocks(): void; toggleRuns(block: Blockly.Block): boolean} | undefined,
): void {
  const {registry: keys} = Blockly.ShortcutRegistry
  const {KeyCodes} = Blockly.utils
  /// Has what fits offered, and keeps the letter that was pressed out of the search field.
  const offer = (event: Event): boolean => {
    const view = actions()
    if (view === undefined) return false
    event.preventDefault()
    view.offerBlocks()
    return true
  }
  const rests = (workspace: Blockly.WorkspaceSvg) => !workspace.isDragging() && !workspace.isFlyout
  keys.register({
    name: "rosyFill",
    keyCodes: [KeyCodes.ENTER],
    allowCollision: true,
    displayText: () => words.blocks.fill,
    preconditionFn: (workspace, scope) => rests(workspace) && isEmptyPlace(scope.focusedNode),
    callback: (_, event) => {
      Blockly.keyboardNavigationController.setIsActive(true)
      return offer(event)
    },
  })
  keys.register({
    name: "rosyNextEmpty",
    keyCodes: [KeyCodes.E, keys.createSerializedKey(KeyCodes.E, [KeyCodes.SHIFT])],
    displayText: () => words.blocks.nextEmpty,
    preconditionFn: rests,
    callback: (workspace, event) =>
      chooseEmpty(workspace, event instanceof KeyboardEvent && event.shiftKey) !== undefined,
  })
  keys.register({
    name: "rosyFillNext",
    keyCodes: [KeyCodes.F],
    displayText: () => words.blocks.fillNext,
    preconditionFn: rests,
    callback: (workspace, event, _, scope) =>
      (isEmptyPlace(scope.focusedNode) || chooseEmpty(workspace) !== undefined) && offer(event),
  })
  keys.register({
    name: "rosyRunOneMore",
    keyCodes: [KeyCodes.R],
    displayText: () => words.blocks.runOneMore,
    preconditionFn: rests,
    callback: (workspace, event) => choosePlaceToRun(workspace) && offer(event),
  })
  keys.register({
    name: "rosyToggleRuns",
    keyCodes: [keys.createSerializedKey(KeyCodes.R, [KeyCodes.SHIFT])],
    displayText: () => words.blocks.toggleRuns,
    preconditionFn: rests,
    callback: (_, __, ___, {focusedNode}) => {
      const block = focusedNode instanceof Blockly.Field ? focusedNode.getSourceBlock() : focusedNode
      return block instanceof Blockly.BlockSvg && actions()?.toggleRuns(block) === true
    },
  })
  keys.register({
    name: "rosyNextNumber",
    keyCodes: [KeyCodes.V, keys.createSerializedKey(KeyCodes.V, [KeyCodes.SHIFT])],
    displayText: () => words.blocks.nextNumber,
    preconditionFn: rests,
    callback: (workspace, event) => {
      const next = nextNumber(workspace, event instanceof KeyboardEvent && event.shiftKey)
      if (next === undefined) {
        say(workspace, words.blocks.noNumber)
        return false
      }
      Blockly.keyboardNavigationController.setIsActive(true)
      Blockly.getFocusManager().focusNode(next)
      return true
    },
  })
  keys.register({
    name: "rosyNumber",
    keyCodes: numberKeys,
    allowCollision: true,
    displayText: () => words.blocks.typeNumber,
    preconditionFn: (workspace, {focusedNode}) =>
      rests(workspace) && (isEmptyPlace(focusedNode) || focusedNumber(focusedNode) !== undefined),
    // What was pressed is typed into the field that has the focus after this: the search, or the number's own.
    callback: (_, event, __, {focusedNode}) => {
      const number = focusedNumber(focusedNode)
      if (number !== undefined) {
        number.showEditor(event)
        return true
      }
      Blockly.keyboardNavigationController.setIsActive(true)
      actions()?.offerBlocks()
      return true
    },
  })
}

/// Codes of the digits, of those beside them, and of the minus in both places (UI Events, `keyCode`).
const numberKeys = [
  ...Array.from({length: 10}, (_, digit) => 48 + digit),
  ...Array.from({length: 10}, (_, digit) => 96 + digit),
  109,
  189,
]

function isEmptyPlace(node: Blockly.IFocusableNode | undefined): node is Blockly.RenderedConnection {
  return node instanceof Blockly.RenderedConnection && node.targetBlock() === null
}

/// Moves the focus to the next empty place, or says that there is none. `back`: the one before.
function chooseEmpty(workspace: Blockly.WorkspaceSvg, back = false): Blockly.RenderedConnection | undefined {
  // Only what is drawn can have the focus.
  Blockly.renderManagement.triggerQueuedRenders(workspace)
  const next = nextEmpty(workspace, back)
  if (next === undefined) {
    say(workspace, words.blocks.noneEmpty)
    return undefined
  }
  Blockly.keyboardNavigationController.setIsActive(true)
  Blockly.getFocusManager().focusNode(next)
  return next
}

/// Chooses where the program goes on after a block was put: the first empty place in it; the place below a step; or else, unless it has to be `near`, the next empty
/// place. Answers whether there is one.
export function chooseNextPlace(workspace: Blockly.WorkspaceSvg, near = false): boolean {
  const block = Blockly.getFocusManager().getFocusedNode()
  if (!(block instanceof Blockly.BlockSvg)) return false
  const next = nextEmpty(workspace)
  const isInside = next !== undefined && isWithin(next.getSourceBlock(), block)
  if (!isInside && block.nextConnection?.getCheck()?.includes("step")) return true
  if (!near) return chooseEmpty(workspace) !== undefined
  if (isInside) Blockly.getFocusManager().focusNode(next)
  return isInside
}

/// Whether a block is `outer`, or lies in one of its inputs; what follows below `outer` does not.
function isWithin(block: Blockly.Block, outer: Blockly.Block): boolean {
  for (let at: Blockly.Block | null = block; at !== null; at = at.getSurroundParent())
    if (at === outer) return true
  return false
}

/// Chooses an empty place of `simulate`, a new one when all are filled. Answers whether there is one.
function choosePlaceToRun(workspace: Blockly.WorkspaceSvg): boolean {
  const program = programOf(workspace)
  const place = program && placeToRun(program)
  if (place === undefined) return false
  Blockly.renderManagement.triggerQueuedRenders(workspace)
  Blockly.keyboardNavigationController.setIsActive(true)
  Blockly.getFocusManager().focusNode(place)
  return true
}
