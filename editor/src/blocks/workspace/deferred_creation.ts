/// Creation of deferred blocks: those that come near the visible area at once, all of them as soon as the block view is used by pointer or keyboard, and the rest
/// one by one while the page has nothing else to do.

import type {BlockId, SavedBlock} from "@rosy/codegen"
import type * as Blockly from "blockly/core"
import {whenIdle} from "../../browser/browser_window.ts"
import {deferredBlocks, holdsBlock, isFarFrom} from "./deferred_blocks.ts"
import {makeDeferred} from "./serialization.ts"

export interface DeferredCreation {
  /// Blocks were loaded: begins to make what they left for later.
  begin(): void
  /// Makes what is near the visible area.
  makeNear(): void
  /// Makes the top-level block that holds this one.
  makeHolderOf(id: BlockId): void
  makeAll(): void
  dispose(): void
}

/// Made at a time while the page has nothing else to do: some 30 ms of work.
const atOnce = 2

/// `made` is called when further blocks stand on the workspace.
export function openDeferredCreation(
  workspace: Blockly.WorkspaceSvg,
  host: HTMLElement,
  made: (blocks: ReadonlySet<BlockId | undefined>) => void,
): DeferredCreation {
  let isScheduled = false
  let isDisposed = false

  const make = (chosen: (block: SavedBlock) => boolean) => {
    const blocks = [...deferredBlocks(workspace).values()].filter(chosen)
    if (blocks.length === 0) return
    makeDeferred(workspace, blocks)
    made(new Set(blocks.map(block => block.id)))
  }
  const makeAll = () => make(() => true)
  const view = () => workspace.getMetricsManager().getViewMetrics(true)
  const makeNear = () => {
    if (deferredBlocks(workspace).size === 0) return
    const range = view()
    make(block => !isFarFrom(range, block))
  }
  const makeNext = () => {
    isScheduled = false
    if (isDisposed) return
    const {left, top} = view()
    const distance = ({x = 0, y = 0}: SavedBlock) => Math.abs(x - left) + Math.abs(y - top)
    const blocks = [...deferredBlocks(workspace).values()].sort(
      (one, other) => distance(one) - distance(other),
    )
    const next = new Set(blocks.slice(0, atOnce))
    make(block => next.has(block))
    begin()
  }
  const begin = () => {
    if (isScheduled || deferredBlocks(workspace).size === 0) return
    isScheduled = true
    whenIdle(makeNext)
  }

  const moved = (event: Blockly.Events.Abstract) => {
    if (event.type === "viewport_change") makeNear()
  }
  workspace.addChangeListener(moved)
  const stop = new AbortController()
  for (const kind of ["pointerdown", "keydown", "focusin", "dragenter"])
    host.addEventListener(kind, makeAll, {capture: true, signal: stop.signal})
  return {
    begin,
    makeNear,
    makeHolderOf: id => make(block => holdsBlock(block, id)),
    makeAll,
    dispose() {
      isDisposed = true
      stop.abort()
      workspace.removeChangeListener(moved)
    },
  }
}
