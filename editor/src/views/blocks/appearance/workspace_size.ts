/// Size of the workspace: it follows its host and the width of the toolbox, and the blocks keep their distance from the toolbox.

import * as Blockly from "blockly/core"

/// Calls `resized` after each change. Returns how to stop.
export function fitToHost(
  workspace: Blockly.WorkspaceSvg,
  host: HTMLElement,
  resized: () => void,
): () => void {
  const toolbox = host.querySelector(".blocklyToolbox")
  let width = toolbox?.getBoundingClientRect().width ?? 0
  const observer = new ResizeObserver(() => {
    const now = toolbox?.getBoundingClientRect().width ?? 0
    const {scrollX, scrollY} = workspace
    Blockly.svgResize(workspace)
    if (now === width) return resized()
    // Blockly notices a toolbox that opens, but not one that a style sheet makes wider or narrower.
    width = now
    workspace.getToolbox()?.handleToolboxItemResize()
    workspace.scroll(scrollX, scrollY)
    resized()
  })
  observer.observe(host)
  if (toolbox !== null) observer.observe(toolbox)
  return () => observer.disconnect()
}
