/// References: what a definition leaves behind when it is dropped on a socket.

import type {Reference} from "../../api.ts"
import type {Sort, StackSort} from "../../block_shape.ts"
import {blockView} from "../../blocks/block_registry.ts"
import type {BlockId, Extra, Place, SavedBlock, SavedWorkspace} from "../../serialized_blocks.ts"
import type {Scheme} from "../../types/syntax/type.ts"
import {asFunction} from "../../types/syntax/type.ts"
import {words} from "../../words/index.ts"
import {InferenceSession} from "../inference/inference_session.ts"
import {find, without} from "./block_moves.ts"
import {checker, itemAt} from "./drop_checker.ts"

/// The reference to a definition that fits a socket: the bare name in `simulate` and wherever else a function is wanted,
/// and a call with open inputs where its answer is. An own type is referred to by its first constructor that fits. The definition itself
/// stays where it is.
export function referenceTo(
  workspace: SavedWorkspace,
  place: Place,
  definition: SavedBlock | BlockId,
  session = new InferenceSession(),
): Reference {
  const isNew = typeof definition !== "string"
  const block = isNew ? definition : find(workspace, definition)
  if (block === undefined) return {fits: false, why: words.fits.thisBlockIsGone}
  const all = isNew
    ? {...workspace, blocks: {...workspace.blocks, blocks: [...workspace.blocks.blocks, block]}}
    : workspace
  const check = checker(all, session)
  const name = block.extraState?.name
  const isFunction = block.type === "define" && typeof name === "string" && name !== ""
  const target = "below" in place ? undefined : find(all, place.block)
  const sort = target === undefined || "below" in place ? undefined : itemAt(target, place.input)?.sort
  if (sort === "expression" && blockView(block.type)?.meaning.as === "step") {
    const remaining = isNew ? workspace : without(workspace, definition)
    const verdict = checker(remaining, session).fits(place, asTask(block) ?? block)
    return verdict.fits ? {fits: true, block: {type: "do"}, holds: "S"} : verdict
  }
  const made =
    target?.type === "main"
      ? undefined
      : constructorBlocks(block, sort).find(one => check.fits(place, one).fits)
  if (made !== undefined) return {fits: true, block: made}
  // Other types, and Haskell that is kept as text, have no name that stands for them here.
  if (!isFunction || sort !== "expression") {
    const verdict = checker(workspace, session).fits(place, definition)
    return {fits: false, why: verdict.fits ? words.fits.nothingCanBeJoined : verdict.why}
  }
  const bare = template(name, 0)
  const first = check.fits(place, bare)
  if (first.fits) return {fits: true, block: bare}
  const scheme = session.inferWorkspace(all).globals.get(name)
  const call = template(name, scheme === undefined ? 0 : arityOf(scheme))
  return target?.type !== "main" && check.fits(place, call).fits
    ? {fits: true, block: call}
    : {fits: false, why: first.why}
}

/// The constructors that a block defines, as blocks for a socket of this sort.
function constructorBlocks(definition: SavedBlock, sort: Sort | StackSort | undefined): SavedBlock[] {
  const {constructors} = definition.extraState ?? {}
  if (definition.type !== "data" || !Array.isArray(constructors)) return []
  const type = sort === "expression" ? "construct" : sort === "pattern" ? "pattern_construct" : undefined
  if (type === undefined) return []
  return constructors.flatMap(one => {
    const {name: con, fields} = one as Extra
    return typeof con === "string"
      ? {type, extraState: {con, args: Array.isArray(fields) ? fields.length : 0}}
      : []
  })
}

/// A step as a task, for a socket; undefined for blocks that are no steps.
export function asTask(block: SavedBlock): SavedBlock | undefined {
  return blockView(block.type)?.meaning.as === "step" ? {type: "do", inputs: {S: {block}}} : undefined
}

export function template(name: string, args: number): SavedBlock {
  return {type: "name", extraState: {name, args, ...(args > 0 ? {fn: true} : {})}}
}

export function arityOf(scheme: Scheme): number {
  let count = 0
  for (let f = asFunction(scheme.type); f !== undefined; f = asFunction(f.to)) count++
  return Math.min(count, 9)
}
