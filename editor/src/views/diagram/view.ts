/// Diagram as SVG: a network at its layout, keyboard and pointer, and the activity of the run.

import {type DrawnEdge, drawEdge} from "./drawing/edge_drawing.ts"
import {openNodeDrag} from "./drawing/node_drag.ts"
import {type DrawnNode, drawNode, fitting} from "./drawing/node_drawing.ts"
import {openPinchZoom, type PinchZoom} from "./drawing/pinch_zoom.ts"
import {svgElement} from "./drawing/svg_element.ts"
import type {DrawnDiagram, ViewOptions} from "./drawing/view_types.ts"
import type {Point} from "./layout/geometry.ts"
import {neighbour} from "./layout/keyboard_navigation.ts"
import type {Layout} from "./layout/layout.ts"
import {type Activity, type Appearance, appearanceOf, noActivity, textMs} from "./network/activity.ts"
import {type CausalPath, noPath} from "./network/causal_path.ts"
import {explained} from "./network/explained.ts"
import {firstOf, isContainer, isJoin, type Network, shortened, valuedNode} from "./network/network.ts"
import {contestedText, outline} from "./network/outline.ts"

/// A drawing is scrolled before it becomes smaller than this share of its size, so that it can be read at arm's length; for fingers, so that they meet its
/// nodes.
const leastScale = matchMedia("(pointer: coarse)").matches ? 1 : 0.66

/// Free space around the drawing.
const border = 24

export const openDrawing = (host: HTMLElement, options: ViewOptions): DrawnDiagram =>
  new SvgDiagram(host, options)

class SvgDiagram implements DrawnDiagram {
  readonly svg: SVGSVGElement
  private readonly options: ViewOptions
  private readonly zoom: PinchZoom
  private readonly containers = svgElement("g")
  private readonly edgeLayer = svgElement("g")
  private readonly nodeLayer = svgElement("g")
  private readonly labelLayer = svgElement("g", {class: "labels"})
  private readonly nodes = new Map<string, DrawnNode>()
  private readonly edges = new Map<string, DrawnEdge>()
  private network: Network = {nodes: [], edges: []}
  private places: Layout["boxes"] = new Map()
  private appearance: Appearance
  /// The node that Tab leads to, and the function that is selected on the page.
  private current: string | null = null
  private selected: string | null = null
  private selectedBlock: string | null = null
  /// The node that the pointer or the keyboard came to last.
  private pointedAt: string | null = null
  private path: CausalPath = noPath
  private isMoving = false
  /// When values were written last, in ms of the learner's time.
  private wroteAt = Number.NEGATIVE_INFINITY

  constructor(host: HTMLElement, options: ViewOptions) {
    const {words} = options
    this.options = options
    this.appearance = appearanceOf(this.network, noActivity, 0, words.rate)
    this.svg = svgElement("svg", {
      class: "diagram",
      role: "group",
      "aria-label": `${words.title}. ${words.keys}`,
    })
    this.svg.append(this.containers, this.edgeLayer, this.nodeLayer, this.labelLayer)
    host.append(this.svg)
    this.zoom = openPinchZoom(host, this.svg, width => {
      this.svg.style.minWidth = `${width * leastScale}px`
    })
    this.svg.addEventListener("pointerover", event => this.point(event.target))
    this.svg.addEventListener("focusin", event => {
      this.point(event.target)
      this.makeCurrent(this.nodeOf(event.target))
    })
    this.svg.addEventListener("click", event => this.click(event.target))
    openNodeDrag(this.svg, {isOn: () => this.isMoving, moved: (id, by) => options.moved(id, by)})
    this.svg.addEventListener("keydown", event => this.press(event))
  }

  show(network: Network, layout: Layout): void {
    const focused = this.current !== null && this.groupOf(this.current) === document.activeElement
    this.network = network
    this.places = layout.boxes
    const [w, h] = [layout.width + 2 * border, layout.height + 2 * border]
    this.svg.setAttribute("viewBox", `${-border} ${-border} ${w} ${h}`)
    this.svg.setAttribute("width", `${w}`)
    this.svg.setAttribute("height", `${h}`)
    this.zoom.apply(w)
    this.drawNodes(layout)
    this.drawEdges(layout)
    if (this.current === null || !this.nodes.has(this.current)) this.current = firstOf(network)?.id ?? null
    this.setTabStop()
    if (focused && this.current !== null) this.groupOf(this.current)?.focus()
    this.appearance = {lit: new Set(), onEdges: new Map(), atNodes: new Map()}
    this.mark()
    this.describe()
  }

  live(activity: Activity, now: number, atOnce: boolean): void {
    const {appearance, nodes, edges} = this
    const next = appearanceOf(this.network, activity, now, this.options.words.rate)
    const changed = (id: string) => next.lit.has(id) !== appearance.lit.has(id)
    for (const [id, {group}] of nodes) if (changed(id)) group.classList.toggle("lit", next.lit.has(id))
    for (const [id, {group}] of edges) if (changed(id)) group.classList.toggle("lit", next.lit.has(id))
    if (!atOnce && now - this.wroteAt < textMs) {
      this.appearance = {...appearance, lit: next.lit}
      return
    }
    this.write(next)
    this.wroteAt = now
    const pointedAt = nodes.get(this.pointedAt ?? "")
    if (pointedAt !== undefined) this.setTitle(pointedAt)
  }

  fit(): void {
    this.zoom.reset()
  }

  setMoving(on: boolean): void {
    this.isMoving = on
    this.svg.classList.toggle("movable", on)
  }

  select(name: string | null, block: string | null): void {
    if (name === this.selected && block === this.selectedBlock) return
    this.selected = name
    this.selectedBlock = block
    this.mark()
  }

  explain(path: CausalPath): void {
    this.path = path
    this.mark()
    this.describe()
  }

  private drawNodes(layout: Layout): void {
    const {nodes} = this
    const before = new Map(nodes)
    nodes.clear()
    for (const node of this.network.nodes) {
      const box = layout.boxes.get(node.id)
      if (box === undefined) continue
      // A node that stays keeps its element, so that its way to another place can be seen.
      const known = before.get(node.id)
      const group = known?.group ?? svgElement("g")
      const drawn = drawNode(group, node, box, this.options)
      group.style.transform = `translate(${box.x}px, ${box.y}px)`
      if (known === undefined)
        (isContainer(node) && !node.folded ? this.containers : this.nodeLayer).append(group)
      nodes.set(node.id, drawn)
      before.delete(node.id)
    }
    for (const {group} of before.values()) group.remove()
  }

  private drawEdges(layout: Layout): void {
    this.edgeLayer.replaceChildren()
    this.labelLayer.replaceChildren()
    this.edges.clear()
    for (const edge of this.network.edges) {
      const route = layout.routes.get(edge.id)
      if (route === undefined || route.length < 2) continue
      const isStep = edge.role === "then" || edge.role === "again"
      const after = isStep ? (this.nodes.get(edge.from)?.node.block ?? null) : null
      const drawn = drawEdge(edge, route, isJoin(this.network, edge.to), after)
      this.labelLayer.append(drawn.text)
      this.edgeLayer.append(drawn.group)
      this.edges.set(edge.id, drawn)
    }
  }

  /// Writes the values that differ from those written before.
  private write(next: Appearance): void {
    const {appearance} = this
    for (const [id, {node, value}] of this.nodes) {
      const text = next.atNodes.get(id)
      if (value !== null && text !== appearance.atNodes.get(id))
        value.textContent = fitting(text ?? "", node, this.places.get(id)?.w ?? 0)
    }
    for (const [id, drawn] of this.edges) {
      const text = next.onEdges.get(id)
      if (text === appearance.onEdges.get(id)) continue
      drawn.text.textContent =
        text === undefined || drawn.most < leastLabel ? "" : shortened(text, drawn.most)
      drawn.title.textContent = text ?? ""
    }
    this.appearance = next
  }

  /// What a screen reader says of each node.
  private describe(): void {
    const {marked} = explained(this.network, this.path)
    for (const {id, text} of outline(this.network, this.options.words.list, marked))
      this.groupOf(id)?.setAttribute("aria-label", text)
  }

  /// Tab leads to the current node only; arrow keys lead to the others.
  private setTabStop(): void {
    for (const [id, {group}] of this.nodes)
      if (group.hasAttribute("tabindex")) group.tabIndex = id === this.current ? 0 : -1
  }

  private makeCurrent(drawn: DrawnNode | null): void {
    if (drawn === null) return
    this.current = drawn.node.id
    this.setTabStop()
  }

  private mark(): void {
    const {selected, selectedBlock} = this
    const {marked, lines} = explained(this.network, this.path)
    for (const [id, {group}] of this.nodes) group.classList.toggle("why", marked.has(id))
    for (const [id, {group}] of this.edges) group.classList.toggle("why", lines.has(id))
    for (const {node, group} of this.nodes.values())
      group.classList.toggle(
        "selected",
        (selected !== null && node.kind === "function" && node.key === selected) ||
          (node.block !== null && node.block === selectedBlock),
      )
  }

  /// Type and last value, when they are asked for.
  private setTitle({node, title}: DrawnNode): void {
    const {words} = this.options
    const type = node.kind === "function" ? this.options.typeOf(node) : node.key
    const value = this.appearance.atNodes.get(node.id) ?? this.options.lastOf(node)
    // Frames have every value of these.
    const isKnown = node.kind === "event" || node.kind === "state" || node.kind === "store"
    const last = value !== null ? words.lastValue(value) : isKnown ? words.notYet : null
    const messages = node.topic === null ? [] : [node.topic.name, node.topic.type]
    const contested = node.contested ? contestedText(node, words.list) : null
    const text = [node.label, type === null ? null : words.type(type), ...messages, last, contested]
      .filter(Boolean)
      .join("\n")
    if (title.textContent !== text) title.textContent = text
  }

  private point(target: EventTarget | null): void {
    const drawn = this.nodeOf(target)
    this.pointedAt = drawn?.node.id ?? null
    if (drawn !== null) this.setTitle(drawn)
  }

  private click(target: EventTarget | null): void {
    const valued = this.valuedAt(target)
    if (valued !== null) this.options.valueClicked(valued.node)
    const drawn = valued ?? this.nodeOf(target)
    if (drawn?.group.hasAttribute("tabindex")) this.choose(drawn)
  }

  private press(event: KeyboardEvent): void {
    const drawn = this.nodeOf(event.target)
    if (drawn === null || event.ctrlKey || event.metaKey || event.altKey) return
    const by = event.shiftKey ? steps[event.key] : undefined
    if (by !== undefined) this.options.moved(drawn.node.id, by)
    else if (event.key === "Enter" || event.key === " ") this.choose(drawn)
    else {
      const {marked} = explained(this.network, this.path)
      const next = neighbour(this.network, this.places, drawn.node, event.key, marked)
      if (next === null) return
      this.groupOf(next)?.focus()
    }
    event.preventDefault()
    event.stopPropagation()
  }

  private choose(drawn: DrawnNode): void {
    this.makeCurrent(drawn)
    if (drawn.node.folded) this.options.toggled(drawn.node.id)
    else this.options.chosen(drawn.node)
  }

  private groupOf(id: string): SVGGElement | undefined {
    return this.nodes.get(id)?.group
  }

  private nodeOf(target: EventTarget | null): DrawnNode | null {
    const group = target instanceof Element ? target.closest<SVGGElement>("[data-node]") : null
    return this.nodes.get(group?.dataset.node ?? "") ?? null
  }

  /// The node whose value is written at a place: on the node itself, or on an edge.
  private valuedAt(target: EventTarget | null): DrawnNode | null {
    const text = target instanceof Element ? target.closest<SVGTextElement>("text.value, text.carried") : null
    if (text === null || text.textContent === "") return null
    const edge = this.network.edges.find(one => one.id === text.dataset["edge"])
    return edge === undefined ? this.nodeOf(text) : (this.nodes.get(valuedNode(this.network, edge)) ?? null)
  }
}

/// How far a key moves a node, px.
const step = 20
const steps: {readonly [key: string]: Point} = {
  ArrowLeft: {x: -step, y: 0},
  ArrowRight: {x: step, y: 0},
  ArrowUp: {x: 0, y: -step},
  ArrowDown: {x: 0, y: step},
}

/// Characters below which nothing is written on an edge.
const leastLabel = 4
