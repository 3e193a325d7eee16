/// Fields of blocks: views of `extraState`. A field shows the value under its key and writes back what the learner enters. Blockly saves no field, because it restores
/// fields only after blocks are connected, which is too late for type checks.

import * as Blockly from "blockly/core"
import {makeNumberGrip, type NumberDragListener} from "../../preview/number_grip.ts"
import {withSteps} from "../../preview/number_steps.ts"
import {words} from "../../words/index.ts"
import {MultilineField} from "./code_field.ts"
import type {FieldItem} from "./input_layout.ts"
import {widthOf} from "./text_width.ts"

/// What a field does when the learner has changed or used it.
export interface FieldActions {
  /// The value under `key` is now `value`.
  /// `whole`: as one step of its own, which Blockly has not recorded.
  changed(field: Blockly.Field, key: string, value: string, whole?: boolean): void
  /// A binder's name was edited to `name`; the field shows the old name until the answer comes.
  renamed(block: Blockly.Block, key: string, name: string): void
  pressed(block: Blockly.Block, action: string): void
  /// Told of the dragging of numbers.
  readonly numbers: NumberDragListener
  /// A name is being dragged out of its binder.
  pulled(field: Blockly.Field, event: PointerEvent): void
}

/// A Haskell number literal as a learner may begin to type it; `-` and a dot at either end are tidied.
const number = /^-?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i

/// `text` as a Haskell literal, or null when it is none. Pure; exported for its test.
export function haskellNumber(text: string): string | null {
  const trimmed = text.trim().replace(",", ".")
  if (!number.test(trimmed)) return null
  return trimmed
    .replace(/^(-?)\./, "$10.")
    .replace(/\.(?=e|$)/i, "")
    .replace(/^(-?)0+(?=\d)/, "$1")
}

/// What Blockly keeps for its fields alone.
interface Parts {
  readonly textElement_: SVGTextElement | null
  readonly borderRect_: SVGRectElement | null
  size_: Blockly.utils.Size
  positionTextElement_(inset: number, width: number): void
  positionBorderRect_(): void
}

/// Gives a field with a text its size, as Blockly does, without asking the browser where the text stands. Pixels.
/// `lower` is another height than that of a field, `least` a least width.
function fit(field: Blockly.Field, margin?: number, lower?: number, least = 0): void {
  const parts = field as unknown as Parts
  const constants = field.getConstants()
  if (constants === null) return
  const {textElement_: text, borderRect_: border} = parts
  const width = widthOf(text)
  const inset = Math.max(
    margin ?? (border === null ? 0 : constants.FIELD_BORDER_RECT_X_PADDING),
    (least - width) / 2,
  )
  const height = Math.max(
    constants.FIELD_TEXT_HEIGHT,
    border === null ? 0 : constants.FIELD_BORDER_RECT_HEIGHT,
  )
  parts.size_ = new Blockly.utils.Size(2 * inset + width, lower ?? height)
  parts.positionTextElement_(inset, width)
  parts.positionBorderRect_()
}

/// @internal Words of a block.
export class LabelField extends Blockly.FieldLabel {
  protected override updateSize_(margin?: number): void {
    fit(this, margin)
  }

  override isSerializable(): boolean {
    return false
  }

  /// New words; labels are not the learner's, so no event is sent.
  show(words: string): void {
    if (this.getValue() === words) return
    this.setValue(words, false)
  }
}

/// A field of one line that is typed into.
class SingleLineField extends Blockly.FieldTextInput {
  protected override updateSize_(margin?: number): void {
    fit(this, margin)
  }

  override isSerializable(): boolean {
    return false
  }

  // Blockly names the field, and not the input that is laid over it while it is open.
  protected override widgetCreate_(): HTMLInputElement | HTMLTextAreaElement {
    const input = super.widgetCreate_()
    input.setAttribute("aria-label", this.getAriaTypeName() ?? "")
    return input
  }
}

/// @internal The type in a definition's header: the inferred one until the learner writes another; an empty one is
/// inferred again.
export class SignatureField extends SingleLineField {
  /// Characters; Blockly cuts off after 50.
  override maxDisplayLength = 120
  readonly key: string
  private readonly actions: FieldActions
  private before = ""

  constructor(key: string, value: string, aria: string, actions: FieldActions) {
    super(value, undefined, {spellcheck: false, ariaTypeName: aria})
    this.key = key
    this.actions = actions
  }

  /// Shows a type without telling anyone.
  show(type: string): void {
    if (this.getValue() !== type) this.setValue(type, false)
  }

  /// With real arrows, which are easier to read at a glance; while it is edited it stands as Haskell writes it.
  protected override getText_(): string | null {
    return this.isBeingEdited_ ? super.getText_() : (this.getValue() ?? "").replaceAll("->", "→")
  }

  // A block that is read aloud says what it does; its type is one step away.
  override computeAriaLabel(typed = true): string {
    return typed ? super.computeAriaLabel(typed) : ""
  }

  protected override showEditor_(event?: Event, quiet?: boolean, ephemeral?: boolean): void {
    this.before = this.getValue() ?? ""
    super.showEditor_(event, quiet, ephemeral)
  }

  override onFinishEditing_(type: string): void {
    super.onFinishEditing_(type)
    const wanted = type.replaceAll("→", "->").replace(/\s+/g, " ").trim()
    const before = this.before
    if (wanted === before) return
    this.setValue(before, false)
    const block = this.getSourceBlock()
    if (block !== null) queueMicrotask(() => this.actions.changed(this, this.key, wanted, true))
  }

  override initView(): void {
    super.initView()
    if (this.fieldGroup_ !== null) Blockly.utils.dom.addClass(this.fieldGroup_, "rosySignature")
  }
}

/// @internal Text, numbers and types.
export class TextField extends SingleLineField {
  readonly key: string
  protected readonly actions: FieldActions
  readonly kind: "text" | "number" | "type"
  private live = false

  constructor(
    key: string,
    value: string,
    kind: "text" | "number" | "type",
    aria: string,
    actions: FieldActions,
  ) {
    super(value, undefined, {spellcheck: false, ariaTypeName: aria})
    this.key = key
    this.kind = kind
    this.actions = actions
    this.setSpellcheck(false)
    this.live = true
  }

  protected override doClassValidation_(text?: unknown): string | null {
    if (typeof text !== "string" && typeof text !== "number") return null
    // `kind` is not yet there while the constructor of the parent sets the first value.
    return this.kind === "number" ? haskellNumber(`${text}`) : `${text}`
  }

  protected override doValueUpdate_(value: string): void {
    super.doValueUpdate_(value)
    if (this.live) this.actions.changed(this, this.key, value)
  }

  protected override widgetCreate_(): HTMLInputElement | HTMLTextAreaElement {
    const input = super.widgetCreate_()
    if (this.kind !== "number") return input
    input.inputMode = "decimal"
    input.addEventListener("keydown", (event: Event) => {
      if (!(event instanceof KeyboardEvent)) return
      const steps = event.key === "ArrowUp" ? 1 : event.key === "ArrowDown" ? -1 : 0
      if (steps === 0) return
      event.preventDefault()
      this.enter(withSteps(this.getValue() ?? "0", steps))
    })
    const number = {literal: () => this.getValue() ?? "0", set: (literal: string) => this.enter(literal)}
    Blockly.WidgetDiv.getDiv()?.append(makeNumberGrip(words.preview.dragNumber, number, this.actions.numbers))
    return input
  }

  /// Another number, as if it had been typed.
  private enter(literal: string): void {
    this.setEditorValue_(literal, false)
    this.resizeEditor_()
  }

  override initView(): void {
    super.initView()
    const name = this.kind === "type" ? "rosyTypeEntry" : "rosyEntry"
    if (this.fieldGroup_ !== null) Blockly.utils.dom.addClass(this.fieldGroup_, name)
    // Widths are remembered by the text's own class, and types have a face of their own.
    if (this.textElement_ !== null) Blockly.utils.dom.addClass(this.textElement_, `${name}Text`)
  }
}

/// @internal Several lines of Haskell.
export class CodeField extends MultilineField {
  readonly key: string
  private readonly actions: FieldActions
  private live = false

  constructor(key: string, value: string, aria: string, actions: FieldActions) {
    super(value, undefined, {spellcheck: false, ariaTypeName: aria})
    this.key = key
    this.actions = actions
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

/// Pixels of movement after which a press on a binder is a drag; Blockly's own is 5, ours must come first.
const pullDistance = 3

/// @internal A name that its block brings into scope. Click to rename, drag to take a reference out.
export class BinderField extends SingleLineField {
  readonly key: string
  private readonly actions: FieldActions
  private readonly ofType: boolean
  private before = ""

  constructor(key: string, value: string, aria: string, actions: FieldActions, ofType = false) {
    super(value, undefined, {spellcheck: false, ariaTypeName: aria})
    this.key = key
    this.actions = actions
    this.ofType = ofType
  }

  /// Shows a name without telling anyone: the rename has been made already, or refused.
  show(name: string): void {
    if (this.getValue() !== name) this.setValue(name, false)
  }

  protected override showEditor_(event?: Event, quiet?: boolean, ephemeral?: boolean): void {
    this.before = this.getValue() ?? ""
    super.showEditor_(event, quiet, ephemeral)
  }

  // While the learner types, only this field shows the new name; the program changes once, at the end, with
  // all references.
  override onFinishEditing_(name: string): void {
    super.onFinishEditing_(name)
    const before = this.before
    if (name === before) return
    this.setValue(before, false)
    const block = this.getSourceBlock()
    if (block !== null) queueMicrotask(() => this.actions.renamed(block, this.key, name))
  }

  override initView(): void {
    super.initView()
    if (this.fieldGroup_ === null) return
    if (this.ofType) {
      Blockly.utils.dom.addClass(this.fieldGroup_, "rosyEntry")
      if (this.textElement_ !== null) Blockly.utils.dom.addClass(this.textElement_, "rosyEntryText")
      return
    }
    Blockly.utils.dom.addClass(this.fieldGroup_, "rosyBinder")
    this.fieldGroup_.addEventListener("pointerdown", event => this.watch(event as PointerEvent))
  }

  // A pattern that is nothing but a name is that name: its whole block is the field, in the block's own colour.
  override applyColour(): void {
    if (!this.isFullBlockField()) super.applyColour()
  }

  private watch(down: PointerEvent): void {
    const block = this.getSourceBlock()
    if (block === null || block.isInFlyout || !block.isMovable() || down.button !== 0) return
    const stop = new AbortController()
    const listen = {capture: true, signal: stop.signal}
    window.addEventListener(
      "pointermove",
      move => {
        if (move.pointerId !== down.pointerId) return
        if (Math.hypot(move.clientX - down.clientX, move.clientY - down.clientY) < pullDistance) return
        stop.abort()
        move.stopPropagation()
        this.actions.pulled(this, move)
      },
      listen,
    )
    window.addEventListener("pointerup", () => stop.abort(), listen)
    window.addEventListener("pointercancel", () => stop.abort(), listen)
  }
}

/// Whether a number is typed into a field.
export function isNumberField(field: unknown): field is Blockly.Field {
  return field instanceof TextField && field.kind === "number"
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
