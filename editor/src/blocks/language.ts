/// What the block view asks of codegen, as one value, so that tests can ask a smaller language.

import type {
  BlockId,
  BlockView,
  Inference,
  Level,
  Renaming,
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
  toolbox(level: Level): readonly ToolboxCategory[]
  /// What the search finds besides what the toolbox shows.
  libraryItems(): readonly ToolboxItem[]
  /// What was typed into the search as a block of its own: a number, a text, a new name.
  typedItems(typed: string): readonly ToolboxItem[]
}
