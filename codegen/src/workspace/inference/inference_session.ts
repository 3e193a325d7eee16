/// Cached inference for successive versions of one workspace, by identity of its serialized blocks.

import type {ReadTree} from "../../blocks/block_reader.ts"
import {readWorkspace} from "../../blocks/block_reader.ts"
import type {SavedBlock, SavedWorkspace} from "../../serialized_blocks.ts"
import {InferenceCache} from "../../types/inference_cache.ts"
import type {InferenceQuestion, InferredWorkspace} from "./workspace_inference.ts"
import {inferModel} from "./workspace_inference.ts"

/// Groups of definitions that are remembered at most; then all are forgotten.
const most = 5000

export class InferenceSession {
  private readonly known = new WeakMap<SavedBlock, ReadTree>()
  private cache = new InferenceCache()

  inferWorkspace(workspace: SavedWorkspace, question: InferenceQuestion = {}): InferredWorkspace {
    if (this.cache.groups.size > most) this.cache = new InferenceCache()
    return inferModel(readWorkspace(workspace, this.known), {...question, cache: this.cache})
  }
}
