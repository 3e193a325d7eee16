/// Explanations of a run as the service gives them (`protocol/README.md` §4.2), and their decoder.

import {type Decoder, list, number, object, oneOf, optional, string} from "../state/decode.ts"
import {type Firing, firing} from "../state/firings.ts"
import type {why} from "../words/en/why.ts"

export type SentenceId = keyof (typeof why)["sentences"]

/// A sentence as a value. What it does not use is `null` or empty; times are seconds of the run.
export interface Said {
  readonly id: SentenceId
  readonly time: number | null
  readonly since: number | null
  readonly until: number | null
  readonly function: string
  /// The function that led to it, and the number of its firing.
  readonly other: string
  readonly cause: number | null
  readonly functions: readonly string[]
  /// Values as Haskell shows them, types as it writes them.
  readonly value: string
  readonly values: readonly string[]
  /// Of an equation or an alternative, from 1.
  readonly number: number | null
  readonly gave: readonly {readonly to: string; readonly value: string; readonly type: string}[]
  readonly type: string
  readonly types: readonly string[]
  /// m/s or rad/s.
  readonly asked: number | null
  readonly limit: number | null
}

export interface Sentence {
  readonly said: Said
  /// Seconds of the run that it is about.
  readonly time: number
  /// The firing that it is about.
  readonly firing: number | null
}

export interface Explanation {
  /// The number of the question.
  readonly id: number
  /// Of what was asked about, in seconds of the run.
  readonly time: number
  readonly sentences: readonly Sentence[]
  /// The firings that led to it, in the order of time.
  readonly path: readonly Firing[]
}

const sentenceIds = [
  "sent",
  "stopped",
  "stopped-by",
  "sensed",
  "nothing-ran",
  "first-value",
  "old-value",
  "not-written",
  "remembered",
  "had-come",
  "ran-message",
  "ran-tick",
  "ran-start",
  "ran-wait",
  "ran-end",
  "ran-unknown",
  "ran-event",
  "ran-done",
  "ran-call",
  "ran-feedback",
  "ran-task",
  "nothing-sent",
  "none-came",
  "nothing-sent-yet",
  "not-recorded",
  "not-known-before",
  "run-over",
  "run-not-begun",
  "did-run",
  "did-send",
  "did-take",
  "not-reached",
  "not-part",
  "task-ended",
  "task-waits",
  "runs-once",
  "lacks",
  "ticks",
  "ran-before",
  "never-ran",
  "gave",
  "matched-equation",
  "matched-case",
  "guard-held",
  "was-true",
  "was-false",
  "other-type",
  "in-force",
  "replaced",
  "replaced-by-stop",
  "replaced-by-end",
  "beyond-speed",
  "beyond-turn",
  "overridden",
  "in-the-air",
  "in-the-way",
  "followed",
  "followed-changes",
  "stood",
  "followed-others",
  "placed",
  "not-moved",
  "no-sender",
  "never-sent",
  "no-taker",
  "received",
  "taker-ended",
  "taker-silent",
] as const satisfies readonly SentenceId[]

export const said: Decoder<Said> = object<Said>(get => ({
  id: get("id", oneOf(...sentenceIds)),
  time: get("time", optional(number, null)),
  since: get("since", optional(number, null)),
  until: get("until", optional(number, null)),
  function: get("function", optional(string, "")),
  other: get("other", optional(string, "")),
  cause: get("cause", optional(number, null)),
  functions: get("functions", optional(list(string), [])),
  value: get("value", optional(string, "")),
  values: get("values", optional(list(string), [])),
  number: get("number", optional(number, null)),
  gave: get(
    "gave",
    optional(
      list(
        object(at => ({
          to: at("to", string),
          value: at("value", optional(string, "")),
          type: at("type", optional(string, "")),
        })),
      ),
      [],
    ),
  ),
  type: get("type", optional(string, "")),
  types: get("types", optional(list(string), [])),
  asked: get("asked", optional(number, null)),
  limit: get("limit", optional(number, null)),
}))

export const explanation: Decoder<Explanation> = object<Explanation>(get => ({
  id: get("id", number),
  time: get("time", number),
  sentences: get(
    "sentences",
    list(
      object<Sentence>(at => ({
        said: at("said", said),
        time: at("time", number),
        firing: at("firing", optional(number, null)),
      })),
    ),
  ),
  path: get("path", list(firing)),
}))
