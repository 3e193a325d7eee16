/// Zoom of the drawing by two fingers, or by the wheel with Ctrl: what is between the fingers stays between them. One finger pans, as in any page that scrolls.

import type {Point} from "../layout/geometry.ts"

export interface PinchZoom {
  /// Gives the drawing the size that belongs to its layout, px: by the zoom, or as it fits when there is none.
  apply(width: number): void
  /// The drawing fits again.
  reset(): void
}

/// The least and the largest size of what is drawn.
const least = 0.4
const most = 3

/// Zoom of a pixel that the wheel scrolls, as an exponent.
const perPixel = 0.002

/// `fit` sizes a drawing of that width when there is no zoom.
export function openPinchZoom(
  host: HTMLElement,
  svg: SVGSVGElement,
  fit: (width: number) => void,
): PinchZoom {
  let scale: number | null = null
  let drawn = 0
  const apply = (width: number) => {
    drawn = width
    svg.style.maxWidth = scale === null ? "" : "none"
    svg.style.width = scale === null ? "" : `${width * scale}px`
    if (scale === null) fit(width)
    else svg.style.minWidth = "0"
  }
  const zoom = (to: number, before: Point, now: Point) => {
    const old = svg.getBoundingClientRect()
    if (old.width === 0) return
    const share = {x: (before.x - old.left) / old.width, y: (before.y - old.top) / old.height}
    scale = Math.min(most, Math.max(least, to))
    apply(drawn)
    const box = svg.getBoundingClientRect()
    host.scrollBy(box.left + share.x * box.width - now.x, box.top + share.y * box.height - now.y)
  }
  const current = () => scale ?? svg.getBoundingClientRect().width / Math.max(1, drawn)

  let pinch: {readonly apart: number; readonly scale: number; middle: Point} | null = null
  const touched = (event: TouchEvent) => {
    const two = twoFingers(event.touches)
    pinch = two === null ? null : {apart: two.apart, scale: current(), middle: two.middle}
    if (two !== null && event.cancelable) event.preventDefault()
  }
  host.addEventListener("touchstart", touched, {passive: false})
  host.addEventListener("touchend", touched, {passive: false})
  host.addEventListener("touchcancel", touched, {passive: false})
  host.addEventListener(
    "touchmove",
    event => {
      const two = twoFingers(event.touches)
      if (two === null || pinch === null) return
      if (event.cancelable) event.preventDefault()
      zoom((pinch.scale * two.apart) / pinch.apart, pinch.middle, two.middle)
      pinch.middle = two.middle
    },
    {passive: false},
  )
  host.addEventListener(
    "wheel",
    event => {
      if (!event.ctrlKey) return
      event.preventDefault()
      const at = {x: event.clientX, y: event.clientY}
      zoom(current() * Math.exp(-event.deltaY * perPixel), at, at)
    },
    {passive: false},
  )
  return {
    apply,
    reset() {
      scale = null
      apply(drawn)
    },
  }
}

interface Fingers {
  readonly apart: number
  readonly middle: Point
}

/// How far two fingers are apart, px, and the place between them; `null` for any other number of fingers.
export function twoFingers(
  touches: ArrayLike<{readonly clientX: number; readonly clientY: number}>,
): Fingers | null {
  const [a, b] = [touches[0], touches[1]]
  if (touches.length !== 2 || a === undefined || b === undefined) return null
  return {
    apart: Math.max(1, Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY)),
    middle: {x: (a.clientX + b.clientX) / 2, y: (a.clientY + b.clientY) / 2},
  }
}
