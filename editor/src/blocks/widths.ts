/// How wide words on blocks are. Blockly measures each word where it stands, and each time the browser styles and lays out all that is new on the page: in
/// a program of 1,000 lines that is most of the time it takes to open it. Here a font is asked for once per kind of word, a word is measured once,
/// and on a canvas that is no part of the page.

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
export function rememberWidths(): void {
  Blockly.utils.dom.startTextWidthCache()
}

/// Widths measured before the fonts had arrived are wrong.
export function forgetWidths(): void {
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
