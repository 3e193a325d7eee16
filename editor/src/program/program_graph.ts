/// The network of functions, tasks and steps that a program runs, as the compiler reports it (`protocol/README.md` §3, *Graph*), and its decoder.

import type {BlockId} from "@rosy/codegen"
import {
  boolean,
  type Decoder,
  list,
  Mismatch,
  number,
  object,
  oneOf,
  optional,
  string,
} from "../wire/decode.ts"

/// A piece of the text: 1-based, in characters; the end is exclusive.
export interface Extent {
  readonly line: number
  readonly column: number
  readonly endLine: number
  readonly endColumn: number
}

/// What a function takes or gives (rules R14 and R15).
export type TypeShape =
  | {readonly kind: "all"; readonly of: readonly TypeShape[]}
  | {readonly kind: "either"; readonly of: readonly TypeShape[]}
  | {readonly kind: "maybe"; readonly of: TypeShape}
  | {readonly kind: "each"; readonly of: TypeShape}
  | {
      readonly kind: "type"
      /// As the program writes it.
      readonly written: string
      /// Without synonyms.
      readonly spelled: string
      /// An event of the program's own, which goes from function to function.
      readonly own: boolean
      /// Where the program connects the type to a topic itself (language rule R23).
      readonly topic: TopicName | null
    }

/// `null` where the program computes it.
export interface TopicName {
  readonly name: string | null
  /// The type of its messages, such as `sensor_msgs/BatteryState`.
  readonly type: string | null
}

/// A topic that the program takes or sends itself.
export interface OwnTopic extends TopicName {
  /// The program's type.
  readonly of: string
  readonly use: "take" | "send"
  /// Paths of the fields that the program reads, such as `pose.position.x`.
  readonly fields: readonly string[]
}

const chartKinds = ["sequence", "repeat", "parallel", "race", "choice"] as const
export type ChartKind = (typeof chartKinds)[number]

interface Named {
  readonly name: string
  /// `null` when it is not in the text.
  readonly at: Extent | null
  /// Of a task that is read from the program's blocks: the block of the expression, its text, and what the next steps call its result.
  readonly block?: BlockId
  readonly text?: string
  readonly result?: string | null
}

export type ProgramPart =
  | (Named & {readonly kind: "function"; readonly inputs: readonly TypeShape[]; readonly output: TypeShape})
  /// What is carried out once, then what runs until `Done`.
  | (Named & {
      readonly kind: "task"
      readonly start: readonly ProgramPart[]
      readonly parts: readonly ProgramPart[]
    })
  | (Named & {
      readonly kind: ChartKind
      /// How often it is repeated, where that is written as a number.
      readonly turns: number | null
      readonly steps: readonly ProgramPart[]
    })
  /// A task that is not composed further.
  | (Named & {readonly kind: "step"})

const extent: Decoder<Extent> = (value, path) => {
  const [line, column, endLine, endColumn] = list(number)(value, path)
  if (line === undefined || column === undefined || endLine === undefined || endColumn === undefined)
    throw new Mismatch(path, "four numbers")
  return {line, column, endLine, endColumn}
}

const topicName: Decoder<TopicName> = object(get => ({
  name: get("name", optional(string, null)),
  type: get("type", optional(string, null)),
}))

const ownTopic: Decoder<OwnTopic> = object(get => ({
  name: get("name", optional(string, null)),
  type: get("type", optional(string, null)),
  of: get("of", string),
  use: get("use", oneOf("take", "send")),
  fields: get("fields", list(string)),
}))

const typeShape: Decoder<TypeShape> = (value, path) =>
  object<TypeShape>(get => {
    const all = get("all", optional(list(typeShape), null))
    if (all !== null) return {kind: "all", of: all}
    const either = get("either", optional(list(typeShape), null))
    if (either !== null) return {kind: "either", of: either}
    const maybe = get("maybe", optional(typeShape, null))
    if (maybe !== null) return {kind: "maybe", of: maybe}
    const each = get("each", optional(typeShape, null))
    if (each !== null) return {kind: "each", of: each}
    const written = get("type", string)
    const own = get("own", optional(boolean, false))
    const spelled = get("is", optional(string, written))
    return {kind: "type", written, spelled, own, topic: get("topic", optional(topicName, null))}
  })(value, path)

const programPart: Decoder<ProgramPart> = (value, path) =>
  object<ProgramPart>(get => {
    const kind = get("kind", string)
    const named = {name: get("name", string), at: get("at", optional(extent, null))}
    switch (kind) {
      case "function":
        return {...named, kind, inputs: get("inputs", list(typeShape)), output: get("output", typeShape)}
      case "task":
        return {
          ...named,
          kind,
          start: get("start", list(programPart)),
          parts: get("parts", list(programPart)),
        }
      case "step":
        return {...named, kind}
      default: {
        const chart = chartKinds.find(known => known === kind)
        if (chart === undefined) throw new Mismatch(`${path}.kind`, "a kind of part")
        const turns = get("turns", optional(number, null))
        return {...named, kind: chart, turns, steps: get("steps", list(programPart))}
      }
    }
  })(value, path)

/// The parts of `graph`; none without a report of the compiler.
export const programParts: Decoder<readonly ProgramPart[]> = object(get =>
  get("parts", optional(list(programPart), [])),
)

/// The topics of `graph`; none without a report of the compiler.
export const ownTopics: Decoder<readonly OwnTopic[]> = object(get =>
  get("topics", optional(list(ownTopic), [])),
)
