/// Blocks in and out of a workspace. Loading never throws and never leaves half of a block behind: everything is
/// tried in a workspace without a picture first, and what cannot be loaded is left out and named.

import type {BlockId, SavedBlock, SavedWorkspace} from "@rosy/codegen"
import * as Blockly from "blockly/core"
import {checkerName} from "./checker.ts"
import {inOneOrder} from "./order.ts"

/// The text above the definitions, which Blockly knows nothing of.
const headers = new WeakMap<Blockly.Workspace, string>()

/// The blocks as Blockly and codegen know them, with ids and positions.
export function saveBlocks(workspace: Blockly.Workspace): SavedWorkspace {
  const saved = Blockly.serialization.workspaces.save(workspace) as Partial<SavedWorkspace>
  const header = headers.get(workspace)
  return {
    ...saved,
    ...(header === undefined ? {} : {header}),
    blocks: saved.blocks ?? {languageVersion: 0, blocks: []},
  }
}

export interface Loaded {
  /// Top-level blocks that could not be loaded, as they were.
  readonly left: readonly SavedBlock[]
}

/// Whether Blockly knows a block and all it carries.
export function loads(block: SavedBlock): boolean {
  const scratch = scratchPad()
  try {
    return possible(block, scratch)
  } finally {
    scratch.dispose()
  }
}

/// A workspace without a picture, to try things in.
function scratchPad(): Blockly.Workspace {
  return new Blockly.Workspace(new Blockly.Options({plugins: {connectionChecker: checkerName}}))
}

/// Makes `workspace` hold `wanted`. A top-level block that is there already, the same in every respect, stays, with
/// its selection and its open editors; the others are replaced. No events are fired.
export function loadBlocks(workspace: Blockly.Workspace, wanted: SavedWorkspace): Loaded {
  if (wanted.header === undefined) headers.delete(workspace)
  else headers.set(workspace, wanted.header)
  const left: SavedBlock[] = []
  const there = new Map(saveBlocks(workspace).blocks.blocks.map(block => [block.id, inOneOrder(block)]))
  const coming = new Set<BlockId | undefined>()
  const scratch = scratchPad()
  const enabled = Blockly.Events.isEnabled()
  if (enabled) Blockly.Events.disable()
  try {
    const fresh: SavedBlock[] = []
    const homeless: Blockly.Block[] = []
    for (const block of wanted.blocks.blocks) {
      if (block.id !== undefined && there.get(block.id) === inOneOrder(block)) coming.add(block.id)
      else fresh.push(block)
    }
    for (const block of workspace.getTopBlocks(false)) if (!coming.has(block.id)) block.dispose(false)
    for (const block of fresh) {
      if (!possible(block, scratch)) left.push(block)
      else {
        const made = Blockly.serialization.blocks.append(
          block as Blockly.serialization.blocks.State,
          workspace,
        )
        if (block.x === undefined && block.y === undefined) homeless.push(made)
      }
    }
    placeBelow(workspace, homeless)
  } finally {
    scratch.dispose()
    if (enabled) Blockly.Events.enable()
  }
  return {left}
}

/// Pixels from the edge, and between blocks, for those that nobody has placed yet.
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

/// Whether Blockly can load a block and all it carries.
function possible(block: SavedBlock, scratch: Blockly.Workspace): boolean {
  try {
    Blockly.serialization.blocks.append(block as Blockly.serialization.blocks.State, scratch)
    return true
  } catch {
    // Blockly throws for unknown kinds, missing sockets and sorts that do not join; the cause does not matter here,
    // because the text of the program, not its blocks, is what must not be lost.
    return false
  } finally {
    scratch.clear()
  }
}
