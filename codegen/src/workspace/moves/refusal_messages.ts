/// Messages that say why a block may not go to a place.

import {blockView} from "../../blocks/block_registry.ts"
import type {Place, SavedBlock, SavedWorkspace} from "../../serialized_blocks.ts"
import {sameType} from "../../types/environment/unification.ts"
import {allTypes} from "../../types/inference.ts"
import type {Type} from "../../types/syntax/type.ts"
import {prune, showType, spine} from "../../types/syntax/type.ts"
import type {TypeProblem} from "../../types/syntax/type_problems.ts"
import {words} from "../../words/index.ts"
import {
  abilityText,
  capital,
  describe,
  describeBoth,
  describeFor,
  foreignMethodMessage,
  isNumberAsCommand,
  misplacedDoneMessage,
} from "../inference/type_messages.ts"
import type {InferredWorkspace} from "../inference/workspace_inference.ts"
import {describeNode, everyBlockIn} from "../inference/workspace_inference.ts"
import {find} from "./block_moves.ts"

/// What nothing decides yet may be decided later, so it is no reason to refuse a block.
export function isRefusal(problem: TypeProblem): boolean {
  return problem.kind !== "ambiguous"
}

/// Constructors that make a value of a type from one of its parameters, in the order of these.
const wrappers: {readonly [type: string]: readonly string[]} = {
  Maybe: ["Just"],
  Either: ["Left", "Right"],
  Memory: ["Memory"],
  Param: ["Param"],
  Done: ["Done"],
}

const integers = ["Int", "Integer", "Word"]
/// Functions and constructors from one type to another.
const bridges: readonly {
  readonly from: readonly string[]
  readonly to: readonly string[]
  readonly by: string
}[] = [
  {from: integers, to: ["Double", "Float"], by: "fromIntegral"},
  {from: ["Double", "Float"], to: integers, by: "round"},
  {from: ["Double"], to: ["Seconds"], by: "doubleToSeconds"},
  {from: ["Seconds"], to: ["Double"], by: "secondsToDouble"},
  {from: ["LedColor"], to: ["Led1"], by: "Led1"},
  {from: ["LedColor"], to: ["Led2"], by: "Led2"},
]

/// `rest`: the workspace without the block; `base` is what was known of it, `after` what is known with the block in its place.
export function why(
  rest: SavedWorkspace,
  base: InferredWorkspace,
  after: InferredWorkspace,
  place: Place,
  block: SavedBlock,
): string {
  const key = (p: TypeProblem) =>
    `${p.kind} ${"from" in p.node ? p.node.from?.block : ""} ${describeNode(p.node)}`
  const known = new Set(base.inference.problems.map(key))
  const news = after.inference.problems.filter(isRefusal)
  const first = news.find(p => !known.has(key(p))) ?? news[0]
  const name = blockWord(block)
  if (first === undefined) return words.fits.doesNotGo(capital(name))
  if (first.kind === "unknown-name") return unknownName(rest, place, first.name)
  if (first.kind === "no-instance" && isNumberAsCommand(first.constraint))
    return words.fits.aNumberIsNoCommand
  const wanted = typeAt(base, place)
  const found = typeOf(base, block)
  if (wanted !== undefined && found !== undefined && isKnown(wanted) && isKnown(found)) {
    const bridge = bridgeTo(wanted, found)
    const way = bridge === undefined ? "" : ` ${words.fits.turnsItInto(bridge)}`
    const [w, f] = describeBoth(wanted, found)
    if (w !== f) return `${words.fits.thisSocketWants(w, name, f)}${way}`
    if (showType(wanted) !== showType(found))
      return `${words.fits.thisSocketWants(showType(wanted), name, showType(found))}${way}`
  }
  if (wanted !== undefined && found !== undefined && isKnown(found) && holdsValues(wanted))
    return words.fits.thisSocketWants(
      find(rest, "below" in place ? place.below : place.block)?.type.startsWith("step_") === true
        ? words.nouns.Task
        : words.types.somethingWithValues,
      name,
      describe(found),
    )
  switch (first.kind) {
    case "mismatch":
      return isKnown(first.found) && isKnown(first.wanted) && describe(first.found) !== describe(first.wanted)
        ? words.fits.thenThereWouldBeWhereMustBe(describe(first.found), describe(first.wanted))
        : words.fits.doesNotGo(capital(name))
    case "no-instance": {
      if (first.constraint.name === "Ends") return misplacedDoneMessage(first.constraint).message
      const what = describeFor(first.constraint)
      return found !== undefined && isKnown(found) && prune(first.constraint.type) === prune(found)
        ? words.fits.whatGoesHereMust(abilityText(first.constraint), name, what)
        : words.fits.cannot(capital(what), abilityText(first.constraint))
    }
    case "too-many-arguments":
      return words.fits.thenSomethingWouldGetMoreInputsThan
    case "wrong-field-count":
      return words.fits.hasPartsNot(first.name, first.wanted, first.found)
    case "no-method":
      return foreignMethodMessage(first)
    case "second-instance":
      return words.types.belongsTwice(first.name, first.of)
    case "too-general":
      return words.fits.theTypeOfThisDefinitionPromisesMore
    default:
      return words.fits.doesNotGo(capital(name))
  }
}

/// Where the name is known, if anywhere.
function unknownName(rest: SavedWorkspace, place: Place, name: string): string {
  const at = "below" in place ? place.below : place.block
  const binding = rest.blocks.blocks.filter(top => [...everyBlockIn(top)].some(b => binds(b, name)))
  if (binding.length === 0) return words.fits.nothingIsCalled(name)
  return binding.some(top => [...everyBlockIn(top)].some(b => b.id === at))
    ? words.fits.isKnownOnlyInAPart(name)
    : words.fits.isKnownOnlyInsideTheFunction(name)
}

function binds(block: SavedBlock, name: string): boolean {
  const rows = blockView(block.type)?.shape(block.extraState ?? {}).rows ?? []
  return rows.some(row => row.some(item => item.kind === "binder" && item.value === name))
}

/// What makes a value of one type from one of another, where there is one usual conversion.
function bridgeTo(wanted: Type, found: Type): string | undefined {
  const [to, from] = [spine(wanted), spine(found)]
  if (to.head.kind !== "con") return undefined
  const wrapper = wrappers[to.head.name]
  const inner = wrapper === undefined ? -1 : to.args.findIndex(a => isKnown(a) && sameType(a, found))
  if (inner >= 0) return wrapper?.[inner]
  if (from.head.kind !== "con") return undefined
  const [made, given] = [to.head.name, from.head.name]
  return bridges.find(b => b.from.includes(given) && b.to.includes(made))?.by
}

function isKnown(type: Type): boolean {
  return spine(type).head.kind === "con"
}

/// `m a`, a type that is open but for having another inside.
function holdsValues(type: Type): boolean {
  const {head, args} = spine(type)
  return head.kind !== "con" && args.length > 0
}

/// The type that an empty or filled place wants, from the workspace without the dragged block.
function typeAt(solved: InferredWorkspace, place: Place): Type | undefined {
  if ("below" in place) return undefined
  for (const [node, type] of allTypes(solved.inference))
    if (node.kind !== "program" && node.from?.block === place.block && node.from.input === place.input)
      return type
  return undefined
}

function typeOf(solved: InferredWorkspace, block: SavedBlock): Type | undefined {
  for (const [node, type] of allTypes(solved.inference))
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
