/// Interface of codegen as the block view uses it, so that tests can substitute a smaller language.

import type {
  BlockId,
  BlockView,
  Inference,
  Level,
  LookInside,
  Renaming,
  SavedBlock,
  SavedWorkspace,
  Session,
  ToolboxCategory,
  ToolboxItem,
} from "@rosy/codegen"

export interface Language {
  readonly blockTypes: readonly BlockView[]
  /// What is known of a workspace is remembered for the next question, as long as its blocks are the very same values.
  session(): Session
  infer(workspace: SavedWorkspace): Inference
  rename(workspace: SavedWorkspace, block: BlockId, key: string, name: string): Renaming
  /// The definitions behind a block that calls a ready-made task.
  lookInside(workspace: SavedWorkspace, block: BlockId): LookInside | undefined
  /// The program's own definition of the task that a block calls.
  ownDefinition(workspace: SavedWorkspace, block: BlockId): BlockId | undefined
  toolbox(level: Level): readonly ToolboxCategory[]
  /// What the search finds besides what the toolbox shows.
  libraryItems(): readonly ToolboxItem[]
  /// A ready block with the only event of the program that it can take; any other block as it is.
  withOnlyEvent(block: SavedBlock, workspace: SavedWorkspace): SavedBlock
  /// What was typed into the search as a block of its own: a number, a text, a new name.
  typedItems(typed: string): readonly ToolboxItem[]
}
