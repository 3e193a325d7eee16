/// Arguments of each kind of check: which there are, what may stand in them, and with what a new check begins.
/// The limits are those of `checks.py` of the service.

import type {Argument} from "./draft.ts"
import type {CheckKind} from "./lesson_file.ts"

export type ArgumentForm =
  | {
      readonly kind: "number"
      readonly unit: "s" | "m" | "m/s" | "°" | ""
      readonly least: number
      readonly most: number
      readonly step: number
    }
  /// A goal of the room that has a place, counted from 0.
  | {readonly kind: "place"}
  | {readonly kind: "pattern"; readonly of: "event" | "command"}
  /// A property of the run in words.
  | {readonly kind: "property"}
  /// Texts, one a line.
  | {readonly kind: "lines"}
  /// Names of types.
  | {readonly kind: "types"}

export interface ArgumentSpec {
  readonly form: ArgumentForm
  /// `undefined`: absent until it is given.
  readonly initial: Argument | undefined
}

export type ArgumentName =
  | "time"
  | "goal"
  | "degrees"
  | "after"
  | "metres"
  | "speed"
  | "within"
  | "by"
  | "texts"
  | "command"
  | "event"
  | "least"
  | "property"
  | "takes"
  | "tolerance"
  | "gives"

const seconds = (least: number, initial: number | undefined): ArgumentSpec => ({
  form: {kind: "number", unit: "s", least, most: 600, step: 0.1},
  initial,
})
const counted = (most: number, initial: number): ArgumentSpec => ({
  form: {kind: "number", unit: "", least: 1, most, step: 1},
  initial,
})
const distance = (initial: number): ArgumentSpec => ({
  form: {kind: "number", unit: "m", least: 0.01, most: 1000, step: 0.01},
  initial,
})
const place: ArgumentSpec = {form: {kind: "place"}, initial: 0}
const pattern = (of: "event" | "command", initial: string): ArgumentSpec => ({
  form: {kind: "pattern", of},
  initial,
})
const types: ArgumentSpec = {form: {kind: "types"}, initial: []}
/// The shortest span, s: half of a step of the simulation would match nothing.
const shortest = 0.02

const event = pattern("event", "Bumper _ Pressed")
const command = pattern("command", "Sound _")

const checkArguments: {
  readonly [kind in CheckKind]: {readonly [name in ArgumentName]?: ArgumentSpec}
} = {
  at: {time: seconds(0, 5), goal: place},
  faces: {
    time: seconds(0, 5),
    goal: place,
    degrees: {form: {kind: "number", unit: "°", least: 1, most: 180, step: 1}, initial: 10},
  },
  goals: {within: seconds(shortest, undefined)},
  moves: {metres: {form: {kind: "number", unit: "m", least: 0.1, most: 1000, step: 0.1}, initial: 1}},
  farthest: {metres: distance(0.5), tolerance: distance(0.1)},
  back: {tolerance: distance(0.1)},
  gap: {event, metres: distance(0.5), tolerance: distance(0.1)},
  raises: {
    event,
    speed: {form: {kind: "number", unit: "m/s", least: 0.01, most: 2, step: 0.01}, initial: 0.05},
    within: seconds(shortest, 1),
  },
  counts: {event, least: counted(100, 3)},
  // In cm.
  measures: {tolerance: {form: {kind: "number", unit: "", least: 1, most: 1000, step: 1}, initial: 5}},
  varies: {
    command: pattern("command", "Velocity _ _"),
    least: {form: {kind: "number", unit: "", least: 2, most: 1000, step: 1}, initial: 5},
  },
  returns: {event, command: pattern("command", "Velocity _ _")},
  reaches: {
    speed: {form: {kind: "number", unit: "m/s", least: -2, most: 2, step: 0.1}, initial: 0.3},
    within: seconds(shortest, 5),
  },
  still: {after: seconds(0, 5)},
  holds: {property: {form: {kind: "property"}, initial: "never-falls"}},
  sends: {command: pattern("command", "Led1 Green"), within: seconds(shortest, undefined)},
  answers: {event, command, within: seconds(shortest, 0.3), least: counted(100, 1)},
  silent: {event, command, after: seconds(0, undefined), within: seconds(shortest, 0.1)},
  never: {event},
  says: {texts: {form: {kind: "lines"}, initial: []}},
  ends: {by: seconds(shortest, 10)},
  function: {takes: types, gives: types},
  functions: {least: counted(50, 1)},
}

/// The arguments of a kind in the order of its form.
export function specsOf(kind: CheckKind): readonly (readonly [ArgumentName, ArgumentSpec])[] {
  return Object.entries(checkArguments[kind]) as [ArgumentName, ArgumentSpec][]
}

export function initialArguments(kind: CheckKind): {readonly [name: string]: Argument} {
  return Object.fromEntries(
    specsOf(kind).flatMap(([name, {initial}]) => (initial === undefined ? [] : [[name, initial]])),
  )
}
