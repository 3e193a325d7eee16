/// Dragging of numbers, by themselves in blocks and by a grip beside the others: to the left or right a number changes step by step, at first by small steps. The next value waits until the preview of the last one is there.

import {stepsOfWay, withSteps} from "./number_steps.ts"

/// The page, which joins the changes of one drag to one undo step.
export interface NumberDragListener {
  begins(): void
  ends(): void
  /// Whether a preview is still to come.
  isBehind(): boolean
}

export interface DraggedNumber {
  /// What stands there now.
  literal(): string
  /// Another literal is to stand there.
  set(literal: string): void
}

/// Milliseconds between two values, at least, and at most while a preview is still to come.
const shortestPause = 40
const longestPause = 150

/// Makes the grip; it is for pointers only, since the number can be typed as well.
export function makeNumberGrip(
  hint: string,
  number: DraggedNumber,
  listener: NumberDragListener,
): HTMLElement {
  const grip = document.createElement("div")
  grip.className = "number-grip"
  grip.title = hint
  grip.dataset["testid"] = "number-grip"
  grip.setAttribute("aria-hidden", "true")
  grip.textContent = "↔"
  grip.addEventListener("pointerdown", down => {
    if (down.button !== 0) return
    // The field or the text keeps the focus.
    down.preventDefault()
    down.stopPropagation()
    dragNumber(grip, down, number, listener)
  })
  return grip
}

/// Follows the pointer from a press on an element until it is let go; Escape takes the change back.
export function dragNumber(
  grip: HTMLElement | SVGElement,
  down: PointerEvent,
  number: DraggedNumber,
  listener: NumberDragListener,
): void {
  const first = number.literal()
  const stop = new AbortController()
  let steps = 0
  let shown = first
  let last = 0
  let frame = 0
  grip.setPointerCapture(down.pointerId)
  grip.classList.add("dragged")
  listener.begins()
  const show = (literal: string) => {
    if (literal === shown) return
    shown = literal
    last = performance.now()
    number.set(literal)
  }
  const follow = () => {
    frame = requestAnimationFrame(follow)
    const since = performance.now() - last
    if (since >= (listener.isBehind() ? longestPause : shortestPause)) show(withSteps(first, steps))
  }
  const end = (literal: string) => {
    cancelAnimationFrame(frame)
    stop.abort()
    grip.classList.remove("dragged")
    show(literal)
    listener.ends()
  }
  const listen = {signal: stop.signal, capture: true}
  window.addEventListener(
    "pointermove",
    move => {
      if (move.pointerId === down.pointerId) steps = stepsOfWay(move.clientX - down.clientX)
    },
    listen,
  )
  window.addEventListener(
    "pointerup",
    up => up.pointerId === down.pointerId && end(withSteps(first, steps)),
    listen,
  )
  window.addEventListener("pointercancel", () => end(first), listen)
  window.addEventListener(
    "keydown",
    key => {
      if (key.key !== "Escape") return
      key.preventDefault()
      key.stopPropagation()
      end(first)
    },
    listen,
  )
  frame = requestAnimationFrame(follow)
}
