/// Fields that are typed into: types, text, numbers, names and code.

import {isNumberLiteral} from "@rosy/codegen"
import * as Blockly from "blockly/core"
import {dragNumber, makeNumberGrip} from "../../../browser/number_grip.ts"
import {withSteps} from "../../../browser/number_steps.ts"
import {words} from "../../../words/index.ts"
import {MultilineField} from "./code_field.ts"
import {type FieldActions, SingleLineField} from "./field_base.ts"

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

/// Pixels of movement after which a press on a field is a drag; Blockly's own is 5, ours must come first.
const pullDistance = 3

/// Pixels beside the digits of a number that still belong to them.
const besideDigits = 2

/// Calls `pulled` when a press has become a drag.
function onPull(down: PointerEvent, pulled: (move: PointerEvent) => void): void {
  const stop = new AbortController()
  const listen = {capture: true, signal: stop.signal}
  window.addEventListener(
    "pointermove",
    move => {
      if (move.pointerId !== down.pointerId) return
      if (Math.hypot(move.clientX - down.clientX, move.clientY - down.clientY) < pullDistance) return
      stop.abort()
      move.stopPropagation()
      pulled(move)
    },
    listen,
  )
  window.addEventListener("pointerup", () => stop.abort(), listen)
  window.addEventListener("pointercancel", () => stop.abort(), listen)
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
    const said = `${text}`
    // `kind` is not yet there while the constructor of the parent sets the first value.
    if (this.kind !== "number") return said
    // A literal of the program is shown as it stands there, also `0x1F` and `1_000`; what is typed is tidied.
    return !this.isBeingEdited_ && isNumberLiteral(said.replace(/^-/, "")) ? said : haskellNumber(said)
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

  /// A drag of the digits changes the number; what is around them belongs to the block.
  private watch(down: PointerEvent): void {
    const workspace = this.getSourceBlock()?.workspace
    const digits = this.textElement_?.getBoundingClientRect()
    if (!(workspace instanceof Blockly.WorkspaceSvg) || workspace.isFlyout || digits === undefined) return
    const isOnDigits =
      down.clientX >= digits.left - besideDigits && down.clientX <= digits.right + besideDigits
    if (!isOnDigits || !this.isClickable() || this.isBeingEdited_ || down.button !== 0) return
    onPull(down, () => {
      workspace.cancelCurrentGesture()
      const number = {
        literal: () => this.getValue() ?? "0",
        set: (literal: string) => this.setValue(literal),
      }
      if (this.fieldGroup_ !== null) dragNumber(this.fieldGroup_, down, number, this.actions.numbers)
    })
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
    if (this.kind === "number" && this.fieldGroup_ !== null) {
      Blockly.utils.dom.addClass(this.fieldGroup_, "rosyNumber")
      // Where the block is nothing but the number, the block takes its presses.
      const target = this.getClickTarget_() ?? this.fieldGroup_
      target.addEventListener("pointerdown", event => this.watch(event as PointerEvent))
    }
    // Widths are remembered by the text's own class, and types have a face of their own.
    if (this.textElement_ !== null) Blockly.utils.dom.addClass(this.textElement_, `${name}Text`)
  }
}

/// Whether a number is typed into a field.
export function isNumberField(field: unknown): field is Blockly.Field {
  return field instanceof TextField && field.kind === "number"
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
    onPull(down, move => this.actions.pulled(this, move))
  }
}
