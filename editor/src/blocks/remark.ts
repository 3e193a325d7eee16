/// The icon of a comment: a speech bubble with lines, where Blockly has a question mark, which reads as "help".

import * as Blockly from "blockly/core"

const bubble =
  "M2.5 1h11a2 2 0 0 1 2 2v6.5a2 2 0 0 1 -2 2h-6l-3.5 3.5v-3.5h-1.5a2 2 0 0 1 -2 -2v-6.5a2 2 0 0 1 2 -2z"
const lines = "M4 4.4h8M4 7.8h5.5"

class Remark extends Blockly.icons.CommentIcon {
  override initView(...pointer: Parameters<Blockly.icons.CommentIcon["initView"]>): void {
    super.initView(...pointer)
    const root = this.svgRoot
    if (root === null || root.querySelector(".rosyRemark") !== null) return
    const {dom, Svg} = Blockly.utils
    // The first shape stays: it carries the ring of the focus.
    for (const symbol of root.querySelectorAll(".blocklyIconSymbol")) symbol.remove()
    dom.createSvgElement(Svg.PATH, {class: "rosyRemark", d: bubble}, root)
    dom.createSvgElement(Svg.PATH, {class: "rosyRemarkLines", d: lines}, root)
  }
}

/// Tells Blockly about the icon; once for the page.
export function registerRemark(): void {
  Blockly.registry.register(Blockly.registry.Type.ICON, Remark.TYPE.toString(), Remark, true)
}
