/// The fields of our blocks: views of `extraState`. Each shows the value under its key and writes back what the
/// learner enters; Blockly saves none of them, because it restores fields only after blocks are connected, too
/// late to know a type.

import * as Blockly from "blockly/core"
import {Code} from "./code.ts"
import type {FieldItem} from "./plan.ts"
import {widthOf} from "./widths.ts"

/// What a field does when the learner has changed or used it.
export interface FieldActions {
  /// The value under `key` is now `value`.
  /// `whole`: as one step of its own, which Blockly has not recorded.
  changed(field: Blockly.Field, key: string, value: string, whole?: boolean): void
  /// A binder's name was edited to `name`; the field shows the old name until the answer comes.
  renamed(block: Blockly.Block, key: string, name: string): void
  pressed(block: Blockly.Block, action: string): void
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
function fit(field: Blockly.Field, margin?: number, lower?: number): void {
  const parts = field as unknown as Parts
  const constants = field.getConstants()
  if (constants === null) return
  const {textElement_: text, borderRect_: border} = parts
  const inset = margin ?? (border === null ? 0 : constants.FIELD_BORDER_RECT_X_PADDING)
  const width = widthOf(text)
  const height = Math.max(
    constants.FIELD_TEXT_HEIGHT,
    border === null ? 0 : constants.FIELD_BORDER_RECT_HEIGHT,
  )
  parts.size_ = new Blockly.utils.Size(2 * inset + width, lower ?? height)
  parts.positionTextElement_(inset, width)
  parts.positionBorderRect_()
}

/// @internal Words of a block.
export class Words extends Blockly.FieldLabel {
  protected override updateSize_(margin?: number): void {
    fit(this, margin)
  }

  override isSerializable(): boolean {
    return false
  }

  /// New words; labels are not the learner's, so nobody is told.
  show(words: string): void {
    if (this.getValue() === words) return
    this.setValue(words, false)
  }
}

/// A field of one line that is typed into.
class Line extends Blockly.FieldTextInput {
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
export class Signature extends Line {
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
export class Entry extends Line {
  readonly key: string
  protected readonly actions: FieldActions
  private readonly kind: "text" | "number" | "type"
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
    if (this.kind === "number") input.inputMode = "decimal"
    return input
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
export class CodeEntry extends Code {
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
export class Menu extends Blockly.FieldDropdown {
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
export class Binder extends Line {
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

/// Pixels.
const pressMargin = 7
const pressHeight = 20

/// @internal `+` and `−`.
export class Press extends Blockly.Field<string> {
  readonly action: string
  private readonly actions: FieldActions

  constructor(text: string, action: string, aria: string, actions: FieldActions) {
    super(text, undefined, {ariaTypeName: aria, tooltip: aria})
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
    if (this.fieldGroup_ !== null) Blockly.utils.dom.addClass(this.fieldGroup_, "rosyPress")
    this.recomputeAriaContext()
  }

  override recomputeAriaContext(): boolean {
    if (!super.recomputeAriaContext()) return false
    Blockly.utils.aria.setRole(this.getFocusableElement(), Blockly.utils.aria.Role.BUTTON)
    return true
  }

  protected override updateSize_(): void {
    // Lower than other fields, so that a row of buttons is hardly a row.
    fit(this, pressMargin, pressHeight)
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
      return new Words(item.text, item.strong === true ? "rosyStrong" : "rosyWords")
    case "signature":
      return new Signature(item.key, item.value, item.aria, actions)
    case "reference":
      return new Words(item.value, "rosyReference")
    case "text":
      if (item.lines === true) return new CodeEntry(item.key, item.value, item.aria, actions)
      return new Entry(item.key, item.value, "text", item.aria, actions)
    case "number":
      return new Entry(item.key, item.value, "number", item.aria, actions)
    case "type":
      return new Entry(item.key, item.value, "type", item.aria, actions)
    case "menu":
      return new Menu(item.key, item.value, item.options, item.aria, actions)
    case "binder":
      return new Binder(item.key, item.value, item.aria, actions, item.ofType)
    case "button":
      return new Press(item.text, item.action, item.aria, actions)
  }
}

/// Shows a value that came from elsewhere (undo, a rename, a load) in a field that is there already.
export function showValue(field: Blockly.Field, value: string): void {
  if (field.getValue() === value) return
  // Without a written type the inferred one stands there, and inference follows every edit.
  if (field instanceof Signature && value === "") return
  if (field instanceof Binder || field instanceof Words || field instanceof Signature) field.show(value)
  else field.setValue(value, false)
}
