/// Drop target for new blocks beside the workspace: the text of the program.

import type {SavedBlock} from "@rosy/codegen"
import * as Blockly from "blockly/core"

export interface TextDropTarget {
  /// Where it is on the screen; `null` while it is not to be seen.
  area(): DOMRect | null
  /// A block is held over this place, in pixels of the window.
  over(block: SavedBlock, x: number, y: number): void
  /// It is held there no longer.
  left(): void
  /// It was let fall there. The workspace forgets it.
  dropped(block: SavedBlock, x: number, y: number): void
}

class DropArea extends Blockly.DeleteArea {
  override readonly id = "rosyOutside"
  private readonly outside: TextDropTarget
  /// Whether a block came from the toolbox, or out of a binder, with this very drag.
  private readonly isNew: (id: string) => boolean
  /// Where the pointer is.
  readonly pointer = {x: 0, y: 0}
  private held: SavedBlock | undefined

  constructor(outside: TextDropTarget, isNew: (id: string) => boolean) {
    super()
    this.outside = outside
    this.isNew = isNew
  }

  override getClientRect(): Blockly.utils.Rect | null {
    const area = this.outside.area()
    return area === null ? null : new Blockly.utils.Rect(area.top, area.bottom, area.left, area.right)
  }

  override wouldDelete(element: Blockly.IDraggable): boolean {
    return element instanceof Blockly.BlockSvg && this.isNew(element.id)
  }

  override onDragEnter(element: Blockly.IDraggable): void {
    if (!(element instanceof Blockly.BlockSvg) || !this.isNew(element.id)) return
    this.held = (Blockly.serialization.blocks.save(element) as SavedBlock | null) ?? undefined
  }

  override onDragOver(): void {
    if (this.held !== undefined) this.outside.over(this.held, this.pointer.x, this.pointer.y)
  }

  override onDragExit(): void {
    this.held = undefined
    this.outside.left()
  }

  override onDrop(): void {
    const {held} = this
    this.onDragExit()
    if (held !== undefined) this.outside.dropped(held, this.pointer.x, this.pointer.y)
  }
}

/// Lets new blocks of a workspace fall outside of it. What it gives back ends that.
export function enableTextDrop(
  workspace: Blockly.WorkspaceSvg,
  outside: TextDropTarget,
  isNew: (id: string) => boolean,
): () => void {
  const area = new DropArea(outside, isNew)
  const {Capability} = Blockly.ComponentManager
  workspace.getComponentManager().addComponent({
    component: area,
    capabilities: [Capability.DRAG_TARGET, Capability.DELETE_AREA],
    weight: 1,
  })
  const onMove = (event: PointerEvent) => {
    area.pointer.x = event.clientX
    area.pointer.y = event.clientY
  }
  const onDrag = (event: Blockly.Events.Abstract) => {
    if (event.type !== Blockly.Events.BLOCK_DRAG) return
    // The regions may have moved since the last drag.
    if ((event as Blockly.Events.BlockDrag).isStart) workspace.recordDragTargets()
    else area.onDragExit()
  }
  window.addEventListener("pointermove", onMove, {capture: true})
  workspace.addChangeListener(onDrag)
  return () => {
    window.removeEventListener("pointermove", onMove, {capture: true})
    workspace.removeChangeListener(onDrag)
  }
}
