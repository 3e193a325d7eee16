/// May this block go there? Real inference decides; if the answer is no, a sentence says why.

import type {Checker, Verdict} from "../api.ts"
import {blockView} from "../blocks/language.ts"
import type {BlockId, Place, SavedBlock, SavedWorkspace} from "../saved.ts"
import type {Connects, Item} from "../shape.ts"
import type {TypeProblem} from "../types/problems.ts"
import type {Type} from "../types/type.ts"
import {prune, showType} from "../types/type.ts"
import {ability, capital, describe} from "../types/words.ts"
import {words} from "../words/index.ts"
import type {Solved} from "./infer.ts"
import {whatIs} from "./infer.ts"
import {find, plug, without} from "./plug.ts"
import {Session} from "./session.ts"

export function fits(workspace: SavedWorkspace, place: Place, block: SavedBlock | BlockId): Verdict {
  return checker(workspace).fits(place, block)
}

/// A block taken out of the workspace, and what is known about both.
interface Lifted {
  readonly rest: SavedWorkspace
  readonly block: SavedBlock
  readonly base: Solved
}

/// Keeps what it worked out about the workspace, so that a drag asks many times and pays once.
export function checker(workspace: SavedWorkspace, session = new Session()): Checker {
  const solve = (w: SavedWorkspace) => session.solve(w)
  const solveWith = (rest: SavedWorkspace, block: SavedBlock) =>
    solve({...rest, blocks: {...rest.blocks, blocks: [...rest.blocks.blocks, block]}})
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
      const after = solve(plug(all.rest, place, all.block))
      const before = count(all.base)
      if (count(after) <= before) return {fits: true}
      let sentence: string | undefined
      return {
        fits: false,
        // Only the refusal that is shown needs its words.
        get why() {
          sentence ??= why(emptied(all, place), after, place, all.block)
          return sentence
        },
      }
    },
  }
}

/// What nothing decides yet may be decided later, so it is no reason to refuse a block.
function refusing(problem: TypeProblem): boolean {
  return problem.kind !== "ambiguous"
}

function count(solved: Solved): number {
  return solved.inferrer.problems.filter(refusing).length
}

function connectsOf(block: SavedBlock): Connects | undefined {
  return blockView(block.type)?.shape(block.extraState ?? {}).connects
}

function rightSort(place: Place, target: SavedBlock, block: SavedBlock): string | undefined {
  const is = connectsOf(block)?.as
  const wanted = "below" in place ? connectsOf(target)?.as : itemAt(target, place.input)?.sort
  if (is === undefined) return words.fits.rosyDoesNotKnowThisKind
  if (wanted === is) return undefined
  switch (wanted) {
    case "pattern":
      return words.fits.hereGoesANameOrAPattern
    case "expression":
      return is === "pattern" ? words.fits.hereGoesAValueAndThisBlock : words.fits.hereGoesAValueAndThisBlock2
    case "step":
      return words.fits.hereGoesAStepOfATask
    case "definition":
      return words.fits.hereGoesADefinition
    default:
      return words.fits.nothingCanBeJoined
  }
}

/// The socket or stack of a block that has a name.
export function itemAt(target: SavedBlock, input: string): (Item & {kind: "socket" | "stack"}) | undefined {
  for (const row of blockView(target.type)?.shape(target.extraState ?? {}).rows ?? [])
    for (const item of row)
      if ((item.kind === "socket" || item.kind === "stack") && item.name === input) return item
  return undefined
}

function why(base: Solved, after: Solved, place: Place, block: SavedBlock): string {
  const key = (p: TypeProblem) => `${p.kind} ${"from" in p.node ? p.node.from?.block : ""} ${whatIs(p.node)}`
  const known = new Set(base.inferrer.problems.map(key))
  const news = after.inferrer.problems.filter(refusing)
  const first = news.find(p => !known.has(key(p))) ?? news[0]
  const name = blockWord(block)
  if (first === undefined) return words.fits.doesNotGo(name)
  if (first.kind === "unknown-name") return words.fits.isKnownOnlyInsideTheFunction(first.name)
  const wanted = typeAt(base, place)
  const found = typeOf(base, block)
  if (wanted !== undefined && found !== undefined && isKnown(wanted) && isKnown(found)) {
    const [w, f] = [describe(wanted), describe(found)]
    if (w !== f) return words.fits.thisSocketWants(w, name, f)
    if (showType(wanted) !== showType(found))
      return words.fits.thisSocketWants2(showType(wanted), name, showType(found))
  }
  switch (first.kind) {
    case "mismatch":
      return words.fits.thenThereWouldBeWhereMustBe(describe(first.found), describe(first.wanted))
    case "no-instance":
      return found !== undefined && isKnown(found) && prune(first.constraint.type) === prune(found)
        ? words.fits.whatGoesHereMust(ability(first.constraint), name, describe(found))
        : words.fits.cannot(capital(describe(first.constraint.type)), ability(first.constraint))
    case "too-many-arguments":
      return words.fits.thenSomethingWouldGetMoreInputsThan
    case "wrong-field-count":
      return words.fits.hasPartsNot(first.name, first.wanted, first.found)
    case "too-general":
      return words.fits.theTypeOfThisDefinitionPromisesMore
    default:
      return words.fits.doesNotGo(name)
  }
}

function isKnown(type: Type): boolean {
  return prune(type).kind !== "meta"
}

/// The type that an empty or filled place wants, from the workspace without the dragged block.
function typeAt(solved: Solved, place: Place): Type | undefined {
  if ("below" in place) return undefined
  for (const [node, type] of solved.inferrer.types)
    if (node.kind !== "program" && node.from?.block === place.block && node.from.input === place.input)
      return type
  return undefined
}

function typeOf(solved: Solved, block: SavedBlock): Type | undefined {
  for (const [node, type] of solved.inferrer.types)
    if (node.kind !== "program" && node.from?.block === (block.id ?? "") && node.from.input === undefined)
      return type
  return undefined
}

/// What to call the dragged block.
function blockWord(block: SavedBlock): string {
  const extra = block.extraState ?? {}
  const word = extra.con ?? extra.name ?? extra.value ?? extra.op
  return typeof word === "string" && word !== "" ? `\`${word}\`` : words.fits.thisBlock
}
