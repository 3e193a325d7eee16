/// Drawing of an edge of the diagram: line, head, order among several senders, and the text that it carries.

import {labelPlace, type Point, pathOf} from "../layout/geometry.ts"
import type {DiagramEdge} from "../network/network.ts"
import {valueCharWidth} from "./node_drawing.ts"
import {arrowHead} from "./shapes.ts"
import {svgElement} from "./svg_element.ts"

export interface DrawnEdge {
  readonly group: SVGGElement
  readonly text: SVGTextElement
  /// The whole of what the edge carries, for a pointer that rests on it.
  readonly title: SVGTitleElement
  /// Characters for which there is room on the edge.
  readonly most: number
}

/// Draws an edge along its route; one that ends at a join has no head.
/// `after` is the block of the step that an arrow between two leaves: what is dropped on the arrow goes behind it.
export function drawEdge(
  edge: DiagramEdge,
  route: readonly Point[],
  toJoin: boolean,
  after: string | null,
): DrawnEdge {
  const group = svgElement("g", {class: `edge ${edge.role}${edge.perhaps ? " perhaps" : ""}`})
  if (after !== null) {
    group.dataset.end = "step"
    group.dataset.type = after
    group.append(svgElement("path", {class: "grip", d: pathOf(route)}))
  }
  group.append(svgElement("path", {class: "line", d: pathOf(route)}))
  const end = route.at(-1) ?? {x: 0, y: 0}
  const before = route.at(-2) ?? end
  const angle = (Math.atan2(end.y - before.y, end.x - before.x) * 180) / Math.PI
  if (!toJoin)
    group.append(
      svgElement("path", {
        class: "head",
        d: arrowHead,
        transform: `translate(${end.x} ${end.y}) rotate(${angle})`,
      }),
    )
  if (edge.optional)
    group.append(svgElement("circle", {class: "ring", r: 4.5, cx: end.x - (toJoin ? 6 : 15), cy: end.y}))
  if (edge.order !== null) {
    const number = svgElement("text", {class: "order", x: end.x - 16, y: end.y - 6})
    number.textContent = `${edge.order}`
    group.append(number)
  }
  if (edge.label !== null) {
    const [a, b] = [route.at(-2) ?? end, end]
    const isDown = Math.abs(a.x - b.x) < 1
    const label = svgElement("text", {
      class: "ending",
      x: isDown ? a.x + 8 : (a.x + b.x) / 2,
      y: isDown ? (a.y + b.y) / 2 + 4 : b.y - 6,
    })
    label.textContent = edge.label
    group.append(label)
  }
  const {x, y, room} = labelPlace(route)
  const text = svgElement("text", {class: "carried", x, y: y - 6})
  text.dataset["edge"] = edge.id
  const title = svgElement("title")
  group.append(title)
  return {group, text, title, most: Math.floor(room / valueCharWidth)}
}
