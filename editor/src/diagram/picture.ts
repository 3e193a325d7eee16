/// The diagram as a file: an SVG that needs no style sheet, and a PNG of it.

/// Properties that the page's style sheet sets on the drawing.
const properties = [
  "fill",
  "fill-opacity",
  "stroke",
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
  "transform",
] as const

/// The drawing with its colours on each element, on the colour of its background.
export function standalone(svg: SVGSVGElement, background: string): string {
  const copy = svg.cloneNode(true) as SVGSVGElement
  const originals = [svg, ...svg.querySelectorAll<SVGElement>("*")]
  const copies = [copy, ...copy.querySelectorAll<SVGElement>("*")]
  originals.forEach((original, i) => {
    const style = getComputedStyle(original)
    const target = copies[i]
    if (target === undefined) return
    for (const property of properties) {
      const value = style.getPropertyValue(property)
      if ((value !== "" && value !== "none") || property === "fill" || property === "stroke")
        target.style.setProperty(property, value)
    }
    for (const name of ["class", "tabindex", "role", "data-node"]) target.removeAttribute(name)
  })
  const box = svg.viewBox.baseVal
  const paper = document.createElementNS(svg.namespaceURI, "rect")
  for (const [name, value] of Object.entries({
    x: box.x,
    y: box.y,
    width: box.width,
    height: box.height,
    fill: background,
  }))
    paper.setAttribute(name, `${value}`)
  copy.prepend(paper)
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg")
  copy.setAttribute("width", `${box.width}`)
  copy.setAttribute("height", `${box.height}`)
  copy.style.removeProperty("transform")
  return new XMLSerializer().serializeToString(copy)
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
