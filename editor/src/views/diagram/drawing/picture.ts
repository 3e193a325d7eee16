/// The diagram as a file: an SVG that needs nothing else, also in programs that know no CSS, and a PNG of it.

import {fontFaces} from "./font_faces.ts"

/// Properties that the page's style sheet sets on the drawing. Each of them is an attribute of SVG 1.1 as well, apart from `paint-order`,
/// without which a label keeps its outline on top.
const properties = [
  "fill",
  "fill-opacity",
  "stroke",
  "stroke-opacity",
  "stroke-width",
  "stroke-dasharray",
  "stroke-linecap",
  "stroke-linejoin",
  "opacity",
  "font-family",
  "font-size",
  "font-weight",
  "text-anchor",
  "paint-order",
] as const

/// What an element has without the attribute.
const defaults: Readonly<Record<string, string>> = {
  "fill-opacity": "1",
  stroke: "none",
  "stroke-opacity": "1",
  "stroke-dasharray": "none",
  "stroke-linecap": "butt",
  "stroke-linejoin": "miter",
  opacity: "1",
  "paint-order": "normal",
}

/// What only the page uses.
const ofThePage = ["class", "style", "tabindex", "role", "aria-label", "data-node", "data-edge"]

/// The drawing with its colours on each element, on the colour of its background, and with the fonts of its texts.
export async function standalone(svg: SVGSVGElement, background: string): Promise<string> {
  const copy = svg.cloneNode(true) as SVGSVGElement
  const originals = [svg, ...svg.querySelectorAll<SVGElement>("*")]
  const copies = [copy, ...copy.querySelectorAll<SVGElement>("*")]
  originals.forEach((original, i) => {
    const target = copies[i]
    if (target === undefined) return
    copyStyle(original, target)
    const place = /^translate\((-?[\d.]+)px(?:, (-?[\d.]+)px)?\)$/.exec(original.style.transform)
    if (place !== null) target.setAttribute("transform", `translate(${place[1]} ${place[2] ?? 0})`)
    for (const name of ofThePage) target.removeAttribute(name)
  })
  const {x, y, width, height} = svg.viewBox.baseVal
  const paper = document.createElementNS(svg.namespaceURI, "rect")
  for (const [name, value] of Object.entries({x, y, width, height, fill: plainColour(background)}))
    paper.setAttribute(name, `${value}`)
  copy.prepend(paper)
  const fonts = await fontFaces(svg.querySelectorAll("text"))
  if (fonts !== "") {
    const sheet = document.createElementNS(svg.namespaceURI, "style")
    sheet.textContent = fonts
    copy.prepend(sheet)
  }
  copy.setAttribute("width", `${width}`)
  copy.setAttribute("height", `${height}`)
  return new XMLSerializer().serializeToString(copy)
}

/// Writes the style that an element has on the page into attributes of its copy.
export function copyStyle(original: SVGElement, copy: SVGElement): void {
  const style = getComputedStyle(original)
  const isText = original instanceof SVGTextElement || original instanceof SVGTSpanElement
  const isShape = original instanceof SVGGeometryElement
  for (const property of isText || isShape ? properties : []) {
    if (!isText && /^font|^text|^paint/.test(property)) continue
    const value = plainColour(style.getPropertyValue(property))
    if (value !== "" && value !== defaults[property]) copy.setAttribute(property, value)
  }
}

/// A mixed colour as the page computes it, `color(srgb 0.9 0.95 1)`, as `#e6f2ff`, which every program knows; any other value as it is.
export function plainColour(value: string): string {
  const mixed = /^color\(srgb ([\d.e-]+) ([\d.e-]+) ([\d.e-]+)\)$/.exec(value)
  if (mixed === null) return value
  const part = (share: string | undefined) =>
    Math.round(255 * Math.min(1, Math.max(0, Number(share))))
      .toString(16)
      .padStart(2, "0")
  return `#${part(mixed[1])}${part(mixed[2])}${part(mixed[3])}`
}

/// Pixels of a PNG for one pixel of the drawing.
const pngScale = 2

/// `null` when the browser cannot draw it.
export async function pngOf(svg: string): Promise<Blob | null> {
  const address = URL.createObjectURL(new Blob([svg], {type: "image/svg+xml"}))
  try {
    const image = new Image()
    image.src = address
    await image.decode()
    const canvas = document.createElement("canvas")
    canvas.width = image.width * pngScale
    canvas.height = image.height * pngScale
    canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height)
    return await new Promise(resolve => canvas.toBlob(resolve, "image/png"))
  } catch {
    return null
  } finally {
    URL.revokeObjectURL(address)
  }
}
