/// The keyboard's focus on the workspace.

import * as Blockly from "blockly/core"

/// Keeps the focus on what has it. A frame after something got the focus Blockly brings it to the front; an element that
/// is moved within the page for that loses the focus, and by then it may be the next one: keys can be quicker than
/// frames. Answers how to stop.
export function keepFocus(workspace: Blockly.WorkspaceSvg): () => void {
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
  // Who presses somewhere else means it.
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
