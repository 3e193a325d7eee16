/// What keeps inference from promising that GHC accepts a connection.
///
/// In: a workspace with a block in its new place. Out: undefined for a promise, or the cause of the doubt. It does not say that a connection is
/// wrong: that is the drop checker's part.

import {readWorkspace} from "../../blocks/block_reader.ts"
import {everyNode} from "../../model/child_nodes.ts"
import type {Node} from "../../model/syntax_tree.ts"
import type {BlockId, SavedWorkspace} from "../../serialized_blocks.ts"
import type {Clash} from "../../types/environment/unification.ts"
import {unreadNameIn} from "../../types/environment/unification.ts"
import type {Constraint} from "../../types/syntax/type.ts"
import {namesIn, openEndsIn, showType} from "../../types/syntax/type.ts"
import type {InferenceSession} from "./inference_session.ts"
import {everyBlock, everyBlockIn, inferModel} from "./workspace_inference.ts"

export type Doubt =
  /// The block or its place has a type that only GHC knows: of a name of a module that is not read, or of text beyond the blocks.
  | {readonly kind: "type"; readonly name: string | undefined}
  /// Only GHC can confirm that a type belongs to a class.
  | {readonly kind: "class"; readonly constraint: Constraint}

export function doubtAbout(
  session: InferenceSession,
  connected: SavedWorkspace,
  block: BlockId,
): Doubt | undefined {
  const {inference} = session.inferWorkspace(connected, {apart: block})
  const types = inference.typesApart
  // A definition is left to GHC as a whole, or part of what is known of its types.
  if (types === undefined || types.isBeyondInference) return {kind: "type", name: undefined}
  const ends = openEndsIn(types.own, openEndsIn(types.wanted))
  // The type of a definition without a signature may follow from the block, and be used where only GHC knows what is wanted.
  const isSpreading = !types.isSigned && openEndsIn(types.wanted).size > 0
  // What is remembered of other definitions does not say what is unknown in them.
  const {settledHoles, holes, sockets, foreignNames} = isSpreading
    ? inferModel(readWorkspace(connected), {apart: block}).inference
    : inference
  const unknown = [...settledHoles, ...holes].filter(hole => !sockets.has(hole))
  const foreign = isSpreading
    ? unknown
    : unknown.filter(hole => [...openEndsIn(hole)].some(end => ends.has(end)))
  const named = foreign.find(hole => foreignNames.has(hole)) ?? foreign[0]
  if (named !== undefined) return {kind: "type", name: foreignNames.get(named)}
  for (const name of namesIn(types.own, namesIn(types.wanted)))
    if (hasSeveralSpellings(name, connected)) return {kind: "type", name}
  const local = localNameElsewhere(connected, block, inference.undefinedNames)
  if (local !== undefined) return {kind: "type", name: local}
  const {unreadClashes, env} = session.inferWorkspace(connected, {watch: {block}}).inference
  const written = ({left, right}: Clash) => `${showType(left)} ~ ${showType(right)}`
  const clashesBefore = new Set(inference.unreadClashes.map(written))
  const clash = unreadClashes.find(c => !clashesBefore.has(written(c)))
  if (clash !== undefined) return {kind: "type", name: unreadNameIn(clash.left) ?? unreadNameIn(clash.right)}
  const shown = ({name, type}: Constraint) => `${name} ${showType(type)}`
  const before = new Set(inference.env.assumed.map(shown))
  const constraint = env.assumed.find(c => !before.has(shown(c)))
  return constraint === undefined ? undefined : {kind: "class", constraint}
}

/// A name in the block that a definition elsewhere binds for itself, and a module that is not read may have as well.
function localNameElsewhere(
  connected: SavedWorkspace,
  block: BlockId,
  undefinedNames: ReadonlyMap<Node, string>,
): string | undefined {
  if (undefinedNames.size === 0) return undefined
  const moved = [...everyBlock(connected)].find(b => b.id === block)
  const ids = new Set(moved === undefined ? [] : [...everyBlockIn(moved)].map(b => b.id))
  const own = [...undefinedNames].filter(([node]) => "from" in node && ids.has(node.from?.block))
  if (own.length === 0) return undefined
  const bound = new Set(
    readWorkspace(connected).program.declarations.flatMap(d =>
      [...everyNode(d)].flatMap(node =>
        node.kind === "name-pattern" || node.kind === "function" ? node.name : [],
      ),
    ),
  )
  return own.map(([, name]) => name).find(name => bound.has(name))
}

/// Whether a program writes a type both as `T.Text` and as `L.Text`, or as `Text`: these may be two types, or one.
function hasSeveralSpellings(name: string, {blocks}: SavedWorkspace): boolean {
  if (!/^\p{Lu}/u.test(name)) return false
  const qualified = new RegExp(
    `(?<![\\p{L}\\p{N}_'.])((?:\\p{Lu}[\\p{L}\\p{N}_']*\\.)*)${name}(?![\\p{L}\\p{N}_'.])`,
    "gu",
  )
  return new Set([...JSON.stringify(blocks).matchAll(qualified)].map(m => m[1])).size > 1
}
