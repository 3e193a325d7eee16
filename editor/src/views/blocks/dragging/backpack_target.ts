/// Button of the backpack over the workspace, which is also a drop target: a definition that is let fall there goes into the backpack and stays where it was.

import type {BlockId} from "@rosy/codegen"
import * as Blockly from "blockly/core"
import {words} from "../../../words/index.ts"

/// The backpack, as far as the menus and the button of the blocks need it.
export interface BackpackAccess {
  /// The definition around a block; `null` where there is none that can be put in.
  definitionAt(block: BlockId): string | null
  put(name: string): void
  open(): void
}

/// Pixels around the button that count as the button.
const reach = 14

class BackpackTarget extends Blockly.DragTarget {
  override readonly id = "rosyBackpack"
  private readonly element: HTMLElement
  private readonly isPackable: (element: Blockly.IDraggable) => boolean
  private readonly dropped: (block: Blockly.BlockSvg) => void

  constructor(
    element: HTMLElement,
    isPackable: (element: Blockly.IDraggable) => boolean,
    dropped: (block: Blockly.BlockSvg) => void,
  ) {
    super()
    this.element = element
    this.isPackable = isPackable
    this.dropped = dropped
  }

  override getClientRect(): Blockly.utils.Rect {
    const {top, bottom, left, right} = this.element.getBoundingClientRect()
    return new Blockly.utils.Rect(top - reach, bottom + reach, left - reach, right + reach)
  }

  /// What is packed goes back to its place.
  override shouldPreventMove(element: Blockly.IDraggable): boolean {
    return this.isPackable(element)
  }

  override onDragEnter(element: Blockly.IDraggable): void {
    this.element.classList.toggle("open", this.isPackable(element))
  }

  override onDragExit(): void {
    this.element.classList.remove("open")
  }

  override onDrop(element: Blockly.IDraggable): void {
    this.onDragExit()
    if (element instanceof Blockly.BlockSvg) this.dropped(element)
  }
}

/// Adds the button to `host`. `isNew` tells blocks that came from the toolbox with the drag that moves them: the program does not have them
/// yet. `refuse` says why something does not go in. The result removes the button.
export function openBackpackTarget(
  workspace: Blockly.WorkspaceSvg,
  host: HTMLElement,
  backpack: BackpackAccess,
  isNew: (id: string) => boolean,
  refuse: (why: string) => void,
): () => void {
  const button = document.createElement("button")
  button.type = "button"
  button.className = "rosyBackpack"
  button.innerHTML = backpackPicture
  button.title = words.backpack.title
  button.setAttribute("aria-label", words.backpack.title)
  button.setAttribute("aria-haspopup", "dialog")
  button.addEventListener("click", () => backpack.open())
  host.append(button)

  const nameOf = (element: Blockly.IDraggable | null): string | null =>
    element instanceof Blockly.BlockSvg && !isNew(element.id) ? backpack.definitionAt(element.id) : null
  // The definition that was dropped, until its block is back in its place.
  let packed: string | null = null
  const target = new BackpackTarget(
    button,
    element => nameOf(element) !== null,
    block => {
      packed = nameOf(block)
      if (packed === null && !isNew(block.id)) refuse(words.backpack.onlyDefinitions)
    },
  )
  workspace.getComponentManager().addComponent({
    component: target,
    capabilities: [Blockly.ComponentManager.Capability.DRAG_TARGET],
    weight: 3,
  })
  const changed = (event: Blockly.Events.Abstract) => {
    if (event.type !== Blockly.Events.BLOCK_DRAG) return
    const {isStart, blockId} = event as Blockly.Events.BlockDrag
    const dragged = isStart === true && blockId !== undefined ? workspace.getBlockById(blockId) : null
    button.classList.toggle("ready", nameOf(dragged as Blockly.BlockSvg | null) !== null)
    if (isStart === true) return
    target.onDragExit()
    const name = packed
    packed = null
    if (name !== null) backpack.put(name)
  }
  workspace.addChangeListener(changed)
  return () => {
    workspace.removeChangeListener(changed)
    workspace.getComponentManager().removeComponent(target.id)
    button.remove()
  }
}

const backpackPicture =
  '<svg viewBox="0 0 24 24" width="20" height="20" fill="none" stroke="currentColor" stroke-width="2" stroke-linecap="round" stroke-linejoin="round" aria-hidden="true"><path d="M6 21h12a1 1 0 0 0 1-1v-8a7 7 0 0 0-14 0v8a1 1 0 0 0 1 1zM9 5V4a3 3 0 0 1 6 0v1M8 21v-6h8v6M9 10h6"/></svg>'
