/// Diagram as SVG: a network at its layout, keyboard and pointer, and the activity of the run.

import {type DrawnEdge, drawEdge} from "./drawing/edge_drawing.ts"
import {type DrawnNode, drawNode, fitting} from "./drawing/node_drawing.ts"
import {svgElement} from "./drawing/svg_element.ts"
import type {DrawnDiagram, ViewOptions} from "./drawing/view_types.ts"
import {neighbour} from "./layout/keyboard_navigation.ts"
import type {Layout} from "./layout/layout.ts"
import {type Activity, type Appearance, appearanceOf, noActivity, textMs} from "./network/activity.ts"
import {type CausalPath, noPath} from "./network/causal_path.ts"
import {explained} from "./network/explained.ts"
import {firstOf, isContainer, isJoin, type Network, shortened, valuedNode} from "./network/network.ts"
import {outline} from "./network/outline.ts"

/// A drawing is scrolled before it becomes smaller than this share of its size, so that it can be read at arm's length.
const leastScale = 0.66

/// Free space around the drawing.
const border = 24

export function openDrawing(host: HTMLElement, options: ViewOptions): DrawnDiagram {
  const {words} = options
  const svg = svgElement("svg", {
    class: "diagram",
    role: "group",
    "aria-label": `${words.title}. ${words.keys}`,
  })
  const containers = svgElement("g")
  const edgeLayer = svgElement("g")
  const nodeLayer = svgElement("g")
  const labelLayer = svgElement("g", {class: "labels"})
  svg.append(containers, edgeLayer, nodeLayer, labelLayer)
  host.append(svg)

  let shownNetwork: Network = {nodes: [], edges: []}
  const nodes = new Map<string, DrawnNode>()
  const edges = new Map<string, DrawnEdge>()
  let current: string | null = null
  let selected: string | null = null
  let appearance: Appearance = appearanceOf(shownNetwork, noActivity, 0, words.rate)
  let places: Layout["boxes"] = new Map()
  let path: CausalPath = noPath
  /// When values were written last, in ms of the learner's time.
  let wroteAt = Number.NEGATIVE_INFINITY

  const show = (network: Network, layout: Layout) => {
    const focused = current !== null && nodes.get(current)?.group === document.activeElement
    shownNetwork = network
    places = layout.boxes
    const [w, h] = [layout.width + 2 * border, layout.height + 2 * border]
    svg.setAttribute("viewBox", `${-border} ${-border} ${w} ${h}`)
    svg.setAttribute("width", `${w}`)
    svg.setAttribute("height", `${h}`)
    svg.style.minWidth = `${w * leastScale}px`
    const before = new Map(nodes)
    nodes.clear()
    for (const node of network.nodes) {
      const box = layout.boxes.get(node.id)
      if (box === undefined) continue
      // A node that stays keeps its element, so that its way to another place can be seen.
      const known = before.get(node.id)
      const group = known?.group ?? svgElement("g")
      const drawn = drawNode(group, node, box, options)
      group.style.transform = `translate(${box.x}px, ${box.y}px)`
      if (known === undefined) (isContainer(node) && !node.folded ? containers : nodeLayer).append(group)
      nodes.set(node.id, drawn)
      before.delete(node.id)
    }
    for (const {group} of before.values()) group.remove()
    edgeLayer.replaceChildren()
    labelLayer.replaceChildren()
    edges.clear()
    for (const edge of network.edges) {
      const route = layout.routes.get(edge.id)
      if (route === undefined || route.length < 2) continue
      const drawn = drawEdge(edge, route, isJoin(network, edge.to))
      labelLayer.append(drawn.text)
      edgeLayer.append(drawn.group)
      edges.set(edge.id, drawn)
    }
    if (current === null || !nodes.has(current)) current = firstOf(network)?.id ?? null
    setTabStop()
    if (focused && current !== null) nodes.get(current)?.group.focus()
    appearance = {lit: new Set(), onEdges: new Map(), atNodes: new Map()}
    mark()
    describe()
  }

  /// What a screen reader says of each node.
  const describe = () => {
    const {marked} = explained(shownNetwork, path)
    for (const {id, text} of outline(shownNetwork, words.list, marked))
      nodes.get(id)?.group.setAttribute("aria-label", text)
  }

  /// Tab leads to the current node only; arrow keys lead to the others.
  const setTabStop = () => {
    for (const [id, {group}] of nodes)
      if (group.hasAttribute("tabindex")) group.tabIndex = id === current ? 0 : -1
  }

  const mark = () => {
    const {marked, lines} = explained(shownNetwork, path)
    for (const [id, {group}] of nodes) group.classList.toggle("why", marked.has(id))
    for (const [id, {group}] of edges) group.classList.toggle("why", lines.has(id))
    for (const {node, group} of nodes.values())
      group.classList.toggle(
        "selected",
        selected !== null && node.kind === "function" && node.key === selected,
      )
  }

  const live = (activity: Activity, now: number, atOnce: boolean) => {
    const next = appearanceOf(shownNetwork, activity, now, words.rate)
    const changed = (id: string) => next.lit.has(id) !== appearance.lit.has(id)
    for (const [id, {group}] of nodes) if (changed(id)) group.classList.toggle("lit", next.lit.has(id))
    for (const [id, {group}] of edges) if (changed(id)) group.classList.toggle("lit", next.lit.has(id))
    if (!atOnce && now - wroteAt < textMs) {
      appearance = {...appearance, lit: next.lit}
      return
    }
    for (const [id, {node, value}] of nodes) {
      const text = next.atNodes.get(id)
      if (value !== null && text !== appearance.atNodes.get(id))
        value.textContent = fitting(text ?? "", node, places.get(id)?.w ?? 0)
    }
    for (const [id, drawn] of edges) {
      const text = next.onEdges.get(id)
      if (text === appearance.onEdges.get(id)) continue
      drawn.text.textContent =
        text === undefined || drawn.most < leastLabel ? "" : shortened(text, drawn.most)
      drawn.title.textContent = text ?? ""
    }
    appearance = next
    wroteAt = now
    const pointedAt = nodes.get(told ?? "")
    if (pointedAt !== undefined) tell(pointedAt)
  }

  // Type and last value, when they are asked for.
  const tell = ({node, title}: DrawnNode) => {
    const type = node.kind === "function" ? options.typeOf(node) : node.key
    const value = appearance.atNodes.get(node.id) ?? options.lastOf(node)
    // Frames have every value of these.
    const isTold = node.kind === "event" || node.kind === "state" || node.kind === "store"
    const last = value !== null ? words.lastValue(value) : isTold ? words.notYet : null
    const messages = node.topic === null ? [] : [node.topic.name, node.topic.type]
    const text = [node.label, type === null ? null : words.type(type), ...messages, last]
      .filter(Boolean)
      .join("\n")
    if (title.textContent !== text) title.textContent = text
  }
  /// The node that the pointer or the keyboard came to last.
  let told: string | null = null
  const point = (event: Event) => {
    const drawn = nodeOf(event.target)
    told = drawn?.node.id ?? null
    if (drawn !== null) tell(drawn)
  }
  svg.addEventListener("pointerover", point)
  svg.addEventListener("focusin", point)
  const nodeOf = (target: EventTarget | null): DrawnNode | null => {
    const group = target instanceof Element ? target.closest<SVGGElement>("[data-node]") : null
    return nodes.get(group?.dataset.node ?? "") ?? null
  }
  const choose = (drawn: DrawnNode) => {
    current = drawn.node.id
    setTabStop()
    if (drawn.node.folded) options.toggled(drawn.node.id)
    else options.chosen(drawn.node)
  }
  svg.addEventListener("click", event => {
    const valued = valuedAt(event.target)
    if (valued !== null) options.valueClicked(valued.node)
    const drawn = valued ?? nodeOf(event.target)
    if (drawn?.group.hasAttribute("tabindex")) choose(drawn)
  })
  /// The node whose value is written at a place: on the node itself, or on an edge.
  const valuedAt = (target: EventTarget | null): DrawnNode | null => {
    const text = target instanceof Element ? target.closest<SVGTextElement>("text.value, text.carried") : null
    if (text === null || text.textContent === "") return null
    const edge = shownNetwork.edges.find(one => one.id === text.dataset["edge"])
    return edge === undefined ? nodeOf(text) : (nodes.get(valuedNode(shownNetwork, edge)) ?? null)
  }
  svg.addEventListener("keydown", event => {
    const drawn = nodeOf(event.target)
    if (drawn === null || event.ctrlKey || event.metaKey || event.altKey) return
    if (event.key === "Enter" || event.key === " ") choose(drawn)
    else {
      const {marked} = explained(shownNetwork, path)
      const next = neighbour(shownNetwork, places, drawn.node, event.key, marked)
      if (next === null) return
      nodes.get(next)?.group.focus()
    }
    event.preventDefault()
    event.stopPropagation()
  })
  svg.addEventListener("focusin", event => {
    const drawn = nodeOf(event.target)
    if (drawn === null) return
    current = drawn.node.id
    setTabStop()
  })

  return {
    svg,
    show,
    live,
    select(name) {
      if (name === selected) return
      selected = name
      mark()
    },
    explain(next) {
      path = next
      mark()
      describe()
    },
  }
}

/// Characters below which nothing is written on an edge.
const leastLabel = 4
