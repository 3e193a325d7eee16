/// Comment icon: a speech bubble with lines, by which its block can be dragged. Blockly's own icon is a question mark, which reads as "help".

import * as Blockly from "blockly/core"

const bubble =
  "M2.5 1h11a2 2 0 0 1 2 2v6.5a2 2 0 0 1 -2 2h-6l-3.5 3.5v-3.5h-1.5a2 2 0 0 1 -2 -2v-6.5a2 2 0 0 1 2 -2z"
const lines = "M4 4.4h8M4 7.8h5.5"

class SpeechBubbleIcon extends Blockly.icons.CommentIcon {
  override initView(...pointer: Parameters<Blockly.icons.CommentIcon["initView"]>): void {
    super.initView(...pointer)
    const root = this.svgRoot
    if (root === null || root.querySelector(".rosyRemark") !== null) return
    root.addEventListener("pointerdown", down => dragBlock(this.getSourceBlock(), down))
    drawSpeechBubble(root)
  }
}

/// Draws the speech bubble in the place of an icon's own symbols.
export function drawSpeechBubble(root: SVGGElement): void {
  const {dom, Svg} = Blockly.utils
  // The first shape stays: it carries the ring of the focus.
  for (const symbol of root.querySelectorAll(".blocklyIconSymbol")) symbol.remove()
  dom.createSvgElement(Svg.PATH, {class: "rosyRemark", d: bubble}, root)
  dom.createSvgElement(Svg.PATH, {class: "rosyRemarkLines", d: lines}, root)
}

/// Starts a drag of the block when the pointer moves after a press on its icon. Blockly drags the focused node; an icon cannot be dragged, so Blockly would scroll the
/// workspace instead.
function dragBlock(block: Blockly.Block, down: PointerEvent): void {
  if (!(block instanceof Blockly.BlockSvg) || block.isInFlyout) return
  const stop = new AbortController()
  const listen = {capture: true, signal: stop.signal}
  // Before Blockly hears of the same movement.
  window.addEventListener(
    "pointermove",
    move => {
      if (move.pointerId !== down.pointerId) return
      if (Math.hypot(move.clientX - down.clientX, move.clientY - down.clientY) <= Blockly.config.dragRadius)
        return
      stop.abort()
      if (!block.isDeadOrDying()) Blockly.getFocusManager().focusNode(block)
    },
    listen,
  )
  for (const over of ["pointerup", "pointercancel"]) window.addEventListener(over, () => stop.abort(), listen)
}

/// Tells Blockly about the icon; once for the page.
export function registerCommentIcon(): void {
  Blockly.registry.register(
    Blockly.registry.Type.ICON,
    SpeechBubbleIcon.TYPE.toString(),
    SpeechBubbleIcon,
    true,
  )
}
