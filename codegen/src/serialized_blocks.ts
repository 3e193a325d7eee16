/// Blocks as Blockly 13 saves them (`Blockly.serialization`), as far as Rosy uses them.
///
/// One habit makes everything else simple: whatever a learner can set on a block (names, numbers, menus, how
/// many sockets it has) lives in `extraState`, never in `fields`. Blockly restores `extraState` before it
/// connects a block and `fields` after, so only `extraState` is there in time to know a block's type.

export type BlockId = string

export type Json = null | boolean | number | string | readonly Json[] | {readonly [key: string]: Json}

/// All that a block says about itself besides its children.
export type Extra = {readonly [key: string]: Json}

export interface SavedInput {
  block?: SavedBlock
  shadow?: SavedBlock
}

export interface SavedBlock {
  type: string
  id?: BlockId
  x?: number
  y?: number
  collapsed?: boolean
  extraState?: Extra
  inputs?: {[name: string]: SavedInput}
  next?: SavedInput
  icons?: {
    comment?: {text: string; pinned?: boolean; height?: number; width?: number; x?: number; y?: number}
  }
  data?: string
}

/// `Blockly.serialization.workspaces.save` writes further keys; they are kept by the caller and ignored here.
export interface SavedWorkspace {
  /// The text above the definitions: imports and instructions to the compiler, which have no blocks.
  header?: string
  blocks: {languageVersion: number; blocks: SavedBlock[]}
}

/// A place where a block can go: an input of a block, or the place below it in a stack.
export type Place = {readonly block: BlockId; readonly input: string} | {readonly below: BlockId}
