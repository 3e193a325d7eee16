/// What can be remembered from one question about a workspace to the next, as long as its saved blocks are the very same objects.

import type {ReadTree} from "../blocks/read.ts"
import {readWorkspace} from "../blocks/read.ts"
import type {Origin} from "../model/tree.ts"
import type {SavedBlock, SavedWorkspace} from "../saved.ts"
import {Memo} from "../types/memo.ts"
import type {Solved} from "./infer.ts"
import {solveRead} from "./infer.ts"

/// Groups of definitions that are remembered at most; then all are forgotten.
const most = 5000

export class Session {
  private readonly known = new WeakMap<SavedBlock, ReadTree>()
  private memo = new Memo()

  solve(workspace: SavedWorkspace, watch?: Origin): Solved {
    if (this.memo.groups.size > most) this.memo = new Memo()
    return solveRead(readWorkspace(workspace, this.known), watch, this.memo)
  }
}
