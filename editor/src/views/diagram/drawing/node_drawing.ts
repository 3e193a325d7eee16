/// Drawing of a node of the diagram: outline, name, value, and the button that folds a container.

import {topicText} from "../layout/geometry.ts"
import {type DiagramNode, isContainer, shortened} from "../network/network.ts"
import type {OutlineWords} from "../network/outline.ts"
import {outlineOf, signOf} from "./shapes.ts"
import {svgElement} from "./svg_element.ts"
import type {ViewOptions} from "./view_types.ts"

export interface DrawnNode {
  readonly node: DiagramNode
  readonly group: SVGGElement
  readonly title: SVGTitleElement
  readonly value: SVGTextElement | null
}

/// Draws a node into its group.
export function drawNode(
  group: SVGGElement,
  node: DiagramNode,
  {w, h}: {readonly w: number; readonly h: number},
  {words, toggled}: ViewOptions,
): DrawnNode {
  const isOpen = isContainer(node) && !node.folded
  const joins = node.kind === "either" || node.kind === "all"
  group.replaceChildren()
  group.setAttribute("class", classesOf(node))
  group.dataset.node = node.id
  const {outline: around, inner} = outlineOf(node, w, h)
  group.append(svgElement("path", {class: "outline", d: around}))
  if (inner !== "") group.append(svgElement("path", {class: "inner", d: inner}))
  const title = svgElement("title")
  delete group.dataset["end"]
  if (joins) return {node, group, title, value: null}
  const type = typeOfEnd(node)
  if (type !== null) {
    group.dataset["end"] = node.kind
    group.dataset["type"] = type
  }
  group.setAttribute("role", "button")
  group.tabIndex = -1
  group.append(title)
  let value: SVGTextElement | null = null
  const text = (content: string, x: number, y: number, name: string) => {
    const made = svgElement("text", {class: name, x, y})
    made.textContent = content
    group.append(made)
    return made
  }
  if (node.kind === "sample") {
    group.append(
      svgElement("path", {class: "sign", d: signOf(node.key), transform: `translate(${w / 2} 15)`}),
    )
    text(node.key === "()" ? words.list.tick : node.label, w / 2, h, "small")
  } else if (isContainer(node)) {
    text(containerTitle(node, words.list), 14, isOpen ? 23 : h / 2 + 5, "name start")
    const toggle = svgElement("g", {
      class: "toggle",
      transform: `translate(${w - 24} ${isOpen ? 18 : h / 2})`,
    })
    toggle.append(
      svgElement("circle", {r: 9}),
      svgElement("path", {d: node.folded ? "M-4 0H4M0-4V4" : "M-4 0H4"}),
    )
    const named = svgElement("title")
    named.textContent = node.folded ? words.unfold(node.label) : words.foldUp(node.label)
    toggle.append(named)
    toggle.addEventListener("click", event => {
      event.stopPropagation()
      toggled(node.id)
    })
    group.append(toggle)
  } else if (node.kind === "store") {
    text(node.label, w / 2, 32, "name")
    value = text("", w / 2, 51, "value")
  } else {
    const shift = node.kind === "command" || node.kind === "done" ? w / 2 - 5 : w / 2
    const topic = topicText(node)
    text(node.contested ? `⚠ ${node.label}` : node.label, shift, h / 2 + (topic === null ? 5 : -3), "name")
    if (topic !== null) text(topic, shift, h / 2 + 14, "small")
    if (node.kind !== "function") value = text("", w / 2, h + 15, "value")
  }
  return {node, group, title, value}
}

/// What a connection that begins or ends at a node is about: the name of a function, a type as the program writes it, or the block of a step.
function typeOfEnd({kind, key, label, block}: DiagramNode): string | null {
  if (block !== null) return block
  if (isContainer({kind}) || kind === "step" || kind === "done") return null
  return kind === "function" || key === "()" ? key : label
}

function classesOf(node: DiagramNode): string {
  const trigger = node.trigger === null ? "" : ` by-${node.trigger}`
  return `node ${node.kind}${trigger}${node.contested ? " contested" : ""}${isContainer(node) && !node.folded ? " open" : ""}`
}

function containerTitle(node: DiagramNode, words: OutlineWords): string {
  const kind =
    node.chart === null
      ? words.kinds.task
      : node.turns === null
        ? words.charts[node.chart]
        : words.times(node.turns)
  return node.label === "" ? kind : node.kind === "task" ? node.label : `${node.label}: ${kind}`
}

/// Mean advance of a character of a value, at 12 px.
export const valueCharWidth = 7.3

/// A value as long as its node is wide, with some to spare; what it repeats of the node's name is left out.
export function fitting(value: string, node: DiagramNode, width: number): string {
  const most = Math.max(9, Math.floor((width + (node.kind === "store" ? -12 : 56)) / valueCharWidth))
  const own = value.startsWith(`${node.label} `) ? value.slice(node.label.length + 1) : value
  return shortened(own, most)
}
