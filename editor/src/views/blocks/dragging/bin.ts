/// Bin: a drop target that deletes blocks and appears while a block is dragged, and a list of deleted blocks that can be restored.
///
/// The list holds what the learner deleted in this view, the latest first; it is not saved.

import {codeOf, type SavedBlock} from "@rosy/codegen"
import * as Blockly from "blockly/core"
import {words} from "../../../words/index.ts"

/// Deleted blocks that are kept. A choice of ours.
const longestList = 20

/// Letters of a block in the list.
const longestName = 40

/// Pixels around the bin that count as the bin.
const reach = 14

class Bin extends Blockly.DeleteArea {
  override readonly id = "rosyBin"
  private readonly element: HTMLElement

  constructor(element: HTMLElement) {
    super()
    this.element = element
  }

  override getClientRect(): Blockly.utils.Rect | null {
    const {top, bottom, left, right, width} = this.element.getBoundingClientRect()
    return width === 0
      ? null
      : new Blockly.utils.Rect(top - reach, bottom + reach, left - reach, right + reach)
  }

  override onDragEnter(element: Blockly.IDraggable): void {
    super.onDragEnter(element)
    this.element.classList.add("open")
  }

  override onDragExit(element: Blockly.IDraggable): void {
    super.onDragExit(element)
    this.element.classList.remove("open")
  }

  override onDrop(element: Blockly.IDraggable): void {
    super.onDrop(element)
    this.element.classList.remove("open")
  }
}

/// Adds bin and list to `host`. `isNew` tells blocks that came from the toolbox with the drag that deletes them: they are not kept. `restore` puts a block back.
/// The result removes both.
export function openBin(
  workspace: Blockly.WorkspaceSvg,
  host: HTMLElement,
  isNew: (id: string) => boolean,
  restore: (block: SavedBlock) => void,
): () => void {
  const target = document.createElement("div")
  target.className = "rosyBin"
  target.setAttribute("aria-hidden", "true")
  target.innerHTML = `${binPicture}<span></span>`
  target.querySelector("span")!.textContent = words.blocks.dropToDelete
  const button = document.createElement("button")
  button.type = "button"
  button.className = "rosyDeleted"
  button.innerHTML = binPicture
  button.title = words.blocks.deleted
  button.setAttribute("aria-label", words.blocks.deleted)
  button.setAttribute("aria-haspopup", "menu")
  button.hidden = true
  host.append(target, button)

  let kept: readonly SavedBlock[] = []
  const show = () => {
    button.hidden = kept.length === 0
  }
  button.addEventListener("click", event => {
    const entries = kept.map((block, i) => ({
      id: `restore-${i}`,
      text: leftToRight(nameOf(block)),
      enabled: true,
      scope: {},
      weight: 0,
      callback() {
        kept = kept.filter(other => other !== block)
        show()
        restore(withoutTakenIds(workspace, block))
      },
    }))
    const {left, right, top} = button.getBoundingClientRect()
    const corner = new Blockly.utils.Coordinate(workspace.RTL ? left : right, top)
    // Towards the middle of the blocks, so that nothing is cut off.
    Blockly.ContextMenu.show(event, entries, !workspace.RTL, workspace, corner)
  })

  const bin = new Bin(target)
  const {Capability} = Blockly.ComponentManager
  workspace.getComponentManager().addComponent({
    component: bin,
    capabilities: [Capability.DRAG_TARGET, Capability.DELETE_AREA],
    weight: 2,
  })
  const changed = (event: Blockly.Events.Abstract) => {
    if (event.type === Blockly.Events.BLOCK_DRAG) {
      const drag = event as Blockly.Events.BlockDrag
      host.classList.toggle("rosyDragging", drag.isStart === true)
      // The bin has a place only while it is shown.
      if (drag.isStart === true) workspace.recordDragTargets()
      else target.classList.remove("open")
    }
    if (event.type !== Blockly.Events.BLOCK_DELETE || !event.recordUndo) return
    const {oldJson} = event as Blockly.Events.BlockDelete
    if (oldJson === undefined || isNew(oldJson.id ?? "")) return
    kept = [oldJson as SavedBlock, ...kept].slice(0, longestList)
    show()
  }
  workspace.addChangeListener(changed)
  return () => {
    workspace.removeChangeListener(changed)
    workspace.getComponentManager().removeComponent(bin.id)
    target.remove()
    button.remove()
  }
}

/// A deleted block as a line of the list: its Haskell below its comment, cut where the line ends.
function nameOf(block: SavedBlock): string {
  const lines = (codeOf(block)?.text ?? block.type).split("\n")
  const line = lines.find(one => !one.startsWith("--")) ?? lines[0] ?? ""
  return line.length > longestName ? `${line.slice(0, longestName)}…` : line
}

/// Haskell is read from the left, in a menu that opens to the left, too.
function leftToRight(code: string): HTMLElement {
  const text = document.createElement("bdi")
  text.dir = "ltr"
  text.textContent = code
  return text
}

/// The block may be back already, by undo: then the restored one is another.
function withoutTakenIds(workspace: Blockly.Workspace, block: SavedBlock): SavedBlock {
  const text = JSON.stringify(block, (key, value: unknown) =>
    key === "id" && typeof value === "string" && workspace.getBlockById(value) !== null ? undefined : value,
  )
  return JSON.parse(text) as SavedBlock
}

const binPicture =
  '<svg viewBox="0 0 24 24" width="20" height="20" fill="none" stroke="currentColor" stroke-width="2" stroke-linecap="round" stroke-linejoin="round" aria-hidden="true"><path class="lid" d="M4 7h16M10 7V4h4v3"/><path d="M6 7l1 13h10l1-13M10 11v5M14 11v5"/></svg>'
