/// Viewport culling: blocks far outside of the visible area are not drawn while the focus is elsewhere on the page. The browser repaints a whole drawing when a part of it
/// changes, and a program of 1,000 lines is a drawing of 10,000 parts.
///
/// All blocks are drawn as soon as the block view has the focus or is touched, so keyboard navigation, dragging and screen readers see no difference.

import * as Blockly from "blockly/core"

/// Fewer top-level blocks than this are always drawn.
const few = 40

export interface ViewportCulling {
  /// Blocks were loaded or the view has moved.
  update(): void
  dispose(): void
}

export function cullByViewport(workspace: Blockly.WorkspaceSvg, host: HTMLElement): ViewportCulling {
  let hidden = new Set<string>()
  const inUse = () => host.contains(document.activeElement) || workspace.isDragging()

  const update = () => {
    const tops = workspace.getTopBlocks(false)
    const view = workspace.getMetricsManager().getViewMetrics(true)
    const all = tops.length < few || inUse() || view.width === 0
    const now = new Set<string>()
    for (const block of tops) {
      const away = !all && isFar(block.getBoundingRectangle(), view)
      if (away) now.add(block.id)
      if (away || hidden.has(block.id)) block.getSvgRoot().classList.toggle("rosyAway", away)
    }
    hidden = now
  }

  const changed = (event: Blockly.Events.Abstract) => {
    if (event.type === Blockly.Events.VIEWPORT_CHANGE) update()
  }
  workspace.addChangeListener(changed)
  const stop = new AbortController()
  for (const kind of ["focusin", "focusout", "pointerdown"])
    host.addEventListener(kind, () => queueMicrotask(update), {capture: true, signal: stop.signal})
  // Before the focus moves by a key of Blockly's own, what it moves to must be there.
  host.addEventListener("keydown", update, {capture: true, signal: stop.signal})
  return {
    update,
    dispose() {
      stop.abort()
      workspace.removeChangeListener(changed)
    },
  }
}

/// Further than one view away in some direction.
function isFar(
  box: Blockly.utils.Rect,
  view: {readonly left: number; readonly top: number; readonly width: number; readonly height: number},
): boolean {
  return (
    box.right < view.left - view.width ||
    box.left > view.left + 2 * view.width ||
    box.bottom < view.top - view.height ||
    box.top > view.top + 2 * view.height
  )
}
