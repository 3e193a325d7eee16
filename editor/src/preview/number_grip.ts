/// The grip beside a number: dragged to the left or right, it changes the number step by step. The next value waits until the preview of the last one is there.

import {withSteps} from "./number_steps.ts"

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

/// Pixels of the pointer's way for one step.
const perStep = 3

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
    drag(grip, down, number, listener)
  })
  return grip
}

function drag(
  grip: HTMLElement,
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
      if (move.pointerId === down.pointerId) steps = Math.round((move.clientX - down.clientX) / perStep)
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
