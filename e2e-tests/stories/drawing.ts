/// What a drawn diagram shows, read from the page and from files: texts and shapes with their colours and places, and pixels.

import type {Page} from "@playwright/test"

/// Texts and shapes in the order in which they are drawn: colours as `rgb`, places in units of the drawing.
export function drawnParts(page: Page): Promise<readonly string[]> {
  return page.evaluate(() => {
    const svg = document.querySelector<SVGSVGElement>("svg.diagram, svg:root")
    if (svg === null) throw new Error("expected a drawing, found none")
    const context = document.createElementNS("http://www.w3.org/1999/xhtml", "canvas") as HTMLCanvasElement
    const canvas = context.getContext("2d", {willReadFrequently: true})
    const colour = (css: string) => {
      if (css === "none" || canvas === null) return "none"
      canvas.fillStyle = css
      canvas.fillRect(0, 0, 1, 1)
      return [...canvas.getImageData(0, 0, 1, 1).data.slice(0, 3)].join(" ")
    }
    const all = [...svg.querySelectorAll<SVGGraphicsElement>("text, path, circle")]
    return all.flatMap(element => {
      const text = element.localName === "text" ? element.textContent : element.getAttribute("d")
      if (text === "") return []
      const style = getComputedStyle(element)
      // Letters have other sizes on the screen, where the page draws it smaller: the place is where a text or a path begins.
      const start = new DOMPoint(Number(element.getAttribute("x")), Number(element.getAttribute("y")))
      const units = svg
        .getScreenCTM()
        ?.inverse()
        .multiply(element.getScreenCTM() ?? new DOMMatrix())
      const {x, y} = start.matrixTransform(units)
      // Not halfway between two whole numbers.
      const place = [x, y].map(one => Math.round(one + 0.013))
      const {width: wide, height: high} = element.getBoundingClientRect()
      const isEmpty = wide === 0 && high === 0
      const width = Math.round(style.strokeWidth === "" ? 0 : Number.parseFloat(style.strokeWidth) * 10) / 10
      const fonts =
        element.localName === "text" ? `${style.fontSize} ${style.fontWeight} ${style.fontFamily}` : ""
      return `${text}${isEmpty ? " (not visible)" : ""} fill ${colour(style.fill)} stroke ${colour(style.stroke)} ${width} ${fonts} at ${place.join(" ")}`
    })
  })
}

export interface DrawnPoint {
  readonly what: string
  /// Units of the drawing, from its left upper corner.
  readonly x: number
  readonly y: number
  readonly colour: string
}

/// Points on the outlines of the page's nodes, and within functions, events and commands above their names, with their colours.
export function drawnPoints(page: Page): Promise<readonly DrawnPoint[]> {
  return page.evaluate(() => {
    const svg = document.querySelector<SVGSVGElement>("svg.diagram")
    if (svg === null) throw new Error("expected a diagram, found none")
    const {x: left, y: top} = svg.viewBox.baseVal
    const canvas = document.createElement("canvas").getContext("2d", {willReadFrequently: true})
    const colour = (css: string) => {
      if (canvas === null) return ""
      canvas.fillStyle = css
      canvas.fillRect(0, 0, 1, 1)
      return [...canvas.getImageData(0, 0, 1, 1).data.slice(0, 3)].join(" ")
    }
    return [...svg.querySelectorAll<SVGPathElement>(".node > path.outline")].flatMap(outline => {
      const group = outline.parentElement as unknown as SVGGElement
      const [dx = 0, dy = 0] = (/\(([^)]*)\)/.exec(group.style.transform)?.[1] ?? "")
        .split(",")
        .map(Number.parseFloat)
      const name = group.querySelector("text")?.textContent ?? ""
      const style = getComputedStyle(outline)
      const {width} = outline.getBBox()
      const kind = group.classList[1] ?? ""
      const inside = ["function", "event", "command"].includes(kind)
        ? [{what: `inside ${name}`, x: dx + width / 2 - left, y: dy + 7 - top, colour: colour(style.fill)}]
        : []
      if (style.stroke === "none" || style.strokeDasharray !== "none") return inside
      // On the upper edge, a little right of its beginning.
      const {x, y} = outline.getPointAtLength(4)
      const edge = {
        what: `outline of ${name}`,
        x: dx + x - left,
        y: dy + y - top,
        colour: colour(style.stroke),
      }
      return [edge, ...inside]
    })
  })
}

/// The colours of a picture at these points, in the form of their own ones: a colour that is as good as equal is equal.
export function pixelsOf(page: Page, png: Buffer, points: readonly DrawnPoint[]): Promise<readonly string[]> {
  return page.evaluate(
    async ({data, points}) => {
      const bytes = Uint8Array.from(atob(data), letter => letter.charCodeAt(0))
      const image = await createImageBitmap(new Blob([bytes], {type: "image/png"}))
      const canvas = document.createElement("canvas")
      canvas.width = image.width
      canvas.height = image.height
      const context = canvas.getContext("2d", {willReadFrequently: true})
      if (context === null) throw new Error("expected a canvas with a 2d context, found none")
      context.drawImage(image, 0, 0)
      return points.map(({what, x, y, colour}) => {
        const pixel = [...context.getImageData(Math.floor(2 * x), Math.floor(2 * y), 1, 1).data.slice(0, 3)]
        const wanted = colour.split(" ").map(Number)
        const isEqual = pixel.every((part, i) => Math.abs(part - (wanted[i] ?? 0)) <= 8)
        return `${what}: ${isEqual ? colour : pixel.join(" ")}`
      })
    },
    {data: png.toString("base64"), points},
  )
}
