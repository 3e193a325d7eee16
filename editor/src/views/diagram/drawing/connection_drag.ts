/// Drag of a connection from one end to another, by mouse, pen or finger: the line that follows the pointer, and what would become of it. An end is an element
/// with `data-end` and `data-type`.

import type {Point} from "../layout/geometry.ts"
import type {ConnectionEnd} from "../network/connections.ts"
import {type Grip, openVerdicts, type Verdict} from "./connection_verdict.ts"
import {svgElement} from "./svg_element.ts"

export interface ConnectionDragOptions {
  /// What a connection would be, in words. It may take longer than a frame: the edit is tried out.
  verdict(from: ConnectionEnd, to: ConnectionEnd): Verdict
  /// `at` is in pixels of the window.
  dropped(from: ConnectionEnd, to: ConnectionEnd, at: Point): void
}

/// Pixels that a pointer moves before it drags: less is a press, which chooses the node.
const slack = 6

/// A finger that leaves a palette which has more than it shows at a flatter angle than this drags an entry; a steeper one scrolls.
const steepest = Math.tan((60 * Math.PI) / 180)

/// Whether a movement of a finger, in pixels, scrolls a list with such heights, and drags nothing out of it.
export const scrolls = (
  by: Point,
  {scrollHeight, clientHeight}: Pick<Element, "scrollHeight" | "clientHeight">,
): boolean => scrollHeight > clientHeight && Math.abs(by.y) > Math.abs(by.x) * steepest

/// Returns a function that ends it.
export function openConnectionDrag(stage: HTMLElement, options: ConnectionDragOptions): () => void {
  let end: (() => void) | null = null
  const down = (event: PointerEvent) => {
    const grip = endAt(event.target)
    if (event.button !== 0 || !event.isPrimary || grip === null || end !== null) return
    end = follow(stage, grip, event, options, () => {
      end = null
    })
  }
  stage.addEventListener("pointerdown", down)
  return () => {
    end?.()
    stage.removeEventListener("pointerdown", down)
  }
}

function endAt(target: EventTarget | null): Grip | null {
  const element = target instanceof Element ? target.closest<HTMLElement | SVGElement>("[data-end]") : null
  const {end, type} = element?.dataset ?? {}
  return element === null || end === undefined || type === undefined
    ? null
    : {element, end: {kind: end as ConnectionEnd["kind"], type}}
}

/// A new step can be dropped on the free space of the drawing, too.
function freeSpace({end}: Grip, target: Element | null): Grip | null {
  const element = end.kind === "new-step" ? target?.closest<HTMLElement>("[data-free-space]") : null
  return element == null ? null : {element, end: {kind: "program", type: ""}}
}

function follow(
  stage: HTMLElement,
  from: Grip,
  down: PointerEvent,
  options: ConnectionDragOptions,
  ended: () => void,
): () => void {
  const line = svgElement("path", {class: "line"})
  const overlay = svgElement("svg", {class: "connection-line", "aria-hidden": "true"})
  overlay.append(line)
  const note = document.createElement("div")
  note.className = "connection-note"
  let isDragging = false
  const list = down.pointerType === "touch" ? from.element.closest(".diagram-palette") : null
  let isScrolling = false
  let lastY = down.clientY
  let target: Grip | null = null
  // The stage stays where it is while something is dragged: asked again and again, its place would be computed in each frame.
  const stageBox = stage.getBoundingClientRect()

  const inStage = (x: number, y: number): Point => ({x: x - stageBox.left, y: y - stageBox.top})
  const start = () => {
    isDragging = true
    const box = from.element.getBoundingClientRect()
    const at = inStage(box.left + box.width / 2, box.top + box.height / 2)
    line.dataset["from"] = `${at.x} ${at.y}`
    stage.append(overlay, note)
    stage.classList.add("connecting")
    stage.setPointerCapture(down.pointerId)
  }
  const showVerdict = openVerdicts(note, to => options.verdict(from.end, to))
  const point = (next: Grip | null) => {
    target = next
    showVerdict(next)
  }
  const move = (event: PointerEvent) => {
    if (event.pointerId !== down.pointerId) return
    if (!isDragging && !isScrolling) {
      const by = {x: event.clientX - down.clientX, y: event.clientY - down.clientY}
      if (Math.hypot(by.x, by.y) <= slack) return
      isScrolling = list !== null && scrolls(by, list)
      if (!isScrolling) start()
    }
    if (isScrolling) {
      list?.scrollBy(0, lastY - event.clientY)
      lastY = event.clientY
      return
    }
    // Before anything is changed: the browser would have to compute the layout anew to answer.
    const element = document.elementFromPoint(event.clientX, event.clientY)
    const {x, y} = inStage(event.clientX, event.clientY)
    line.setAttribute("d", `M${line.dataset["from"]}L${x} ${y}`)
    note.style.transform = `translate(${Math.min(x + 14, stageBox.width - 250)}px, ${y + 16}px)`
    const under = endAt(element) ?? freeSpace(from, element)
    point(under?.element === from.element ? null : under)
  }
  const stop = () => {
    point(null)
    overlay.remove()
    note.remove()
    stage.classList.remove("connecting")
    for (const [name, listener] of listeners) window.removeEventListener(name, listener, true)
    ended()
  }
  const up = (event: PointerEvent) => {
    if (event.pointerId !== down.pointerId) return
    const to = target
    if (isDragging) {
      // The click that follows a drag is no choice of a node.
      const swallow = (click: Event) => click.stopPropagation()
      window.addEventListener("click", swallow, {capture: true, once: true})
      setTimeout(() => window.removeEventListener("click", swallow, true))
    }
    stop()
    if (to !== null) options.dropped(from.end, to.end, {x: event.clientX, y: event.clientY})
  }
  // A second finger zooms.
  const other = (event: PointerEvent) => {
    if (event.pointerId !== down.pointerId) stop()
  }
  const key = (event: KeyboardEvent) => {
    if (event.key === "Escape") stop()
  }
  const listeners = [
    ["pointerdown", other],
    ["pointermove", move],
    ["pointerup", up],
    ["pointercancel", stop],
    ["keydown", key],
  ] as [string, EventListener][]
  for (const [name, listener] of listeners) window.addEventListener(name, listener, true)
  return stop
}
