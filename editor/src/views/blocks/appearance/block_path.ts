/// Path of a block in SVG: adds a ring around memory, hints in empty sockets, and their names for screen readers.

import * as Blockly from "blockly/core"

/// What a socket or the end of a stack is called; the end of a stack that stands free is no place to fill.
function placeName(connection: Blockly.RenderedConnection): string | undefined {
  const input = connection.getParentInput()
  if (input !== null) return input.getAriaLabelText() ?? Blockly.Msg.INPUT_LABEL_EMPTY
  const around = connection.getSourceBlock().getTopStackBlock().previousConnection?.targetConnection
  const stack = around?.getParentInput()?.getAriaLabelText()
  return stack == null ? undefined : Blockly.Msg.INPUT_LABEL_END_STATEMENT?.replace("%1", stack)
}

/// Adds to a block's picture what zelos has not: a ring around memory, hints in empty sockets.
export class BlockPath extends Blockly.zelos.PathObject {
  private ring: SVGElement | undefined
  private readonly hints = new Map<string, SVGTextElement>()
  private used = new Set<string>()

  override setPath(path: string): void {
    super.setPath(path)
    this.ring?.setAttribute("d", path)
  }

  override flipRTL(): void {
    super.flipRTL()
    this.ring?.setAttribute("transform", "scale(-1 1)")
  }

  override applyColour(block: Blockly.BlockSvg): void {
    super.applyColour(block)
    this.paintRing()
  }

  override beginDrawing(): void {
    super.beginDrawing()
    this.used = new Set()
  }

  override endDrawing(): void {
    super.endDrawing()
    for (const [name, text] of this.hints) {
      if (this.used.has(name)) continue
      text.remove()
      this.hints.delete(name)
    }
  }

  /// Blockly names a place when the keyboard focus comes to it. Touch exploration and the reading cursor of a screen reader also find the
  /// empty places, and skip ends of stacks that stand free.
  override addConnectionHighlight(
    ...drawn: Parameters<Blockly.zelos.PathObject["addConnectionHighlight"]>
  ): SVGElement {
    const place = super.addConnectionHighlight(...drawn)
    const [connection] = drawn
    const empty = connection.isSuperior() && connection.targetBlock() === null
    const name = empty ? placeName(connection) : undefined
    if (name === undefined) place.setAttribute("aria-hidden", "true")
    else {
      place.removeAttribute("aria-hidden")
      place.setAttribute("aria-label", name)
    }
    return place
  }

  /// The second line of memory and Maybe: a wider copy behind the block.
  setRing(wanted: boolean): void {
    this.setClass_("rosyRinged", wanted)
    if (wanted && this.ring === undefined) {
      this.ring = Blockly.utils.dom.createSvgElement(Blockly.utils.Svg.PATH, {class: "rosyRing"})
      this.svgRoot.insertBefore(this.ring, this.svgPath)
      this.paintRing()
    } else if (!wanted && this.ring !== undefined) {
      this.ring.remove()
      this.ring = undefined
    }
  }

  private paintRing(): void {
    this.ring?.setAttribute("fill", this.style.colourPrimary)
    this.ring?.setAttribute("stroke", this.style.colourPrimary)
  }

  /// The text element of a hint; made when first measured, gone when its socket is filled.
  hint(name: string, words: string): SVGTextElement {
    this.used.add(name)
    let text = this.hints.get(name)
    if (text === undefined) {
      text = Blockly.utils.dom.createSvgElement(
        Blockly.utils.Svg.TEXT,
        {class: "rosyHint", "dominant-baseline": "central", "aria-hidden": "true"},
        this.svgRoot,
      )
      this.hints.set(name, text)
    }
    if (text.textContent !== words) text.textContent = words
    // Empty sockets are drawn into the same group; the word belongs on top of them.
    this.svgRoot.appendChild(text)
    return text
  }
}
