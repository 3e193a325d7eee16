/// Base of the fields of blocks: what they report, and how a field with a text gets its size.

import * as Blockly from "blockly/core"
import type {NumberDragListener} from "../../../browser/number_grip.ts"
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
export function fit(field: Blockly.Field, margin?: number, lower?: number, least = 0): void {
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

/// A field of one line that is typed into.
export class SingleLineField extends Blockly.FieldTextInput {
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
