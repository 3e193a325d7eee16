/// Fields of blocks: views of `extraState`. A field shows the value under its key and writes back what the learner enters. Blockly saves no field, because it restores
/// fields only after blocks are connected, which is too late for type checks.

import * as Blockly from "blockly/core"
import {type FieldActions, fit, LabelField} from "./field_base.ts"
import type {FieldItem} from "./input_layout.ts"
import {BinderField, CodeField, SignatureField, TextField} from "./text_fields.ts"

/// @internal A menu of constructors.
export class MenuField extends Blockly.FieldDropdown {
  readonly key: string
  private readonly actions: FieldActions
  private live = false

  constructor(
    key: string,
    value: string,
    options: readonly (readonly [string, string])[],
    aria: string,
    actions: FieldActions,
  ) {
    // A value that is not in the menu stays what it is and is shown as it is.
    const known = options.some(option => option[1] === value)
    const all = known ? options : [...options, [value, value] as const]
    super(
      all.map(([label, option]) => [label, option] as [string, string]),
      undefined,
      {ariaTypeName: aria},
    )
    this.key = key
    this.actions = actions
    this.setValue(value, false)
    this.live = true
  }

  override isSerializable(): boolean {
    return false
  }

  protected override doValueUpdate_(value: string): void {
    super.doValueUpdate_(value)
    if (this.live) this.actions.changed(this, this.key, value)
  }
}

/// The action of a button that shows the definition behind its block.
export const lookInside = "look-inside"

/// Pixels.
const pressMargin = 8
const pressHeight = 24

/// A magnifying glass within 24 × 24 pixels.
const glass = "M14.2 14.2 19 19M15.6 10.3a5.3 5.3 0 1 1-10.6 0a5.3 5.3 0 0 1 10.6 0z"

/// @internal `+`, `−`, and the magnifying glass of `look-inside`.
export class ButtonField extends Blockly.Field<string> {
  readonly action: string
  private readonly actions: FieldActions

  constructor(text: string, action: string, aria: string, actions: FieldActions) {
    super(action === lookInside ? "" : text, undefined, {ariaTypeName: aria, tooltip: aria})
    this.action = action
    this.actions = actions
  }

  override isSerializable(): boolean {
    return false
  }

  // A block that is read aloud does not list its buttons; one that has the focus says what it does.
  override computeAriaLabel(typed = true): string {
    return typed ? (this.getAriaTypeName() ?? "") : ""
  }

  override initView(): void {
    this.createBorderRect_()
    this.createTextElement_()
    if (this.fieldGroup_ !== null) {
      Blockly.utils.dom.addClass(this.fieldGroup_, "rosyPress")
      if (this.action === lookInside)
        Blockly.utils.dom.createSvgElement("path", {class: "rosyGlass", d: glass}, this.fieldGroup_)
    }
    this.recomputeAriaContext()
  }

  override recomputeAriaContext(): boolean {
    if (!super.recomputeAriaContext()) return false
    Blockly.utils.aria.setRole(this.getFocusableElement(), Blockly.utils.aria.Role.BUTTON)
    return true
  }

  protected override updateSize_(): void {
    fit(this, pressMargin, pressHeight, pressHeight)
  }

  protected override showEditor_(): void {
    const block = this.getSourceBlock()
    if (block !== null) this.actions.pressed(block, this.action)
  }

  override isClickableInFlyout(): boolean {
    return false
  }
}

/// The field for an item of a shape.
export function makeField(item: FieldItem, actions: FieldActions): Blockly.Field {
  switch (item.kind) {
    case "label":
      return new LabelField(
        item.text,
        item.strong === true ? "rosyStrong" : item.unit === true ? "rosyUnit" : "rosyWords",
      )
    case "signature":
      return new SignatureField(item.key, item.value, item.aria, actions)
    case "reference":
      return new LabelField(item.value, "rosyReference")
    case "text":
      if (item.lines === true) return new CodeField(item.key, item.value, item.aria, actions)
      return new TextField(item.key, item.value, "text", item.aria, actions)
    case "number":
      return new TextField(item.key, item.value, "number", item.aria, actions)
    case "type":
      return new TextField(item.key, item.value, "type", item.aria, actions)
    case "menu":
      return new MenuField(item.key, item.value, item.options, item.aria, actions)
    case "binder":
      return new BinderField(item.key, item.value, item.aria, actions, item.ofType)
    case "button":
      return new ButtonField(item.text, item.action, item.aria, actions)
  }
}

/// Shows a value that came from elsewhere (undo, a rename, a load) in a field that is there already.
export function showValue(field: Blockly.Field, value: string): void {
  if (field.getValue() === value) return
  // Without a written type the inferred one stands there, and inference follows every edit.
  if (field instanceof SignatureField && value === "") return
  if (field instanceof BinderField || field instanceof LabelField || field instanceof SignatureField)
    field.show(value)
  else field.setValue(value, false)
}
