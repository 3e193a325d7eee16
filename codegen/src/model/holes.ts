/// Whether anything is still missing, or is Haskell whose type only GHC knows.

import {everyNode} from "./child_nodes.ts"
import type {Node} from "./syntax_tree.ts"

export function hasUnknowns(node: Node): boolean {
  for (const n of everyNode(node))
    if (n.kind === "hole" || n.kind === "raw" || n.kind === "raw-pattern") return true
  return false
}
