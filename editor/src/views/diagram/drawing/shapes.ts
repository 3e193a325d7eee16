/// Outlines of the diagram's nodes, as SVG paths around the origin of their box. Pure.

import type {DiagramNode} from "../network/network.ts"

/// Depth of the points of a hexagon and of a tag.
const point = 16

/// The outline of a node, and lines inside of it.
export function outlineOf(
  {kind}: Pick<DiagramNode, "kind">,
  w: number,
  h: number,
): {outline: string; inner: string} {
  switch (kind) {
    case "event":
    case "channel":
      return plain(`M${point} 0H${w - point}L${w} ${h / 2}L${w - point} ${h}H${point}L0 ${h / 2}z`)
    case "command":
      return plain(`M6 0H${w - point}L${w} ${h / 2}L${w - point} ${h}H6Q0 ${h} 0 ${h - 6}V6Q0 0 6 0z`)
    case "done":
      return {...plain(rounded(0, 0, w, h, 4)), inner: `M${w - 14} 8V${h - 8}M${w - 9} 8V${h - 8}`}
    case "state":
      return plain(rounded(0, 0, w, h, h / 2))
    case "sample":
      return plain(`M${w / 2 - 15} 15a15 15 0 1 0 30 0a15 15 0 1 0-30 0z`)
    case "store": {
      const r = 8
      const side = `M0 ${r}C0 ${-r / 3} ${w} ${-r / 3} ${w} ${r}V${h - r}C${w} ${h + r / 3} 0 ${h + r / 3} 0 ${h - r}z`
      return {outline: side, inner: `M0 ${r}C0 ${r * 2.3} ${w} ${r * 2.3} ${w} ${r}`}
    }
    case "either":
      return plain(`M0 ${h / 2}a${w / 2} ${w / 2} 0 1 0 ${w} 0a${w / 2} ${w / 2} 0 1 0-${w} 0z`)
    case "all":
      return plain(rounded(0, 0, w, h, 2))
    case "task":
    case "chart":
      return {...plain(rounded(0, 0, w, h, 12)), inner: kind === "task" ? rounded(4, 4, w - 8, h - 8, 9) : ""}
    default:
      return plain(rounded(0, 0, w, h, 10))
  }
}

const plain = (outline: string) => ({outline, inner: ""})

const rounded = (x: number, y: number, w: number, h: number, r: number) =>
  `M${x + r} ${y}H${x + w - r}Q${x + w} ${y} ${x + w} ${y + r}V${y + h - r}Q${x + w} ${y + h} ${x + w - r} ${y + h}H${x + r}Q${x} ${y + h} ${x} ${y + h - r}V${y + r}Q${x} ${y} ${x + r} ${y}z`

/// The sign in the circle of a sample: centred lines, in a box of 20 by 20.
export function signOf(type: string): string {
  switch (type) {
    case "()":
      // A metronome.
      return "M-4 7H4L2-7H-2zM0 3L5-5"
    case "StdGen":
      // A die.
      return "M-6-6H6V6H-6zM-3-3h.01M3 3h.01M3-3h.01M-3 3h.01M0 0h.01"
    default:
      // A clock.
      return "M0-7a7 7 0 1 0 .01 0zM0-4V0L3 2"
  }
}

/// The head of an arrow that ends at the origin and points to the right.
export const arrowHead = "M0 0L-9-4.5V4.5z"
