/// Multi-line field for Haskell, drawn line by line in a fixed-width font and edited in a text area.
///
/// Enter inserts a line break; Escape cancels the edit; a click elsewhere or Ctrl+Enter commits it.

import * as Blockly from "blockly/core"

/// Pixels; the face is JetBrains Mono at 13 px, whose characters are 0.6 em wide.
const characterWidth = 7.8
const lineHeight = 19
const padding = {x: 11, y: 6}
/// An empty field is this wide, so that there is something to click.
const leastCharacters = 8

export class MultilineField extends Blockly.FieldTextInput {
  private lines: SVGGElement | undefined

  override initView(): void {
    this.createBorderRect_()
    this.lines = Blockly.utils.dom.createSvgElement(
      Blockly.utils.Svg.G,
      {class: "rosyCode"},
      this.fieldGroup_,
    )
    if (this.fieldGroup_ !== null) {
      Blockly.utils.dom.addClass(this.fieldGroup_, "blocklyField")
      Blockly.utils.dom.addClass(this.fieldGroup_, "blocklyInputField")
    }
    this.recomputeAriaContext()
  }

  override isFullBlockField(): boolean {
    return false
  }

  protected override doClassValidation_(text?: unknown): string | null {
    return typeof text === "string" ? text.replaceAll("\r\n", "\n").replaceAll("\t", "  ") : null
  }

  protected override render_(): void {
    const group = this.lines
    if (group === undefined) return
    const lines = this.getText().split("\n")
    group.replaceChildren(
      ...lines.map((line, at) => {
        const text = document.createElementNS("http://www.w3.org/2000/svg", "text")
        text.setAttribute("class", "blocklyText")
        text.setAttribute("x", `${padding.x}`)
        text.setAttribute("y", `${padding.y + lineHeight * (at + 0.5)}`)
        text.setAttribute("dominant-baseline", "central")
        text.setAttribute("aria-hidden", "true")
        text.textContent = line.replaceAll(" ", "\u00a0")
        return text
      }),
    )
    const width =
      Math.max(leastCharacters, ...lines.map(line => line.length)) * characterWidth + 2 * padding.x
    this.size_ = new Blockly.utils.Size(width, lines.length * lineHeight + 2 * padding.y)
    this.positionBorderRect_()
  }

  protected override widgetCreate_(): HTMLTextAreaElement {
    // The parent makes an input of one line and with it all that belongs to an open editor; only the element differs.
    const input = super.widgetCreate_() as HTMLInputElement
    this.unbindInputEvents_()
    const area = document.createElement("textarea")
    area.className = "blocklyHtmlInput rosyCodeInput"
    area.spellcheck = false
    area.setAttribute("aria-label", this.getAriaTypeName() ?? "Haskell")
    area.setAttribute("data-untyped-default-value", input.getAttribute("data-untyped-default-value") ?? "")
    area.value = area.defaultValue = this.getText()
    const scale = (this.getSourceBlock() as Blockly.BlockSvg).workspace.getAbsoluteScale()
    area.style.fontSize = `${13 * scale}px`
    area.style.lineHeight = `${lineHeight * scale}px`
    area.style.padding = `${padding.y * scale}px ${padding.x * scale}px`
    input.replaceWith(area)
    this.bindInputEvents_(area)
    return area
  }

  protected override onHtmlInputKeyDown_(event: KeyboardEvent): void {
    if (event.key === "Enter" && !event.ctrlKey && !event.metaKey) {
      event.stopPropagation()
      return
    }
    super.onHtmlInputKeyDown_(event)
  }
}
