/// Keyboard focus and clicks on the workspace.

import * as Blockly from "blockly/core"

/// Keeps the focus on what has it. A frame after something got the focus Blockly brings it to the front; an element that
/// is moved within the page for that loses the focus, and by then it may be the next one: keys can be quicker than
/// frames. Answers how to stop.
export function restoreFocus(workspace: Blockly.WorkspaceSvg): () => void {
  // Not the SVG itself: listening for the focus would make it focusable.
  const host = workspace.getInjectionDiv()
  const stop = new AbortController()
  let last: Element | undefined
  host.addEventListener(
    "focusin",
    event => {
      if (event.target instanceof Element) last = event.target
    },
    {signal: stop.signal},
  )
  // A press somewhere else moves the focus there.
  document.addEventListener(
    "pointerdown",
    event => {
      if (!host.contains(event.target as Node)) last = undefined
    },
    {capture: true, signal: stop.signal},
  )
  const moved = new MutationObserver(records => {
    const lost = last
    if (lost === undefined || document.activeElement !== document.body || !host.contains(lost)) return
    if (!records.some(({addedNodes}) => [...addedNodes].some(node => node.contains(lost)))) return
    const node = workspace.lookUpFocusableNode(lost.id)
    if (node !== null) Blockly.getFocusManager().focusNode(node)
  })
  moved.observe(host, {childList: true, subtree: true})
  return () => {
    moved.disconnect()
    stop.abort()
  }
}

/// Pixels: a pointer that moves less has clicked.
const still = 5

/// Chooses the empty socket that is clicked, and not only its block, and has what fits there offered. `offer` is told whether letters can
/// be typed at once: for a finger that would bring up a keyboard over half of the page. Answers how to stop.
export function selectSocketByClick(
  workspace: Blockly.WorkspaceSvg,
  offer: (withKeys: boolean) => void,
): () => void {
  return onStill(workspace, "click", (event, down) => {
    const socket = event.target instanceof Element ? socketUnder(workspace, event.target) : undefined
    if (!socket?.canBeFocused()) return
    Blockly.getFocusManager().focusNode(socket)
    offer(down.pointerType === "mouse")
  })
}

/// A block of the toolbox that is clicked, and not dragged, goes where Enter would put it: into the place that is chosen, or
/// below the others. Blockly would lay it over whatever is behind the toolbox. Answers how to stop.
export function insertByClick(
  workspace: Blockly.WorkspaceSvg,
  put: (block: Blockly.serialization.blocks.State) => void,
): () => void {
  return onStill(workspace, "pointerup", (event, down) => {
    const programStore = workspace.getFlyout()?.getWorkspace()
    if (down.button !== 0 || programStore === undefined) return
    const picture =
      event.target instanceof Element && event.target.closest(".blocklyFlyout .blocklyDraggable")
    const id = picture instanceof Element ? picture.getAttribute("data-id") : null
    const block = id === null ? null : programStore.getBlockById(id)
    if (block === null || !block.isEnabled()) return
    const saved = Blockly.serialization.blocks.save(block.getRootBlock(), {saveIds: false})
    programStore.cancelCurrentGesture()
    workspace.cancelCurrentGesture()
    if (saved !== null) put(saved)
  })
}

/// Hears where a pointer came up that has not moved, before Blockly does when it is a `pointerup`. Answers how to stop.
function onStill(
  workspace: Blockly.WorkspaceSvg,
  kind: "click" | "pointerup",
  heard: (event: MouseEvent, down: PointerEvent) => void,
): () => void {
  const host = workspace.getInjectionDiv()
  const stop = new AbortController()
  let down: PointerEvent | undefined
  host.addEventListener(
    "pointerdown",
    event => {
      down = event
    },
    {capture: true, signal: stop.signal},
  )
  host.addEventListener(
    kind,
    event => {
      if (down === undefined) return
      const moved = Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY)
      if (moved <= still) heard(event, down)
    },
    {capture: kind === "pointerup", signal: stop.signal},
  )
  return () => stop.abort()
}

/// The empty socket that an outline is drawn for: the one that begins where it begins.
function socketUnder(
  workspace: Blockly.WorkspaceSvg,
  outline: Element,
): Blockly.RenderedConnection | undefined {
  if (!outline.classList.contains("blocklyOutlinePath")) return undefined
  const id = outline.closest(".blocklyDraggable")?.getAttribute("data-id") ?? ""
  const box = outline.getBoundingClientRect()
  const away = (connection: Blockly.RenderedConnection) => {
    const at = Blockly.utils.svgMath.wsToScreenCoordinates(
      workspace,
      new Blockly.utils.Coordinate(connection.x, connection.y),
    )
    return Math.hypot(at.x - box.left, at.y - box.top)
  }
  const empty = (workspace.getBlockById(id)?.inputList ?? []).flatMap(({connection}) =>
    connection instanceof Blockly.RenderedConnection && connection.targetBlock() === null ? [connection] : [],
  )
  return empty.sort((one, other) => away(one) - away(other))[0]
}
