/// A block and all it carries as a value: the very same value again as long as nothing about it has changed, so that whoever asks after each edit
/// can tell at a glance which definitions are another than before, and works on those alone.
///
/// Blockly has no way to tell at once what changed (its events come frames later), but to look through all blocks is quick, and to write them down is not.

import type {SavedBlock} from "@rosy/codegen"
import * as Blockly from "blockly/core"
import {extraOf} from "./build.ts"
import {sameBlock} from "./order.ts"

interface Snapshot {
  /// All that `saved` was made from, in the order in which it is looked at.
  readonly seen: unknown[]
  saved: SavedBlock | undefined
}

const snapshots = new WeakMap<Blockly.Block, Snapshot>()

/// A top-level block as Blockly writes it down.
export function savedTop(block: Blockly.Block): SavedBlock | undefined {
  const known = snapshots.get(block)
  const snapshot: Snapshot = known ?? {seen: [], saved: undefined}
  const looking = new Looking(snapshot.seen)
  const at = block.getRelativeToSurfaceXY()
  looking.see(at.x)
  looking.see(at.y)
  look(block, looking)
  if (known !== undefined && looking.ended()) return known.saved
  snapshot.saved =
    (Blockly.serialization.blocks.save(block, {addCoordinates: true}) as SavedBlock | null) ?? undefined
  snapshots.set(block, snapshot)
  return snapshot.saved
}

/// `block` was made from `saved`: that is its value from now on, if it says the same.
export function madeFrom(block: Blockly.Block, saved: SavedBlock): void {
  const snapshot = snapshots.get(block)
  if (snapshot !== undefined && sameBlock(snapshot.saved, saved)) snapshot.saved = saved
}

/// Compares what is seen with what was seen the last time, and remembers it.
class Looking {
  private at = 0
  private same = true
  private readonly seen: unknown[]

  constructor(seen: unknown[]) {
    this.seen = seen
  }

  see(part: unknown): void {
    if (this.seen[this.at] !== part) {
      this.same = false
      this.seen[this.at] = part
    }
    this.at += 1
  }

  /// Whether all was as it was the last time.
  ended(): boolean {
    const same = this.same && this.seen.length === this.at
    this.seen.length = this.at
    return same
  }
}

function look(block: Blockly.Block, looking: Looking): void {
  looking.see(block)
  looking.see(extraOf(block))
  looking.see(block.isCollapsed())
  looking.see(block.data)
  looking.see(block.isOwnDeletable() && block.isOwnMovable() && block.isOwnEditable() && block.isEnabled())
  for (const icon of block.getIcons())
    if (icon instanceof Blockly.icons.CommentIcon) lookAtRemark(icon, looking)
  for (const {connection} of block.inputList) if (connection !== null) lookInto(connection, looking)
  if (block.nextConnection !== null) lookInto(block.nextConnection, looking)
}

function lookInto(connection: Blockly.Connection, looking: Looking): void {
  const inside = connection.targetBlock()
  if (inside === null) looking.see(null)
  else look(inside, looking)
}

function lookAtRemark(icon: Blockly.icons.CommentIcon, looking: Looking): void {
  const size = icon.getBubbleSize()
  looking.see(icon.getText())
  looking.see(icon.bubbleIsVisible())
  looking.see(size.width)
  looking.see(size.height)
}
