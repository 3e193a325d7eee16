/// What the block view asks of codegen, as one value, so that tests can ask a smaller language.

import type {
  BlockId,
  BlockView,
  Checker,
  Inference,
  InScope,
  Level,
  Place,
  Renaming,
  SavedWorkspace,
  ToolboxCategory,
} from "@rosy/codegen"

export interface Language {
  readonly blockTypes: readonly BlockView[]
  checker(workspace: SavedWorkspace): Checker
  infer(workspace: SavedWorkspace): Inference
  rename(workspace: SavedWorkspace, block: BlockId, key: string, name: string): Renaming
  namesInScope(workspace: SavedWorkspace, place: Place): readonly InScope[]
  toolbox(level: Level): readonly ToolboxCategory[]
}
