/// Creation of deferred blocks: those that come near the visible area at once, all of them as soon as the block view is used by pointer or keyboard, and the rest
/// one by one while the page has nothing else to do and no key is pressed.

import type {BlockId, SavedBlock} from "@rosy/codegen"
import type * as Blockly from "blockly/core"
import {whenIdle} from "../../../browser/browser_window.ts"
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

/// Milliseconds after a key press in which none is made: in fluent typing the next key would wait for it.
const typingPause = 500

/// `made` is called when further blocks stand on the workspace.
export function openDeferredCreation(
  workspace: Blockly.WorkspaceSvg,
  host: HTMLElement,
  made: (blocks: ReadonlySet<BlockId | undefined>) => void,
): DeferredCreation {
  let isScheduled = false
  let isDisposed = false
  let lastKey = Number.NEGATIVE_INFINITY
  let timer: ReturnType<typeof setTimeout> | undefined

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
    if (performance.now() - lastKey < typingPause) return begin()
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
    const pause = Math.max(0, lastKey + typingPause - performance.now())
    if (pause > 0) timer = setTimeout(() => whenIdle(makeNext), pause)
    else whenIdle(makeNext)
  }

  const moved = (event: Blockly.Events.Abstract) => {
    if (event.type === "viewport_change") makeNear()
  }
  workspace.addChangeListener(moved)
  const stop = new AbortController()
  for (const kind of ["pointerdown", "keydown", "focusin", "dragenter"])
    host.addEventListener(kind, makeAll, {capture: true, signal: stop.signal})
  const keyPressed = () => {
    lastKey = performance.now()
  }
  window.addEventListener("keydown", keyPressed, {capture: true, signal: stop.signal})
  return {
    begin,
    makeNear,
    makeHolderOf: id => make(block => holdsBlock(block, id)),
    makeAll,
    dispose() {
      isDisposed = true
      stop.abort()
      clearTimeout(timer)
      workspace.removeChangeListener(moved)
    },
  }
}
