/// The line that says why a block does not fit: near the pointer, and to a screen reader.

import * as Blockly from "blockly/core"

/// Pixels between the pointer and the line, so that neither hand nor block covers it.
const away = {x: 18, y: 26}

export class RefusalLine {
  private readonly host: HTMLElement
  private readonly line: HTMLElement
  private said = ""
  private leaning: Blockly.BlockSvg | undefined

  constructor(host: HTMLElement) {
    this.host = host
    this.line = document.createElement("div")
    this.line.className = "rosyRefusal"
    // Blockly's live region speaks; this is for the eye.
    this.line.setAttribute("aria-hidden", "true")
    this.line.hidden = true
    host.append(this.line)
  }

  /// Shows `why` for the block that is being moved, at the pointer or else below the block.
  show(why: string, block: Blockly.BlockSvg, pointer: PointerEvent | undefined): void {
    if (why !== this.said) {
      this.said = why
      this.line.replaceChildren(...marked(why))
      Blockly.utils.aria.announceDynamicAriaState(why.replaceAll("`", ""))
    }
    this.line.hidden = false
    const frame = this.host.getBoundingClientRect()
    const at = pointer ?? below(block)
    const x = at.clientX - frame.left + away.x
    const y = at.clientY - frame.top + away.y
    this.line.style.left = `${Math.max(8, Math.min(x, frame.width - this.line.offsetWidth - 8))}px`
    this.line.style.top = `${Math.max(8, Math.min(y, frame.height - this.line.offsetHeight - 8))}px`
    // The block leans around its own corner; Blockly moves it with a transform, which CSS turns after rotating.
    const corner = block.getRelativeToSurfaceXY()
    block.getSvgRoot().style.transformOrigin = `${corner.x}px ${corner.y}px`
    if (this.leaning !== block) {
      this.leaning?.removeClass("rosyRefused")
      block.addClass("rosyRefused")
      this.leaning = block
    }
  }

  hide(): void {
    this.said = ""
    this.line.hidden = true
    this.leaning?.removeClass("rosyRefused")
    this.leaning = undefined
  }

  dispose(): void {
    this.hide()
    this.line.remove()
  }
}

function below(block: Blockly.BlockSvg): {clientX: number; clientY: number} {
  const box = block.getSvgRoot().getBoundingClientRect()
  return {clientX: box.left, clientY: box.bottom - away.y}
}

/// Words in backquotes are code.
export function marked(sentence: string): Node[] {
  return sentence.split("`").map((part, at) => {
    if (at % 2 === 0) return document.createTextNode(part)
    const code = document.createElement("code")
    code.textContent = part
    return code
  })
}
