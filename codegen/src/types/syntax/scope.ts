/// Names in scope with their types: a chain, nearest first, so that going inwards costs nothing.

import type {Scheme} from "./type.ts"

export class Scope {
  private readonly own = new Map<string, Scheme>()
  private readonly outer: Scope | undefined

  constructor(outer?: Scope) {
    this.outer = outer
  }

  get(name: string): Scheme | undefined {
    let at: Scope | undefined = this
    while (at !== undefined) {
      const found = at.own.get(name)
      if (found !== undefined) return found
      at = at.outer
    }
    return undefined
  }

  set(name: string, scheme: Scheme): void {
    this.own.set(name, scheme)
  }

  inner(): Scope {
    return new Scope(this)
  }

  /// All names, nearest first; a hidden name shows only as what hides it.
  all(): [string, Scheme][] {
    const found = new Map<string, Scheme>()
    for (let at: Scope | undefined = this; at !== undefined; at = at.outer)
      for (const [name, scheme] of [...at.own].reverse()) if (!found.has(name)) found.set(name, scheme)
    return [...found]
  }
}
