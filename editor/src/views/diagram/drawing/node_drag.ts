/// Drag of a node to another place, by mouse, pen or finger: the node follows the pointer, and its wires follow when it is let go.

import type {Point} from "../layout/geometry.ts"

export interface NodeDragOptions {
  isOn(): boolean
  /// `by` is in pixels of the drawing.
  moved(id: string, by: Point): void
}

/// Pixels that a pointer moves before it drags: less is a press, which chooses the node.
const slack = 4

export function openNodeDrag(svg: SVGSVGElement, options: NodeDragOptions): void {
  svg.addEventListener("pointerdown", down => {
    const group = down.target instanceof Element ? down.target.closest<SVGGElement>(".node[role]") : null
    const id = group?.dataset["node"]
    if (!options.isOn() || down.button !== 0 || !down.isPrimary || group === null || id === undefined) return
    // It connects nothing.
    down.stopPropagation()
    follow(svg, group, down, by => options.moved(id, by))
  })
}

function follow(
  svg: SVGSVGElement,
  group: SVGGElement,
  down: PointerEvent,
  moved: (by: Point) => void,
): void {
  const from = group.style.transform
  const scale = svg.getScreenCTM()?.a ?? 1
  const ending = new AbortController()
  const options = {capture: true, signal: ending.signal}
  const byOf = ({clientX, clientY}: PointerEvent): Point => ({
    x: (clientX - down.clientX) / scale,
    y: (clientY - down.clientY) / scale,
  })
  let isDragging = false
  const stop = () => {
    ending.abort()
    group.classList.remove("moving")
    group.style.transform = from
  }
  const move = (event: PointerEvent) => {
    if (event.pointerId !== down.pointerId) return
    const {x, y} = byOf(event)
    isDragging ||= Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY) > slack
    if (!isDragging) return
    group.classList.add("moving")
    group.style.transform = `translate(${x}px, ${y}px) ${from}`
  }
  const up = (event: PointerEvent) => {
    if (event.pointerId !== down.pointerId) return
    stop()
    if (!isDragging) return
    // The click that follows a drag is no choice of a node.
    const swallow = (click: Event) => click.stopPropagation()
    window.addEventListener("click", swallow, {capture: true, once: true})
    setTimeout(() => window.removeEventListener("click", swallow, true))
    moved(byOf(event))
  }
  window.addEventListener("pointermove", move, options)
  window.addEventListener("pointerup", up, options)
  window.addEventListener("pointercancel", stop, options)
  window.addEventListener(
    "keydown",
    event => {
      if (event.key === "Escape") stop()
    },
    options,
  )
}
