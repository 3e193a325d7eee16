/// Place of what opens over the page: near a point, and wholly inside the window.

import type {RefObject} from "preact"
import {useLayoutEffect} from "preact/hooks"
import type {Point} from "../../views/diagram/layout/geometry.ts"

/// Distance from the edges of the window, px.
const margin = 8

/// `at` is in pixels of the window.
export function usePlaceInWindow(element: RefObject<HTMLElement>, at: Point): void {
  useLayoutEffect(() => {
    const own = element.current
    if (own === null) return
    const place = () => {
      const {width, height} = own.getBoundingClientRect()
      own.style.left = `${Math.max(margin, Math.min(at.x, window.innerWidth - width - margin))}px`
      own.style.top = `${Math.max(margin, Math.min(at.y, window.innerHeight - height - margin))}px`
    }
    place()
    // Pictures of ways out come later and make it larger.
    const observer = new ResizeObserver(place)
    observer.observe(own)
    return () => observer.disconnect()
  })
}
