/// Buttons over the workspace that zoom out, zoom in, and show all blocks.

import type * as Blockly from "blockly/core"
import {words} from "../../words/index.ts"
import {showAll} from "./camera.ts"

/// Adds the buttons to `host`; the answer is their element.
export function zoomButtons(host: HTMLElement, workspace: Blockly.WorkspaceSvg): HTMLElement {
  const bar = document.createElement("div")
  bar.className = "rosyZoom"
  bar.setAttribute("role", "group")
  bar.setAttribute("aria-label", words.blocks.zoom)
  const button = (text: string, label: string, act: () => void) => {
    const made = document.createElement("button")
    made.type = "button"
    made.textContent = text
    made.title = label
    made.setAttribute("aria-label", label)
    made.addEventListener("click", act)
    bar.append(made)
  }
  button("−", words.blocks.zoomOut, () => workspace.zoomCenter(-1))
  button("+", words.blocks.zoomIn, () => workspace.zoomCenter(1))
  button("⤢", words.blocks.showAll, () => showAll(workspace))
  host.append(bar)
  return bar
}
