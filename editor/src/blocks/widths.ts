/// How wide words on blocks are. Blockly asks the browser for the font of each word before it measures it, and each time the browser lays out
/// every block anew: in a program of 1,000 lines that is most of the time it takes to open it. Here a font is asked for once per kind
/// of word, and a word is measured once.

import * as Blockly from "blockly/core"

interface Font {
  readonly size: string
  readonly weight: string
  readonly family: string
}

/// By the classes of a text and of its field.
const fonts = new Map<string, Font>()

/// Blockly's own memory of widths, by text and class; it is kept from the first block on.
export function rememberWidths(): void {
  Blockly.utils.dom.startTextWidthCache()
}

/// Widths measured before the fonts had arrived are wrong.
export function forgetWidths(): void {
  Blockly.utils.dom.stopTextWidthCache()
  Blockly.utils.dom.startTextWidthCache()
  fonts.clear()
}

/// Measures a text so that Blockly finds its width when it asks.
export function measure(text: SVGTextElement | null): void {
  if (text === null) return
  const key = `${text.getAttribute("class")}\n${text.parentElement?.getAttribute("class")}`
  let font = fonts.get(key)
  if (font === undefined) {
    const style = getComputedStyle(text)
    // Outside the page a text has no font yet.
    if (style.fontSize === "") return
    font = {size: style.fontSize, weight: style.fontWeight, family: style.fontFamily}
    fonts.set(key, font)
  }
  Blockly.utils.dom.getFastTextWidthWithSizeString(text, font.size, font.weight, font.family)
}
