/// Saving and loading of workspaces. Loading never throws and leaves no partial block: what cannot be loaded is skipped and returned.
///
/// An unchanged top-level block is saved as the identical value again, so that callers can compare by reference and process only what changed. Blockly offers no
/// immediate change notification (its events come frames later); visiting all blocks is fast, serializing them is not.

import type {BlockId, SavedBlock, SavedWorkspace} from "@rosy/codegen"
import * as Blockly from "blockly/core"
import {extraOf, isShown} from "../construction/block_definitions.ts"
import {checkerName} from "../dragging/connection_checker.ts"
import {deferrable, deferredBlocks, setDeferredBlocks} from "./deferred_blocks.ts"
import {changesOf, sameBlock} from "./workspace_merge.ts"

/// The text above the definitions, which is not in Blockly's workspace.
const headers = new WeakMap<Blockly.Workspace, string>()

/// The blocks as Blockly and codegen know them, with ids and positions. A top-level block that has not changed is the same value as the last time.
export function saveBlocks(workspace: Blockly.Workspace): SavedWorkspace {
  return savedWith(workspace, savedTop)
}

/// The same directly after loading, which has looked at all blocks: what it saw of each is not looked at again.
export function savedAsLoaded(workspace: Blockly.Workspace): SavedWorkspace {
  return savedWith(workspace, block => snapshots.get(block)?.saved)
}

function savedWith(
  workspace: Blockly.Workspace,
  saved: (block: Blockly.Block) => SavedBlock | undefined,
): SavedWorkspace {
  const header = headers.get(workspace)
  const made = workspace.getTopBlocks(false).flatMap(block => saved(block) ?? [])
  const blocks = [...made, ...deferredBlocks(workspace).values()]
  return {...(header === undefined ? {} : {header}), blocks: {languageVersion: 0, blocks}}
}

export interface Loaded {
  /// Top-level blocks that could not be loaded, as they were.
  readonly left: readonly SavedBlock[]
}

/// Whether Blockly can load a block with all its contents: tried in a workspace without a picture.
export function canLoad(block: SavedBlock): boolean {
  const scratch = new Blockly.Workspace(new Blockly.Options({plugins: {connectionChecker: checkerName}}))
  try {
    return append(scratch, block, new Set()) !== undefined
  } finally {
    scratch.dispose()
  }
}

/// Makes `workspace` hold `wanted`. A top-level block that is there already, the same in every respect, stays, with
/// its selection and its open editors; so does one in which only names, numbers and the like are others, which are then shown; the rest are
/// replaced. What is far outside of the visible area of a large program is made later (`deferred_blocks.ts`). No events are fired.
export function loadBlocks(workspace: Blockly.Workspace, wanted: SavedWorkspace): Loaded {
  if (wanted.header === undefined) headers.delete(workspace)
  else headers.set(workspace, wanted.header)
  const left: SavedBlock[] = []
  const there = new Map(workspace.getTopBlocks(false).map(block => [block.id, block]))
  withoutEvents(() => {
    const fresh: SavedBlock[] = []
    const coming = new Set<BlockId>()
    for (const block of wanted.blocks.blocks) {
      const now = block.id === undefined ? undefined : there.get(block.id)
      if (now === undefined || !becomes(now, block)) fresh.push(block)
      else {
        adoptSaved(now, block)
        coming.add(now.id)
      }
    }
    for (const block of there.values()) if (!coming.has(block.id)) block.dispose(false)
    const later = laterOf(workspace, fresh, wanted.blocks.blocks)
    setDeferredBlocks(workspace, [...later])
    left.push(
      ...appendAll(
        workspace,
        fresh.filter(block => !later.has(block)),
      ),
    )
  })
  return {left}
}

function laterOf(
  workspace: Blockly.Workspace,
  fresh: readonly SavedBlock[],
  all: readonly SavedBlock[],
): ReadonlySet<SavedBlock> {
  // From right to left, saved places count from the other side.
  if (!(workspace instanceof Blockly.WorkspaceSvg) || workspace.RTL) return new Set()
  return deferrable(fresh, all, workspace.getMetricsManager().getViewMetrics(true))
}

/// Makes some of the blocks that were deferred. No events are fired.
export function makeDeferred(workspace: Blockly.Workspace, blocks: readonly SavedBlock[]): Loaded {
  const chosen = new Set(blocks)
  setDeferredBlocks(
    workspace,
    [...deferredBlocks(workspace).values()].filter(block => !chosen.has(block)),
  )
  return {left: withoutEvents(() => appendAll(workspace, blocks))}
}

/// Makes blocks; those that Blockly cannot make are returned.
function appendAll(workspace: Blockly.Workspace, blocks: readonly SavedBlock[]): readonly SavedBlock[] {
  const left: SavedBlock[] = []
  const homeless: Blockly.Block[] = []
  const whole = new Set(workspace.getTopBlocks(false))
  for (const block of blocks) {
    const made = append(workspace, block, whole)
    if (made === undefined) left.push(block)
    else if (block.x === undefined && block.y === undefined) homeless.push(made)
  }
  placeBelow(workspace, homeless)
  for (const block of homeless) savedTop(block)
  return left
}

/// Acts without telling Blockly's listeners and its history.
export function withoutEvents<T>(act: () => T): T {
  const enabled = Blockly.Events.isEnabled()
  if (enabled) Blockly.Events.disable()
  try {
    return act()
  } finally {
    if (enabled) Blockly.Events.enable()
  }
}

/// Whether a block on the workspace says what `wanted` says, perhaps after others of its fields show something else.
function becomes(block: Blockly.Block, wanted: SavedBlock): boolean {
  const now = savedTop(block)
  if (now === undefined) return false
  if (sameBlock(now, wanted)) return true
  const changes = changesOf(now, wanted)
  if (changes === undefined) return false
  for (const {id, extraState} of changes) {
    const changed = block.workspace.getBlockById(id ?? "")
    changed?.loadExtraState?.(extraState ?? {})
    if (changed === null || !isShown(changed)) return false
  }
  return sameBlock(savedTop(block), wanted)
}

/// Makes a block without drawing it: to draw one by one would make the browser lay out all of them for each. When Blockly cannot make it, what it
/// has made of it is taken away again: all but the `whole` ones.
function append(
  workspace: Blockly.Workspace,
  block: SavedBlock,
  whole: Set<Blockly.Block>,
): Blockly.Block | undefined {
  try {
    const made = Blockly.serialization.blocks.appendInternal(
      block as Blockly.serialization.blocks.State,
      workspace,
    )
    savedTop(made)
    adoptSaved(made, block)
    whole.add(made)
    return made
  } catch {
    // Blockly throws for unknown kinds, missing sockets and sorts that do not join; the cause does not matter here,
    // because the text of the program, not its blocks, is what must not be lost.
    for (const half of workspace.getTopBlocks(false)) if (!whole.has(half)) half.dispose(false)
    return undefined
  }
}

/// Pixels from the edge, and between blocks, for those without a place yet.
const margin = 40
const between = 28

function placeBelow(workspace: Blockly.Workspace, blocks: readonly Blockly.Block[]): void {
  if (!(workspace instanceof Blockly.WorkspaceSvg) || blocks.length === 0) return
  Blockly.renderManagement.triggerQueuedRenders(workspace)
  const rest = workspace.getTopBlocks(false).filter(block => !blocks.includes(block))
  let y = Math.max(margin - between, ...rest.map(block => block.getBoundingRectangle().bottom)) + between
  for (const block of blocks) {
    if (!(block instanceof Blockly.BlockSvg)) continue
    const box = block.getBoundingRectangle()
    block.moveBy(margin - box.left, y - box.top)
    y += box.getHeight() + between
  }
}

interface Snapshot {
  /// All that `saved` was made from, in the order in which it is looked at.
  readonly seen: unknown[]
  saved: SavedBlock | undefined
}

const snapshots = new WeakMap<Blockly.Block, Snapshot>()

/// A top-level block as Blockly writes it down.
function savedTop(block: Blockly.Block): SavedBlock | undefined {
  const known = snapshots.get(block)
  const snapshot: Snapshot = known ?? {seen: [], saved: undefined}
  const looking = new SnapshotComparison(snapshot.seen)
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
function adoptSaved(block: Blockly.Block, saved: SavedBlock): void {
  const snapshot = snapshots.get(block)
  if (snapshot !== undefined && sameBlock(snapshot.saved, saved)) snapshot.saved = saved
}

/// Compares what is seen with what was seen the last time, and remembers it.
class SnapshotComparison {
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

function look(block: Blockly.Block, looking: SnapshotComparison): void {
  looking.see(block)
  looking.see(extraOf(block))
  looking.see(block.isCollapsed())
  looking.see(block.data)
  looking.see(block.isOwnDeletable() && block.isOwnMovable() && block.isOwnEditable() && block.isEnabled())
  const remark = block.getIcon(Blockly.icons.CommentIcon.TYPE)
  if (remark !== undefined) lookAtRemark(remark, looking)
  for (const {connection} of block.inputList) if (connection !== null) lookInto(connection, looking)
  if (block.nextConnection !== null) lookInto(block.nextConnection, looking)
}

function lookInto(connection: Blockly.Connection, looking: SnapshotComparison): void {
  const inside = connection.targetConnection?.getSourceBlock()
  if (inside === undefined) looking.see(null)
  else look(inside, looking)
}

type Remark = Pick<Blockly.icons.CommentIcon, "getText" | "bubbleIsVisible" | "getBubbleSize">

function lookAtRemark(icon: Remark, looking: SnapshotComparison): void {
  const size = icon.getBubbleSize()
  looking.see(icon.getText())
  looking.see(icon.bubbleIsVisible())
  looking.see(size.width)
  looking.see(size.height)
}
