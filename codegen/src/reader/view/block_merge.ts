/// Three-way merge of block trees by block identity: an edit that was made in the last whole blocks of a definition, applied to the blocks of its text.
///
/// In: the blocks as they were shown (`base`), the same after the edit (`edited`), and the blocks of the text (`current`), which has a syntax error and
/// may say other things. Out: the blocks of the text with the edit, or undefined where the edit concerns what the text does not have like that.
/// Blocks that only the text has, above all the unfinished part, are never removed.

import type {SavedBlock, SavedInput} from "../../serialized_blocks.ts"
import {hashTree} from "./tree_matching.ts"

/// `outside` are the blocks of other definitions after the edit, to which parts may have been moved.
export function mergeTrees(
  base: SavedBlock,
  edited: SavedBlock,
  current: SavedBlock,
  outside: readonly SavedBlock[],
): SavedBlock | undefined {
  const merge = new TreeMerge(base, current)
  try {
    const merged = merge.block(edited)
    merge.mayLeave(outside)
    merge.holdsAll(merged)
    return merged
  } catch (error) {
    if (error instanceof Conflict) return undefined
    throw error
  }
}

/// The edit cannot be applied.
class Conflict extends Error {}

/// The name of the connection below a block of a stack, beside those of its inputs.
const below = "next"

class TreeMerge {
  private readonly base: ReadonlyMap<string, SavedBlock>
  private readonly current: ReadonlyMap<string, SavedBlock>
  /// For blocks of the base that the text lacks: what it has in their place.
  private readonly substitutes = new Map<string, SavedBlock>()

  constructor(base: SavedBlock, current: SavedBlock) {
    this.base = byId(base)
    this.current = byId(current)
    for (const [id, block] of this.base)
      for (const [name, child] of childrenOf(block)) {
        const there = childrenOf(this.current.get(id)).get(name)
        if (there === undefined || this.current.has(child.id ?? "") || this.base.has(there.id ?? "")) continue
        this.substitutes.set(child.id ?? "", there)
      }
  }

  /// A block of the edited tree as the text has it, with what the edit changed.
  block(edited: SavedBlock): SavedBlock {
    const id = edited.id ?? ""
    const base = this.base.get(id)
    if (base === undefined) return withChildren(edited, this.fresh(edited))
    const current = this.current.get(id)
    if (current === undefined) {
      const substitute = this.substitutes.get(id)
      if (substitute === undefined || hashTree(base, true) !== hashTree(edited, true)) throw new Conflict()
      if (!sameIds(base, edited)) throw new Conflict()
      return substitute
    }
    if (base.type !== edited.type || base.type !== current.type) throw new Conflict()
    const {x, y, collapsed} = edited
    const own: SavedBlock = {
      ...current,
      ...(x === undefined ? {} : {x}),
      ...(y === undefined ? {} : {y}),
      ...(collapsed === undefined ? {} : {collapsed}),
    }
    const extra = threeWay(base.extraState, edited.extraState, current.extraState)
    if (extra === undefined) delete own.extraState
    else own.extraState = extra
    const remark = threeWay(
      base.icons?.comment?.text,
      edited.icons?.comment?.text,
      current.icons?.comment?.text,
    )
    if (remark === undefined) delete own.icons
    else own.icons = {comment: {...edited.icons?.comment, text: remark}}
    return withChildren(own, this.children(base, edited, current))
  }

  private fresh(edited: SavedBlock): Map<string, SavedBlock> {
    return new Map([...childrenOf(edited)].map(([name, child]) => [name, this.block(child)]))
  }

  private children(base: SavedBlock, edited: SavedBlock, current: SavedBlock): Map<string, SavedBlock> {
    const [was, is, has] = [childrenOf(base), childrenOf(edited), childrenOf(current)]
    const result = new Map<string, SavedBlock>()
    for (const name of new Set([...was.keys(), ...is.keys(), ...has.keys()])) {
      const [b, e, c] = [was.get(name), is.get(name), has.get(name)]
      const stands = c?.id === b?.id || (b !== undefined && c !== undefined && this.standsFor(b) === c)
      if (e !== undefined && (stands || e.id !== b?.id)) {
        if (!stands) throw new Conflict()
        result.set(name, this.block(e))
      } else if (e?.id !== b?.id) {
        if (!stands) throw new Conflict()
      } else {
        // The text has something else here, and the edit left it alone.
        if (e !== undefined && b !== undefined && hashTree(e, true) !== hashTree(b, true))
          throw new Conflict()
        if (c !== undefined) result.set(name, c)
      }
    }
    return result
  }

  private standsFor(base: SavedBlock): SavedBlock | undefined {
    return this.current.get(base.id ?? "") ?? this.substitutes.get(base.id ?? "")
  }

  /// Parts that were moved out of the definition must say what the text says of them.
  mayLeave(outside: readonly SavedBlock[]): void {
    for (const top of outside)
      for (const id of byId(top).keys()) {
        const base = this.base.get(id)
        if (base === undefined) continue
        const current = this.current.get(id)
        if (current === undefined || ownHash(base) !== ownHash(current)) throw new Conflict()
      }
  }

  /// Blocks that only the text has are all still there, and none is there twice.
  holdsAll(merged: SavedBlock): void {
    const ids = idsOf(merged)
    const there = new Set(ids)
    if (there.size !== ids.length) throw new Conflict()
    for (const id of this.current.keys()) if (!this.base.has(id) && !there.has(id)) throw new Conflict()
  }
}

function ownHash(block: SavedBlock): number {
  const {next: _, ...alone} = block
  return hashTree(alone, true)
}

function sameIds(one: SavedBlock, other: SavedBlock): boolean {
  return idsOf(one).join(" ") === idsOf(other).join(" ")
}

/// What the edit says where it changed something, else what the text says.
function threeWay<T>(base: T, edited: T, current: T): T {
  const [b, e, c] = [base, edited, current].map(written)
  if (b === e) return current
  if (b !== c) throw new Conflict()
  return edited
}

/// A value as text, whatever the order of its keys.
function written(value: unknown): string {
  return JSON.stringify(value ?? null, (_, part: unknown) =>
    typeof part === "object" && part !== null && !Array.isArray(part)
      ? Object.fromEntries(Object.entries(part).sort(([a], [b]) => (a < b ? -1 : 1)))
      : part,
  )
}

function childrenOf(block: SavedBlock | undefined): Map<string, SavedBlock> {
  const found = new Map<string, SavedBlock>()
  for (const [name, input] of Object.entries(block?.inputs ?? {})) {
    const child = input.block ?? input.shadow
    if (child !== undefined) found.set(name, child)
  }
  if (block?.next?.block !== undefined) found.set(below, block.next.block)
  return found
}

function withChildren(block: SavedBlock, children: ReadonlyMap<string, SavedBlock>): SavedBlock {
  const {inputs: _, next: __, ...own} = block
  const inputs: {[name: string]: SavedInput} = {}
  for (const [name, child] of children) if (name !== below) inputs[name] = {block: child}
  const under = children.get(below)
  return {
    ...own,
    ...(Object.keys(inputs).length === 0 ? {} : {inputs}),
    ...(under === undefined ? {} : {next: {block: under}}),
  }
}

function byId(block: SavedBlock): ReadonlyMap<string, SavedBlock> {
  const found = new Map<string, SavedBlock>()
  const visit = (b: SavedBlock): void => {
    found.set(b.id ?? "", b)
    for (const child of childrenOf(b).values()) visit(child)
  }
  visit(block)
  return found
}

function idsOf(block: SavedBlock): readonly string[] {
  return [block.id ?? "", ...[...childrenOf(block).values()].flatMap(idsOf)]
}
