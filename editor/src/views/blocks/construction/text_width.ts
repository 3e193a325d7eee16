/// Text width cache for labels on blocks.
///
/// Blockly measures each label in the page, and each measurement makes the browser compute the layout of all new elements: with 1,000 lines that is most of the loading
/// time. Here a font is looked up once per kind of label, and each text is measured once, on a canvas outside of the page.

import * as Blockly from "blockly/core"

interface Font {
  readonly css: string
  /// By the text.
  readonly widths: Map<string, number>
}

/// By the classes of a text and of its field.
const fonts = new Map<string, Font>()

let canvas: OffscreenCanvasRenderingContext2D | null = null

/// Blockly's own memory of widths, for what it measures itself (menus); it is kept from the first block on.
export function startWidthCache(): void {
  Blockly.utils.dom.startTextWidthCache()
}

/// Widths measured before the fonts had arrived are wrong.
export function clearWidthCache(): void {
  Blockly.utils.dom.stopTextWidthCache()
  Blockly.utils.dom.startTextWidthCache()
  fonts.clear()
}

/// The width of a text on a block, in pixels; as Blockly has it, in whole ones.
export function widthOf(text: SVGTextElement | null): number {
  const words = text?.textContent ?? ""
  if (text === null || words === "") return 0
  const key = `${text.getAttribute("class")}\n${text.parentElement?.getAttribute("class")}`
  let font = fonts.get(key)
  if (font === undefined) {
    const {fontSize, fontWeight, fontFamily} = getComputedStyle(text)
    font = {css: `${fontWeight} ${fontSize} ${fontFamily}`, widths: new Map()}
    // Outside the page a text has no font yet.
    if (fontSize === "") return 0
    fonts.set(key, font)
  }
  let width = font.widths.get(words)
  if (width === undefined) {
    canvas ??= new OffscreenCanvas(1, 1).getContext("2d")
    if (canvas === null) return 0
    canvas.font = font.css
    width = Math.ceil(canvas.measureText(words).width)
    font.widths.set(words, width)
  }
  return width
}
