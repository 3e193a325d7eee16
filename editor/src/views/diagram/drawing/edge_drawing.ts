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
export function drawEdge(edge: DiagramEdge, route: readonly Point[], toJoin: boolean): DrawnEdge {
  const group = svgElement("g", {class: `edge ${edge.role}${edge.perhaps ? " perhaps" : ""}`})
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
  const {x, y, room} = labelPlace(route)
  const text = svgElement("text", {class: "carried", x, y: y - 6})
  text.dataset["edge"] = edge.id
  const title = svgElement("title")
  group.append(title)
  return {group, text, title, most: Math.floor(room / valueCharWidth)}
}
