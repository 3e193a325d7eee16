/// Scroll bars of the workspace. They are shown while the workspace scrolls and while the mouse is near their edges, so that they cover no block at rest.
/// Hidden bars take no presses. A finger moves the workspace itself: for it the bars only show the position.

import * as Blockly from "blockly/core"

/// Pixels of a scroll bar with the space around it, which is 5.
const thickness = {mouse: 15, finger: 11} as const

/// Pixels from the right or the lower edge within which the mouse shows the bars.
const near = 24

/// Milliseconds for which the bars stay after the last movement of the workspace.
const shownFor = 800

/// Chooses the thickness for the pointer of this device; before the workspace is made.
export function setScrollBarThickness(): void {
  Blockly.Scrollbar.scrollbarThickness = window.matchMedia("(hover: none)").matches
    ? thickness.finger
    : thickness.mouse
}

/// Whether a point is near an edge at which a bar stands: the lower one, or the one where lines end. Pure; exported for its test.
function isNearBars(
  point: {readonly x: number; readonly y: number},
  box: {readonly left: number; readonly right: number; readonly bottom: number},
  rightToLeft: boolean,
): boolean {
  const fromSide = rightToLeft ? point.x - box.left : box.right - point.x
  return Math.min(fromSide, box.bottom - point.y) <= near
}

/// Gives `host` the class `rosyScrolling` while its workspace scrolls or zooms, and `rosyNearBars` while the mouse is near the bars. Answers how to stop.
export function showScrollBarsInUse(workspace: Blockly.WorkspaceSvg, host: HTMLElement): () => void {
  let timer: number | undefined
  const onViewport = (event: Blockly.Events.Abstract) => {
    if (event.type !== Blockly.Events.VIEWPORT_CHANGE) return
    host.classList.add("rosyScrolling")
    window.clearTimeout(timer)
    timer = window.setTimeout(() => host.classList.remove("rosyScrolling"), shownFor)
  }
  const onMove = (event: PointerEvent) => {
    // A pressed button drags a bar, or something else that a bar must not cover suddenly.
    if (event.pointerType !== "mouse" || event.buttons !== 0) return
    host.classList.toggle(
      "rosyNearBars",
      isNearBars({x: event.clientX, y: event.clientY}, host.getBoundingClientRect(), workspace.RTL),
    )
  }
  const onLeave = (event: PointerEvent) => {
    if (event.buttons === 0) host.classList.remove("rosyNearBars")
  }
  workspace.addChangeListener(onViewport)
  host.addEventListener("pointermove", onMove)
  host.addEventListener("pointerleave", onLeave)
  return () => {
    window.clearTimeout(timer)
    workspace.removeChangeListener(onViewport)
    host.removeEventListener("pointermove", onMove)
    host.removeEventListener("pointerleave", onLeave)
    host.classList.remove("rosyScrolling", "rosyNearBars")
  }
}
