/// Firings of functions with their provenance, as frames carry them while the page observes a run (`protocol/README.md` §2, *Firings*).

import {type Decoder, list, number, object, oneOf, optional, string} from "./decode.ts"

/// Why a function fired then. A number is `null` where the message has none.
export interface FiringCause {
  /// `instant`: a wait was over; `task`: what another firing gave led to it; `start` and `end` of the program.
  readonly by: "message" | "tick" | "event" | "start" | "instant" | "task" | "end"
  /// Of a message, as Haskell shows it.
  readonly value: string
  readonly instant: number | null
  readonly event: number | null
  /// The firing that sent the event, or that led to it.
  readonly firing: number | null
}

/// A value that a function took, as Haskell shows it.
export interface FiringInput {
  readonly from: "event" | "state" | "memory" | "param" | "time" | "generator"
  readonly value: string
  /// Of a memory: `Memory Int`.
  readonly type: string
  /// The firing that wrote the memory; `null` before the first write.
  readonly firing: number | null
}

/// A value that a function gave, as Haskell shows it.
export interface FiringOutput {
  readonly to: "command" | "event" | "memory" | "param" | "done" | "feedback" | "call"
  readonly value: string
  /// Of a command, a memory (`Memory Int`) or a user event.
  readonly type: string
}

/// 1-based, counted in characters.
export interface TextPlace {
  readonly line: number
  readonly column: number
}

/// A branch that a function took: one of the equations, guards or alternatives between which it chooses.
export interface FiringBranch {
  /// Names of the definitions around it, outermost first.
  readonly in: readonly string[]
  readonly kind: "equation" | "case" | "guard" | "then" | "else"
  readonly number: number
  /// Left side, pattern, guard or condition.
  readonly text: string
  readonly start: TextPlace
  readonly end: TextPlace
}

export interface Firing {
  /// Its number among the firings of the run, from the first observed step.
  readonly n: number
  /// Seconds of the run.
  readonly time: number
  readonly function: string
  /// The number of its task; 0 is the first of the program.
  readonly task: number
  readonly cause: FiringCause
  readonly took: readonly FiringInput[]
  readonly gave: readonly FiringOutput[]
  /// In the order in which they were taken.
  readonly branches: readonly FiringBranch[]
}

const cause = object<FiringCause>(get => ({
  by: get("by", oneOf("message", "tick", "event", "start", "instant", "task", "end")),
  value: get("value", optional(string, "")),
  instant: get("instant", optional(number, null)),
  event: get("event", optional(number, null)),
  firing: get("firing", optional(number, null)),
}))

const input = object<FiringInput>(get => ({
  from: get("from", oneOf("event", "state", "memory", "param", "time", "generator")),
  value: get("value", string),
  type: get("type", optional(string, "")),
  firing: get("firing", optional(number, null)),
}))

const output = object<FiringOutput>(get => ({
  to: get("to", oneOf("command", "event", "memory", "param", "done", "feedback", "call")),
  value: get("value", optional(string, "")),
  type: get("type", optional(string, "")),
}))

const position = object<TextPlace>(get => ({line: get("line", number), column: get("column", number)}))

export const branch: Decoder<FiringBranch> = object<FiringBranch>(get => ({
  in: get("in", list(string)),
  kind: get("kind", oneOf("equation", "case", "guard", "then", "else")),
  number: get("number", number),
  text: get("text", string),
  start: get("start", position),
  end: get("end", position),
}))

export const firing: Decoder<Firing> = object<Firing>(get => ({
  n: get("n", number),
  time: get("time", number),
  function: get("function", string),
  task: get("task", number),
  cause: get("cause", cause),
  took: get("took", optional(list(input), [])),
  gave: get("gave", optional(list(output), [])),
  branches: get("branches", optional(list(branch), [])),
}))
