/// One more output of a function: each answer becomes a tuple, or its tuple one longer. What sends nothing at times sends nothing more then.

import type {SavedBlock} from "../serialized_blocks.ts"
import {spine} from "../types/syntax/type.ts"
import {parseType} from "../types/syntax/type_parser.ts"
import {make} from "../workspace/toolbox/block_builders.ts"
import type {TypedDefinition} from "./cuts.ts"
import {mostArguments, withAnswers, withSignature} from "./definition_edits.ts"
import {type Range, textOf, withResultPart} from "./signature_text.ts"

type Answer = SavedBlock | undefined

/// `value` is what each answer sends; undefined leaves a place for it.
export function withOutput(
  {block, signature, parts}: Pick<TypedDefinition, "block" | "signature" | "parts">,
  type: string,
  value: Answer,
): SavedBlock {
  const answers: Answer[] = []
  withAnswers(block, answer => {
    answers.push(answer)
    return answer ?? make("tuple")
  })
  const optional = optionalResult(signature, parts.result, answers)
  const result = optional ?? parts.result
  const sent = optional === undefined ? answers : answers.flatMap(answer => sentBy(answer) ?? [])
  const count = tupleSize(textOf(signature, result))
  const flat =
    count > 1 &&
    count < mostArguments &&
    textOf(signature, result).startsWith("(") &&
    sent.every(answer => answer?.type === "tuple" && answer.extraState?.items === count)
  const withValue = (answer: Answer): SavedBlock => {
    const last = value === undefined ? {} : {block: structuredClone(value)}
    return flat && answer !== undefined
      ? {
          ...answer,
          extraState: {...answer.extraState, items: count + 1},
          inputs: {...answer.inputs, [`I${count}`]: last},
        }
      : {
          type: "tuple",
          extraState: {items: 2},
          inputs: {...(answer === undefined ? {} : {I0: {block: answer}}), I1: last},
        }
  }
  const changed = withAnswers(block, answer => {
    if (optional === undefined || answer === undefined) return withValue(answer)
    const inside = sentBy(answer)
    return inside === undefined
      ? answer
      : {...answer, inputs: {...answer.inputs, A0: {block: withValue(inside)}}}
  })
  return withSignature(changed, withResultPart(signature, {result}, type, flat))
}

/// What an answer sends where it is a `Just`.
const sentBy = (answer: Answer): Answer =>
  answer?.extraState?.con === "Just" ? answer.inputs?.A0?.block : undefined

/// Where the type stands that a function sends at times, if each of its answers is a `Just` with a value, or `Nothing`.
function optionalResult(signature: string, result: Range, answers: readonly Answer[]): Range | undefined {
  const [start] = /^Maybe\s+/.exec(textOf(signature, result)) ?? []
  const isOptional = answers.every(
    answer =>
      answer?.type === "construct" && (answer.extraState?.con === "Nothing" || sentBy(answer) !== undefined),
  )
  return start === undefined || !isOptional
    ? undefined
    : {start: result.start + start.length, end: result.end}
}

function tupleSize(text: string): number {
  const type = parseType(text)
  if (type === undefined) return 0
  const {head, args} = spine(type)
  return head.kind === "con" && /^\(,+\)$/.test(head.name) ? args.length : 0
}
