/// The blocks of the workspace as an SVG that needs neither the style sheets nor the fonts of the page.

import {blockDrawing} from "../../browser/printing.ts"
import {copyStyle} from "../../views/diagram/drawing/picture.ts"

/// Attributes of Blockly's elements that draw: the others name and describe them for the workspace.
const drawing = new Set([
  "xmlns",
  "viewBox",
  "width",
  "height",
  "x",
  "y",
  "x1",
  "x2",
  "y1",
  "y2",
  "cx",
  "cy",
  "r",
  "rx",
  "ry",
  "d",
  "points",
  "transform",
  "dominant-baseline",
])

/// `null` without blocks. `label` describes the drawing to a reader who does not see it.
export function standaloneBlocks(host: HTMLElement, label: string): string | null {
  const svg = blockDrawing(host, (original, copy) => {
    const originals = [...original.querySelectorAll<SVGElement>("*")]
    const copies = [...copy.querySelectorAll<SVGElement>("*")]
    originals.forEach((one, i) => {
      const target = copies[i]
      if (target !== undefined) adopt(one, target)
    })
  })
  if (svg === null) return null
  // Patterns of the workspace's background and filters of its effects.
  for (const defs of svg.querySelectorAll(":scope > defs")) defs.remove()
  keepDrawing(svg)
  svg.setAttribute("role", "img")
  svg.setAttribute("aria-label", label)
  return new XMLSerializer().serializeToString(svg)
}

function adopt(original: SVGElement, copy: SVGElement): void {
  const style = getComputedStyle(original)
  // Buttons on blocks do nothing in a drawing; a picture has an address that the file may not load.
  if (style.display === "none" || original.matches(".rosyPress, image, foreignObject")) {
    copy.remove()
    return
  }
  // The font of another computer has other widths; the text keeps its place between the fields beside it.
  const width = original instanceof SVGTextElement ? original.getComputedTextLength() : 0
  const anchor = original.getAttribute("text-anchor")
  keepDrawing(copy)
  if (anchor !== null) copy.setAttribute("text-anchor", anchor)
  copyStyle(original, copy)
  if (width > 0) {
    copy.setAttribute("textLength", width.toFixed(1))
    copy.setAttribute("lengthAdjust", "spacingAndGlyphs")
  }
}

function keepDrawing(element: SVGElement): void {
  for (const name of element.getAttributeNames())
    if (!drawing.has(name) && !name.startsWith("xmlns")) element.removeAttribute(name)
}
