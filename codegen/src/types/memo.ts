/// Remembers what inference found out about top-level definitions, for questions about programs that differ in one place.
///
/// A group of definitions is known by its nodes, the types of the program's names it uses, and the program's own types. While
/// blocks are dragged, all definitions but one stay the same nodes.

import type {Declaration, Node} from "../model/tree.ts"
import {freeInDeclaration} from "../model/uses.ts"
import type {TypeProblem} from "./problems.ts"
import type {Scheme, Type} from "./type.ts"

export interface Remembered {
  readonly schemes: readonly (readonly [Declaration, Scheme])[]
  readonly types: ReadonlyMap<Node, Type>
  readonly problems: readonly TypeProblem[]
  readonly needs: readonly string[]
}

export class Memo {
  readonly groups = new Map<string, Remembered>()
  private readonly numbers = new WeakMap<object, number>()
  private readonly free = new WeakMap<Declaration, Set<string>>()
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
}
