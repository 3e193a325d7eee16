/// Answers of a batch of headless runs (a test in many rooms, a rehearsal of a lesson): the part that all batches share (protocol §4.1, §9.1).

import {worded} from "../words/worker_sentences.ts"
import {
  type Decoded,
  type Decoder,
  decode,
  number,
  object,
  oneOf,
  optional,
  parseJson,
  string,
} from "./decode.ts"
import {problemSentences, sentence, untranslated} from "./sentence.ts"

/// Before the first run, and instead of further ones. `place` in the queue: 1 for the next.
export type CommonAnswer =
  | {readonly op: "queued"; readonly place: number}
  | {readonly op: "failed"; readonly message: string}

/// What is wrong with a program of the batch, in the language of the page.
export const batchProblem = object(get =>
  worded(get("sentences", optional(problemSentences, untranslated)).message, get("message", string)),
)

const common: {readonly [Op in CommonAnswer["op"]]: Decoder<CommonAnswer & {op: Op}>} = {
  queued: object(get => ({op: "queued", place: get("place", number)}) as const),
  failed: object(
    get =>
      ({
        op: "failed",
        message: worded(get("sentence", optional(sentence, null)), get("message", string)),
      }) as const,
  ),
}

/// Decoder of a message of the service, from the decoders of a batch's own answers by their `op`.
export function batchAnswer<Own extends {readonly op: string}>(
  own: {
    readonly [Op in Own["op"]]: Decoder<Own & {op: Op}>
  },
): (text: string) => Decoded<CommonAnswer | Own> {
  const decoders: Readonly<Record<string, Decoder<CommonAnswer | Own>>> = {...common, ...own}
  const answer: Decoder<CommonAnswer | Own> = (value, path) => {
    const op = object(get => get("op", oneOf(...Object.keys(decoders))))(value, path)
    return (decoders[op] as Decoder<CommonAnswer | Own>)(value, path)
  }
  return text => decode(answer, parseJson(text))
}
