/// Cuts: one input or one output of a function less, in its type and in all of its equations. What equations depend on is not cut off.

import type {SavedBlock, SavedInput} from "../serialized_blocks.ts"
import {showType, spine} from "../types/syntax/type.ts"
import {parseType} from "../types/syntax/type_parser.ts"
import {
  arityOf,
  equationsOf,
  patternAt,
  patternsOf,
  withAnswers,
  withEquations,
  withPatterns,
  withSignature,
} from "./definition_edits.ts"
import {refuse} from "./refused.ts"
import {
  type Range,
  type SignatureParts,
  type TupleParts,
  textOf,
  tupleParts,
  withoutArgument,
  withoutTuplePart,
  withReplaced,
} from "./signature_text.ts"

/// A function whose type is known.
export interface TypedDefinition {
  readonly name: string
  readonly block: SavedBlock
  readonly signature: string
  readonly parts: SignatureParts
}

/// A type without synonyms, and the types that a type is made of.
export interface TypeMeanings {
  expanded(type: string): string
  leaves(type: string): readonly string[]
}

/// Without an argument, or without one side of an `Either` and the cases for it.
export function withoutInput(
  {name, block, signature, parts}: TypedDefinition,
  type: string,
  {expanded}: TypeMeanings,
): SavedBlock {
  const wanted = expanded(type)
  const at = parts.arguments.findIndex(range => expanded(textOf(signature, range)) === wanted)
  if (at >= 0) {
    if (arityOf(block) <= at) refuse({kind: "type-unknown", function: name})
    const patterns = equationsOf(block).map((_, i) => patternAt(block, i, at))
    if (patterns.length > 1 && !patterns.every(takesAll)) refuse({kind: "tells-apart", function: name, type})
    const changed = withPatterns(block, i => patternsOf(block, i).filter((_, j) => j !== at))
    return withSignature(changed, withoutArgument(signature, parts, at))
  }
  for (const [j, range] of parts.arguments.entries()) {
    const sides = sidesOf(textOf(signature, range))
    const cut = sides?.findIndex(one => expanded(one) === wanted) ?? -1
    if (sides === undefined || cut < 0) continue
    const [gone, kept] = cut === 0 ? ["Left", "Right"] : ["Right", "Left"]
    const conOf = (i: number) => {
      const pattern = patternAt(block, i, j)
      return pattern?.type === "pattern_construct" ? pattern.extraState?.con : undefined
    }
    const equations = equationsOf(block).map((_, i) => i)
    if (
      !equations.every(i => conOf(i) === gone || conOf(i) === kept) ||
      !equations.some(i => conOf(i) === kept)
    )
      refuse({kind: "tells-apart", function: name, type})
    const remaining = withEquations(block, i => conOf(i) === kept)
    const changed = withPatterns(remaining, i =>
      patternsOf(remaining, i).map((pattern, k) => (k === j ? pattern?.inputs?.A0?.block : pattern)),
    )
    return withSignature(changed, withReplaced(signature, range, sides[1 - cut] ?? ""))
  }
  return refuse({kind: "does-not-take", function: name, type})
}

/// Without one part of the tuple that it answers, also in a `Maybe`; undefined where it sends nothing else.
export function withoutOutput(
  {name, block, signature, parts}: TypedDefinition,
  type: string,
  {expanded, leaves}: TypeMeanings,
): SavedBlock | undefined {
  const wanted = expanded(type)
  const sent = leaves(textOf(signature, parts.result))
  if (!sent.includes(wanted)) refuse({kind: "does-not-send", function: name, type})
  if (sent.every(leaf => leaf === wanted)) return undefined
  const computed = () => refuse({kind: "computes-together", function: name, type})
  const tuple = tupleIn(signature, parts.result) ?? computed()
  const at = tuple.of.findIndex(range => leaves(textOf(signature, range)).every(leaf => leaf === wanted))
  if (at < 0 || arityOf(block) < parts.arguments.length) computed()
  const cut = (answer: SavedBlock | undefined): SavedBlock | undefined => {
    if (answer === undefined) return undefined
    const {type: kind, extraState = {}, inputs = {}} = answer
    if (kind === "tuple" && extraState.items === tuple.of.length)
      return withoutItem(answer, at, tuple.of.length)
    const inside = answerSockets(answer) ?? computed()
    const changed: {[name: string]: SavedInput} = {...inputs}
    for (const socket of inside) {
      const now = cut(inputs[socket]?.block)
      if (now === undefined) delete changed[socket]
      else changed[socket] = {block: now}
    }
    return {...answer, inputs: changed}
  }
  const isArgument = tuple.whole.start > parts.result.start
  return withSignature(withAnswers(block, cut), withoutTuplePart(signature, tuple, at, isArgument))
}

/// The parts of the tuple that a result is, or that it is perhaps.
function tupleIn(signature: string, result: Range): TupleParts | undefined {
  const maybe = /^Maybe\s+/.exec(textOf(signature, result))?.[0] ?? ""
  return tupleParts(signature, {start: result.start + maybe.length, end: result.end})
}

function withoutItem(tuple: SavedBlock, at: number, items: number): SavedBlock | undefined {
  const kept = Array.from({length: items}, (_, i) => tuple.inputs?.[`I${i}`]?.block).filter(
    (_, i) => i !== at,
  )
  if (kept.length === 1) return kept[0]
  const inputs = kept.flatMap((block, i) => (block === undefined ? [] : [[`I${i}`, {block}] as const]))
  return {...tuple, extraState: {...tuple.extraState, items: kept.length}, inputs: Object.fromEntries(inputs)}
}

/// The sockets of the answers that an expression chooses between; undefined where it computes its answer.
function answerSockets({type, extraState = {}, inputs = {}}: SavedBlock): readonly string[] | undefined {
  switch (type) {
    case "if":
      return ["T", "F"]
    case "branches":
    case "case":
      return Object.keys(inputs).filter(socket => /^(?:E\d+_\d+|O\d+)$/.test(socket))
    case "let":
      return ["B"]
    case "construct":
      return extraState.con === "Just" ? ["A0"] : extraState.con === "Nothing" ? [] : undefined
    default:
      return type === "name" && extraState.name === "Nothing" ? [] : undefined
  }
}

/// Whether a pattern takes every value, so that it tells none apart.
function takesAll(pattern: SavedBlock | undefined): boolean {
  return pattern === undefined || pattern.type === "pattern_name" || pattern.type === "pattern_any"
}

/// The sides of a type `Either a b`, as they are written.
function sidesOf(type: string): readonly [string, string] | undefined {
  const bare = /^\((.*)\)$/s.exec(type)?.[1] ?? type
  const parsed = parseType(bare)
  if (parsed === undefined) return undefined
  const {head, args} = spine(parsed)
  const [left, right] = args
  return head.kind === "con" && head.name === "Either" && left !== undefined && right !== undefined
    ? [showType(left), showType(right)]
    : undefined
}
