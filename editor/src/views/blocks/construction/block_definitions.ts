/// Blockly block definitions, built from codegen's shapes: one definition per block type.
///
/// `extraState` holds the complete state of a block. When it changes, the shape is computed again. If only values differ, the fields are updated; otherwise inputs are
/// added and removed, and inputs that stay keep their children.

import {type BlockView, type Extra, type Shape, setIn} from "@rosy/codegen"
import * as Blockly from "blockly/core"
import type {NumberDragListener} from "../../../browser/number_grip.ts"
import {helpAddress} from "../../../help/help_links.ts"
import {words} from "../../../words/index.ts"
import {type FieldActions, LabelField} from "./field_base.ts"
import {ButtonField, lookInside, makeField, showValue} from "./fields.ts"
import {fieldValues, inputLayout, layoutKey, type PlannedInput} from "./input_layout.ts"
import {BinderField, SignatureField} from "./text_fields.ts"
import {setConnectionStyle, styleName} from "./theme.ts"

interface Built {
  readonly view: BlockView
  extra: Extra
  shape: Shape
  skeleton: string
}

type ContextMenuOption = Parameters<NonNullable<Blockly.BlockSvg["customContextMenu"]>>[0][number]

const built = new WeakMap<Blockly.Block, Built>()

/// What the page does with things only it can answer.
export interface BuildActions {
  /// A block was made, on the workspace or in the toolbox. It may be moved at once, before any event tells of it.
  made(block: Blockly.BlockSvg): void
  /// A field of a block has another value.
  edited(block: Blockly.Block): void
  renamed(block: Blockly.Block, key: string, name: string): void
  readonly numbers: NumberDragListener
  pulled(field: BinderField, event: PointerEvent): void
  /// What inserts the definition that a block calls; undefined if there is none in the library.
  lookInside(block: Blockly.Block): (() => void) | undefined
  /// Shows the definition that a block calls: inserts the library's, or goes to the program's own.
  showDefinition(block: Blockly.Block): void
}

/// Registers every kind of block with Blockly; once for the page, with the actions of the view in use.
export function registerBlocks(views: readonly BlockView[], actions: () => BuildActions | undefined): void {
  const fieldActions: FieldActions = {
    changed: (field, key, value, whole) => {
      const block = field.getSourceBlock()
      const state = block === null ? undefined : built.get(block)
      if (block === null || state === undefined) return
      if (whole === true) {
        change(block, setIn(state.extra, key, value))
        return
      }
      adopt(block, state, setIn(state.extra, key, value), fieldActions)
      actions()?.edited(block)
    },
    renamed: (block, key, name) => actions()?.renamed(block, key, name),
    numbers: {
      begins: () => actions()?.numbers.begins(),
      ends: () => actions()?.numbers.ends(),
      isBehind: () => actions()?.numbers.isBehind() ?? false,
    },
    pulled: (field, event) => {
      if (field instanceof BinderField) actions()?.pulled(field, event)
    },
    pressed: (block, action) => {
      const state = built.get(block)
      if (action === lookInside) actions()?.showDefinition(block)
      else if (state !== undefined) change(block, state.view.press(state.extra, action), action)
    },
  }
  for (const view of views) {
    Blockly.Blocks[view.type] = {
      init(this: Blockly.Block) {
        const shape = view.shape({})
        const state: Built = {view, extra: {}, shape, skeleton: ""}
        built.set(this, state)
        draw(this, state, shape, fieldActions)
        if (this instanceof Blockly.BlockSvg) actions()?.made(this)
      },
      customContextMenu(this: Blockly.BlockSvg, options: ContextMenuOption[]) {
        const state = built.get(this)
        if (state === undefined || this.isInFlyout) return
        const look = actions()?.lookInside(this)
        if (look !== undefined)
          options.push({text: words.blocks.lookInside, enabled: true, callback: look} as ContextMenuOption)
        for (const {action, text} of state.shape.menu ?? []) {
          options.push({
            text,
            enabled: true,
            callback: () => change(this, state.view.press(state.extra, action)),
          } as ContextMenuOption)
        }
      },
      // Blockly brings into view what the focus is on, but not a block itself.
      onNodeFocus(this: Blockly.BlockSvg) {
        Blockly.BlockSvg.prototype.onNodeFocus.call(this)
        if (this.isInFlyout || !Blockly.keyboardNavigationController.getIsActive()) return
        this.workspace.scrollBoundsIntoView(this.getBoundingRectangleWithoutChildren())
      },
      checkAndDelete: deleted,
      // Blockly pushes away blocks that lie near a socket of another. Here they lie where the learner put them.
      bumpNeighbours() {},
      // An empty state is not saved, as the reader of the text writes none.
      saveExtraState(this: Blockly.Block) {
        const extra = extraOf(this)
        return Object.keys(extra).length === 0 ? null : extra
      },
      loadExtraState(this: Blockly.Block, extra: Extra) {
        const state = built.get(this)
        if (state !== undefined) adopt(this, state, extra ?? {}, fieldActions)
      },
    }
  }
}

/// Deletes a block, and leaves the focus where it was: on the empty socket, or on the step before or after. Blockly
/// gives it to the block around, later.
function deleted(this: Blockly.BlockSvg): void {
  if (this.workspace.isFlyout) return
  Blockly.Events.setGroup(true)
  this.workspace.hideChaff()
  const socket = this.outputConnection?.targetConnection ?? this.previousConnection?.targetConnection
  const stacked = this.outputConnection === null
  if (socket != null) {
    this.unplug(stacked)
    // Only what is drawn can have the focus.
    Blockly.renderManagement.triggerQueuedRenders(this.workspace)
    const inStack = socket.getParentInput() === null ? socket.getSourceBlock() : socket
    Blockly.getFocusManager().focusNode(stacked ? (socket.targetBlock() ?? inStack) : socket)
  }
  this.dispose(stacked, true)
  Blockly.Events.setGroup(false)
}

/// All that a block says about itself besides its children.
export function extraOf(block: Blockly.Block): Extra {
  return built.get(block)?.extra ?? {}
}

export function shapeOf(block: Blockly.Block): Shape | undefined {
  return built.get(block)?.shape
}

/// Whether the fields of a block show what it says: a menu takes only what is in it. (A type in a header is inferred where none is written.)
export function isShown(block: Blockly.Block): boolean {
  const shape = built.get(block)?.shape
  if (shape === undefined) return false
  return [...fieldValues(shape)].every(([key, value]) => {
    const field = block.getField(key)
    return field === null || field instanceof SignatureField || field.getValue() === value
  })
}

/// Gives a block a new `extraState` as one step of undo. The button that was pressed keeps the focus, and what is in the inputs that it removes goes with them.
export function change(block: Blockly.Block, extra: Extra, pressed?: string): void {
  const state = built.get(block)
  if (state === undefined) return
  const before = JSON.stringify(state.extra)
  const after = JSON.stringify(extra)
  if (before === after) return
  const group = Blockly.Events.getGroup()
  if (group === "") Blockly.Events.setGroup(true)
  if (pressed !== undefined) {
    const kept = new Set(inputLayout(state.view.shape(extra)).map(({name}) => name))
    const removed = block.inputList.filter(input => !kept.has(input.name))
    for (const input of removed) input.connection?.targetBlock()?.dispose(false)
  }
  block.loadExtraState?.(extra)
  Blockly.Events.fire(
    new (Blockly.Events.get(Blockly.Events.BLOCK_CHANGE))(block, "mutation", null, before, after),
  )
  if (group === "") Blockly.Events.setGroup(false)
  if (pressed !== undefined && block instanceof Blockly.BlockSvg) refocus(block, pressed)
}

/// Rebuilding removes the field that has the focus; its successor gets it, so that `+` can be pressed again.
function refocus(block: Blockly.BlockSvg, action: string): void {
  for (const input of block.inputList) {
    for (const field of input.fieldRow) {
      if (field instanceof ButtonField && field.action === action) {
        Blockly.getFocusManager().focusNode(field)
        return
      }
    }
  }
  Blockly.getFocusManager().focusNode(block)
}

function adopt(block: Blockly.Block, state: Built, extra: Extra, actions: FieldActions): void {
  state.extra = extra
  draw(block, state, state.view.shape(extra), actions)
}

function draw(block: Blockly.Block, state: Built, shape: Shape, actions: FieldActions): void {
  const bones = layoutKey(shape)
  const same = bones === state.skeleton
  state.shape = shape
  state.skeleton = bones
  block.setTooltip(shape.tooltip)
  block.setHelpUrl(helpAddress(shape.help))
  block.setAriaRoleDescriptionProvider(shape.aria)
  if (same && block instanceof Blockly.BlockSvg && block.getFullBlockField() === null) {
    // Blockly asks again only when the block gets the focus.
    const {aria} = Blockly.utils
    aria.setState(block.pathObject.svgPath, aria.State.ROLEDESCRIPTION, shape.aria)
  }
  if (same) {
    const shown = fieldValues(shape)
    for (const planned of inputLayout(shape)) {
      const input = block.getInput(planned.name)
      input?.fieldRow.forEach((field, at) => {
        const item = planned.fields[at]
        // Names are said in the labels of what belongs to them.
        if (item !== undefined && "aria" in item && field.getAriaTypeName() !== item.aria) {
          field.setAriaTypeName(item.aria)
          field.recomputeAriaContext()
        }
        const value = field.name === undefined ? undefined : shown.get(field.name)
        if (value !== undefined) showValue(field, value)
      })
      if (planned.kind !== "words") input?.setAriaLabelProvider(planned.item.aria)
    }
    return
  }
  connect(block, shape)
  reconcile(block, inputLayout(shape), actions)
  block.setInputsInline(true)
  block.setStyle(styleName(shape.family, shape.connects.as === "pattern"))
  if (block.outputConnection !== null)
    setConnectionStyle(block.outputConnection, {family: shape.family, hint: "", hole: false})
}

function connect(block: Blockly.Block, shape: Shape): void {
  const as = shape.connects.as
  switch (as) {
    case "top":
      return
    case "expression":
    case "pattern":
      if (block.outputConnection === null) block.setOutput(true, as)
      return
    case "definition":
    case "step":
      if (block.previousConnection !== null) return
      block.setPreviousStatement(true, as)
      block.setNextStatement(true, as)
  }
}

function reconcile(block: Blockly.Block, wanted: readonly PlannedInput[], actions: FieldActions): void {
  const kept = new Map(wanted.map(input => [input.name, input]))
  for (const input of [...block.inputList]) {
    const planned = kept.get(input.name)
    if (planned === undefined || !sameKind(input, planned)) block.removeInput(input.name)
  }
  wanted.forEach((planned, at) => {
    const input = block.getInput(planned.name) ?? append(block, planned)
    while (input.fieldRow.length > 0) {
      const field = input.fieldRow[0]!
      // Only fields with a name can be removed by it.
      field.name ??= "words"
      input.removeField(field.name)
    }
    for (const item of planned.fields) {
      const field = makeField(item, actions)
      if ("key" in item && !(field instanceof LabelField)) input.appendField(field, item.key)
      else if ("key" in item) input.appendField(field, item.key)
      else input.appendField(field)
    }
    if (planned.kind !== "words") {
      const connection = input.connection
      const {item} = planned
      input.setAriaLabelProvider(item.aria)
      if (connection !== null && item.kind === "socket") {
        setConnectionStyle(connection, {family: state(block), hint: item.hint ?? "", hole: false})
      }
    }
    if (block.inputList[at] !== input) {
      const after = block.inputList[at]
      if (after !== undefined) block.moveInputBefore(planned.name, after.name)
    }
  })
}

const state = (block: Blockly.Block) => built.get(block)?.shape.family ?? "own"

function sameKind(input: Blockly.Input, planned: PlannedInput): boolean {
  switch (planned.kind) {
    case "socket":
      return input.type === Blockly.inputs.inputTypes.VALUE
    case "stack":
      return input.type === Blockly.inputs.inputTypes.STATEMENT
    case "words":
      return (
        input.type === (planned.ends ? Blockly.inputs.inputTypes.END_ROW : Blockly.inputs.inputTypes.DUMMY)
      )
  }
}

function append(block: Blockly.Block, planned: PlannedInput): Blockly.Input {
  switch (planned.kind) {
    case "socket":
      return block.appendValueInput(planned.name).setCheck(planned.item.sort)
    case "stack":
      return block.appendStatementInput(planned.name).setCheck(planned.item.sort)
    case "words":
      return planned.ends ? block.appendEndRowInput(planned.name) : block.appendDummyInput(planned.name)
  }
}
