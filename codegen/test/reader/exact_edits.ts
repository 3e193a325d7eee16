/// Random edits of blocks, and what each of them may change in the text.

import {readTree} from "../../src/blocks/block_reader.ts"
import {blockView, spanOf} from "../../src/index.ts"
import type {Reader, View} from "../../src/reader/index.ts"
import {spansOf, syncBlocks, workspaceOf} from "../../src/reader/index.ts"
import {meaningOf} from "../../src/reader/printing/model_parts.ts"
import {writeBack} from "../../src/reader/printing/text_patches.ts"
import type {SavedBlock, SavedWorkspace} from "../../src/serialized_blocks.ts"
import type {Dice} from "../generate/random.ts"
import {everyBlock} from "./agreement.ts"
import type {Place} from "./edit_locality.ts"
import {changedElsewhere, lostTexts, withComments} from "./edit_locality.ts"

export const editKinds = ["number", "wrap", "swap", "delete-step", "copy-step", "replace"] as const
export type EditKind = (typeof editKinds)[number]

export interface Edited {
  readonly kind: EditKind
  /// The number of the edited definition in the view.
  readonly definition: number
  readonly workspace: SavedWorkspace
  /// The blocks whose text may change.
  readonly touched: readonly string[]
  /// Those of them whose own text stays, at another place or with something around it.
  readonly kept: readonly string[]
}

/// The sockets of a definition that hold an expression, with the block around each.
function socketsIn(block: SavedBlock): {holder: SavedBlock; input: string; inner: SavedBlock}[] {
  return everyBlock(block).flatMap(holder =>
    Object.entries(holder.inputs ?? {}).flatMap(([input, {block: inner}]) =>
      inner !== undefined && blockView(inner.type)?.meaning.as === "expression"
        ? [{holder, input, inner}]
        : [],
    ),
  )
}

/// One random edit of a random definition; undefined when the definition has no place for it.
export function randomEdit(view: View, dice: Dice, kind: EditKind): Edited | undefined {
  const workspace = structuredClone(workspaceOf(view))
  const definition = dice.below(Math.max(1, view.declarations.length))
  const top = workspace.blocks.blocks[definition]
  if (top === undefined || top.type === "raw_definition" || view.declarations[definition]?.dimmed)
    return undefined
  const present = (ids: readonly (string | undefined)[]) => ids.flatMap(id => (id === undefined ? [] : [id]))
  const done = (
    touched: readonly (string | undefined)[],
    kept: readonly (string | undefined)[] = [],
  ): Edited => ({
    kind,
    definition,
    workspace,
    touched: present(touched),
    kept: present(kept),
  })
  const sockets = socketsIn(top)
  switch (kind) {
    case "number": {
      const numbers = everyBlock(top).filter(b => b.type === "number")
      if (numbers.length === 0) return undefined
      const number = dice.pick(numbers)
      number.extraState = {value: String(7000 + dice.below(900))}
      return done([number.id])
    }
    case "replace": {
      if (sockets.length === 0) return undefined
      const {holder, input, inner} = dice.pick(sockets)
      ;(holder.inputs ?? {})[input] = {block: {type: "number", id: "x1", extraState: {value: "7"}}}
      return done([inner.id])
    }
    case "wrap": {
      if (sockets.length === 0) return undefined
      const {holder, input, inner} = dice.pick(sockets)
      const sum: SavedBlock = {
        type: "infix",
        id: "x1",
        extraState: {op: dice.pick(["+", "*", "&&"])},
        inputs: {L: {block: inner}, R: {block: {type: "number", id: "x2", extraState: {value: "7"}}}},
      }
      ;(holder.inputs ?? {})[input] = {block: sum}
      return done([inner.id], [inner.id])
    }
    case "swap": {
      const pairs = everyBlock(top).filter(b => sockets.filter(s => s.holder === b).length >= 2)
      if (pairs.length === 0) return undefined
      const holder = dice.pick(pairs)
      const [a, b] = sockets.filter(s => s.holder === holder)
      if (a === undefined || b === undefined) return undefined
      ;(holder.inputs ?? {})[a.input] = {block: b.inner}
      ;(holder.inputs ?? {})[b.input] = {block: a.inner}
      return done([a.inner.id, b.inner.id], [a.inner.id, b.inner.id])
    }
    case "delete-step":
    case "copy-step": {
      const steps = everyBlock(top).filter(b => b !== top && b.next?.block !== undefined)
      if (steps.length === 0) return undefined
      const step = dice.pick(steps)
      const next = step.next?.block
      if (next === undefined) return undefined
      if (kind === "delete-step") {
        // The last step gives the result and stays.
        if (next.next?.block === undefined) return undefined
        step.next = {block: next.next.block}
        return done([next.id])
      }
      const {next: _, ...alone} = structuredClone(step)
      for (const [i, b] of everyBlock(alone).entries()) b.id = `x${i}`
      step.next = {block: {...alone, next: {block: next}}}
      return done([step.id], [step.id])
    }
  }
}

/// What one edit did to the text.
export interface Outcome {
  readonly before: string
  readonly after: string
  /// The edited nodes in the text before.
  readonly places: readonly Place[]
  /// Characters that were removed or inserted between the common start and the common end.
  readonly changed: number
  /// Definitions for which a node around the changed one was written, and those that were printed as a whole.
  readonly larger: number
  readonly printed: number
  /// The edit was taken back: the text cannot say it.
  readonly isRefused: boolean
  /// The old blocks bring back the old text.
  readonly isPutBack: boolean
  /// The whole program is read as the workspace says it.
  readonly agrees: boolean
  /// What changed elsewhere than in the edited nodes and the separators beside them.
  readonly elsewhere: string | undefined
  /// Texts of kept nodes that are gone.
  readonly lost: readonly string[]
}

const counted = {exact: 0, larger: 0, printed: 0}

export function outcomeOf(reader: Reader, view: View, edit: Edited): Outcome {
  const {larger, printed} = {...counted}
  const after = syncBlocks(reader, view, edit.workspace, {count: counted})
  const before = view.text
  const [own] = readTree(edit.workspace.blocks.blocks[edit.definition] as SavedBlock).declarations
  const shown = view.declarations[edit.definition]
  const piece = after.module.pieces[shown?.piece ?? -1]
  const signed = own?.kind === "function" && piece?.declaration?.kind === "function"
  const signature = piece?.declaration?.kind === "function" ? piece.declaration.signature : undefined
  const wanted =
    own === undefined
      ? undefined
      : reader.read(
          writeBack(view.module, {
            pieces: new Map([[shown?.piece ?? -1, signed ? {...own, signature} : own]]),
            added: [],
          }),
        ).pieces[shown?.piece ?? -1]?.declaration
  const spans = spansOf(view)
  const placesOf = (ids: readonly string[]) => ids.flatMap(id => spanOf(spans, id) ?? [])
  const places = placesOf(edit.touched).map(p => (edit.kind === "delete-step" ? withComments(before, p) : p))
  return {
    before,
    after: after.text,
    places,
    isRefused: after.refused !== undefined,
    isPutBack: syncBlocks(reader, after, structuredClone(workspaceOf(view))).text === before,
    larger: counted.larger - larger,
    printed: counted.printed - printed,
    changed: changedCharacters(before, after.text),
    agrees:
      wanted !== undefined &&
      piece?.declaration !== undefined &&
      meaningOf(wanted) === meaningOf(piece.declaration),
    elsewhere:
      places.length < edit.touched.length
        ? "a block has no place in the text"
        : changedElsewhere(before, after.text, places),
    lost: lostTexts(before, after.text, placesOf(edit.kept)),
  }
}

function changedCharacters(before: string, after: string): number {
  const shorter = Math.min(before.length, after.length)
  let start = 0
  while (start < shorter && before[start] === after[start]) start++
  let end = 0
  while (end < shorter - start && before[before.length - 1 - end] === after[after.length - 1 - end]) end++
  return before.length + after.length - 2 * (start + end)
}
