/// Cache of inference results for groups of top-level definitions.
///
/// A group of definitions is known by its nodes, the types of the program's names it uses, and the program's own types. While
/// blocks are dragged, all definitions but one stay the same nodes.

import {everyNode} from "../model/child_nodes.ts"
import {freeInDeclaration} from "../model/name_resolution.ts"
import type {Declaration, Node} from "../model/syntax_tree.ts"
import type {BlockId} from "../serialized_blocks.ts"
import type {Environment} from "./environment/environment.ts"
import type {Scheme, Type} from "./syntax/type.ts"
import type {TypeProblem} from "./syntax/type_problems.ts"

/// The types of a group of definitions that use each other.
export interface InferredGroup {
  readonly members: readonly Declaration[]
  readonly types: ReadonlyMap<Node, Type>
}

export interface CachedGroup extends InferredGroup {
  /// Of the members, and of what is defined inside them.
  readonly schemes: readonly (readonly [Declaration, Scheme])[]
  readonly problems: readonly TypeProblem[]
  readonly needs: readonly string[]
  readonly unsignable: readonly Declaration[]
}

/// The program's own types, with what is wrong with them.
export interface TypesOfProgram {
  readonly env: Environment
  readonly problems: readonly TypeProblem[]
}

/// A signature as it was read: of the same text with the same types it is read in the same way again.
export interface ReadSignature {
  readonly typesKey: string
  readonly text: string
  readonly scheme: Scheme | undefined
  readonly problems: readonly TypeProblem[]
  readonly isLarge: boolean
}

export class InferenceCache {
  /// By the numbers of the declarations.
  readonly ownTypes = new Map<string, TypesOfProgram>()
  readonly groups = new Map<string, CachedGroup>()
  readonly signatures = new WeakMap<Node, ReadSignature>()
  private readonly numbers = new WeakMap<object, number>()
  private readonly free = new WeakMap<Declaration, Set<string>>()
  private readonly blocks = new WeakMap<Declaration, Set<BlockId>>()
  private count = 0

  numberOf(node: object): number {
    const known = this.numbers.get(node)
    if (known !== undefined) return known
    const number = this.count++
    this.numbers.set(node, number)
    return number
  }

  freeIn(d: Declaration): Set<string> {
    const known = this.free.get(d)
    if (known !== undefined) return known
    const names = freeInDeclaration(d)
    this.free.set(d, names)
    return names
  }

  /// Whether a definition is made from a block, or has it in it.
  holds(d: Declaration, block: BlockId): boolean {
    let known = this.blocks.get(d)
    if (known === undefined) {
      known = new Set()
      for (const n of everyNode(d)) if (n.kind !== "program" && n.from !== undefined) known.add(n.from.block)
      this.blocks.set(d, known)
    }
    return known.has(block)
  }
}
