/// Drop checker: whether a block may go to a place, decided by type inference, with a sentence if not.

import type {Checker, Verdict} from "../../api.ts"
import type {Connects, Item} from "../../block_shape.ts"
import {blockView} from "../../blocks/block_registry.ts"
import type {BlockId, Place, SavedBlock, SavedWorkspace} from "../../serialized_blocks.ts"
import {showType} from "../../types/syntax/type.ts"
import {words} from "../../words/index.ts"
import type {Doubt} from "../inference/connection_certainty.ts"
import {doubtAbout} from "../inference/connection_certainty.ts"
import {InferenceSession} from "../inference/inference_session.ts"
import type {InferredWorkspace} from "../inference/workspace_inference.ts"
import {find, plug, without} from "./block_moves.ts"
import {isRefusal, why} from "./refusal_messages.ts"

export function fits(workspace: SavedWorkspace, place: Place, block: SavedBlock | BlockId): Verdict {
  return checker(workspace).fits(place, block)
}

/// A block taken out of the workspace, and what is known about both.
interface Lifted {
  readonly rest: SavedWorkspace
  readonly block: SavedBlock
  readonly base: InferredWorkspace
}

/// Keeps what it worked out about the workspace, so that a drag asks many times and pays once.
export function checker(workspace: SavedWorkspace, session = new InferenceSession()): Checker {
  const inferWorkspace = (w: SavedWorkspace) => session.inferWorkspace(w)
  const solveWith = (rest: SavedWorkspace, block: SavedBlock) =>
    inferWorkspace({...rest, blocks: {...rest.blocks, blocks: [...rest.blocks.blocks, block]}})
  /// Without the block that is in the place now, so that what the place wants can be seen.
  const emptied = (all: Lifted, place: Place) => {
    const inside =
      "below" in place ? undefined : find(all.rest, place.block)?.inputs?.[place.input]?.block?.id
    return inside === undefined ? all.base : solveWith(without(all.rest, inside), all.block)
  }
  const lifted = new Map<string, Lifted | undefined>()
  const fresh = new WeakMap<SavedBlock, Lifted>()
  const lift = (block: SavedBlock | BlockId) => {
    if (typeof block !== "string") {
      const known = fresh.get(block)
      if (known !== undefined) return known
      const rest =
        block.id !== undefined && find(workspace, block.id) !== undefined
          ? without(workspace, block.id)
          : workspace
      const made = {rest, block, base: solveWith(rest, block)}
      fresh.set(block, made)
      return made
    }
    if (!lifted.has(block)) {
      const found = find(workspace, block)
      const rest = without(workspace, block)
      lifted.set(block, found === undefined ? undefined : {rest, block: found, base: solveWith(rest, found)})
    }
    return lifted.get(block)
  }
  const accepted = ({rest, block}: Lifted, place: Place): Verdict => {
    const {id} = block
    // The types of steps and patterns are not compared with those of a place.
    if (id === undefined || connectsOf(block)?.as !== "expression") return {fits: true}
    let doubt: {readonly sentence: string | undefined} | undefined
    return {
      fits: true,
      // Only a connection that is about to be made needs it.
      get doubt() {
        doubt ??= {sentence: doubtSentence(doubtAbout(session, plug(rest, place, block), id))}
        return doubt.sentence
      },
    }
  }
  return {
    fits(place, block) {
      const all = lift(block)
      if (all === undefined) return {fits: false, why: words.fits.thisBlockIsGone}
      const at = "below" in place ? place.below : place.block
      const target = find(all.rest, at)
      // The place is on the dragged block itself, or nowhere.
      if (target === undefined) return {fits: false, why: words.fits.aBlockCannotGoInsideItself}
      const sort = rightSort(place, target, all.block)
      if (sort !== undefined) return {fits: false, why: sort}
      const after = inferWorkspace(plug(all.rest, place, all.block))
      const before = count(all.base)
      if (count(after) <= before) return accepted(all, place)
      let sentence: string | undefined
      return {
        fits: false,
        // Only the refusal that is shown needs its words.
        get why() {
          sentence ??= why(all.rest, emptied(all, place), after, place, all.block)
          return sentence
        },
      }
    },
  }
}

function doubtSentence(doubt: Doubt | undefined): string | undefined {
  if (doubt === undefined) return undefined
  if (doubt.kind === "type")
    return doubt.name === undefined ? words.fits.onlyGhcKnowsTheTypes : words.fits.onlyGhcKnows(doubt.name)
  const {name, type} = doubt.constraint
  return words.fits.onlyGhcKnowsTheClass(showType(type), name)
}

function count(solved: InferredWorkspace): number {
  return solved.inference.problems.filter(isRefusal).length
}

function connectsOf(block: SavedBlock): Connects | undefined {
  return blockView(block.type)?.shape(block.extraState ?? {}).connects
}

function rightSort(place: Place, target: SavedBlock, block: SavedBlock): string | undefined {
  const is = connectsOf(block)?.as
  const wanted = "below" in place ? connectsOf(target)?.as : itemAt(target, place.input)?.sort
  if (is === undefined) return words.fits.rosyDoesNotKnowThisKind
  if (wanted === is) return undefined
  if (wanted === undefined || wanted === "top") return words.fits.nothingCanBeJoined
  return words.fits.hereGoes(words.fits.places[wanted], words.fits.makes[is])
}

/// The socket or stack of a block that has a name.
export function itemAt(target: SavedBlock, input: string): (Item & {kind: "socket" | "stack"}) | undefined {
  for (const row of blockView(target.type)?.shape(target.extraState ?? {}).rows ?? [])
    for (const item of row)
      if ((item.kind === "socket" || item.kind === "stack") && item.name === input) return item
  return undefined
}
