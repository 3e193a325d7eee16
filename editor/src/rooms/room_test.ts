/// A test in many rooms: the learner's choices, the request made of them, the service's messages (protocol §4.1), and the state of a test.

import {batchAnswer, batchProblem, type CommonAnswer} from "../state/batch_answer.ts"
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
} from "../state/decode.ts"
import type {World} from "../worlds/world.ts"
import {readWorld} from "../worlds/world_decoder.ts"
import {writeWorld} from "../worlds/world_encoder.ts"

/// The properties that can be chosen, in the order of the dialog.
export const propertyKinds = [
  "reaches-goal",
  "never-falls",
  "never-pushes",
  "returns-to-start",
  "covers",
  "room-goals",
] as const
export type PropertyKind = (typeof propertyKinds)[number]

/// Properties with a number, and the word for its unit on the wire: seconds, and percent of the floor.
const units = {"never-pushes": "s", covers: "%"} as const
export type MeasuredKind = keyof typeof units
export const isMeasured = (kind: PropertyKind): kind is MeasuredKind => kind in units

export const families = ["obstacles", "maze", "pits", "like"] as const
export type Family = (typeof families)[number]

/// Rooms of one test: at most what the service allows (protocol §4.1).
export const roomCounts = [10, 20, 50, 100, 200] as const

/// Seconds of each run, simulated.
export const runSeconds = 60

/// What has to hold in every room.
export interface PropertyChoices {
  readonly properties: readonly PropertyKind[]
  readonly amounts: Readonly<Record<MeasuredKind, number>>
}

export interface Choices extends PropertyChoices {
  readonly family: Family
  readonly rooms: number
  /// Which rooms of the family: another seed gives other rooms.
  readonly seed: number
}

export const firstChoices: Choices = {
  properties: ["reaches-goal", "never-falls"],
  amounts: {"never-pushes": 1, covers: 50},
  family: "obstacles",
  rooms: 20,
  seed: 1,
}

/// Least and most of a property's number.
export const amountLimits: Readonly<Record<MeasuredKind, readonly [number, number]>> = {
  "never-pushes": [0, 60],
  covers: [1, 100],
}

export interface Finding {
  readonly kind: PropertyKind
  readonly state: "open" | "held" | "failed"
  /// When it was decided, in seconds.
  readonly time: number | null
  /// Share of the way to the goals (0 to 1), longest push (s), nearest return to the start (m), or covered floor (%).
  readonly amount: number
}

export interface TestedRoom {
  readonly room: number
  readonly seed: number
  readonly passed: boolean
  /// The program itself failed in this room; its own words.
  readonly problems: readonly string[]
  readonly findings: readonly Finding[]
  readonly time: number
  readonly world: World
  readonly path: readonly (readonly [number, number])[]
}

export interface Smallest {
  readonly things: number
  readonly of: number
  /// No room of the family with fewer things fails.
  readonly minimal: boolean
  readonly tested: TestedRoom
}

type OwnAnswer =
  | {readonly op: "progress"; readonly done: number; readonly passed: number; readonly shrunk: number}
  | {
      readonly op: "report"
      readonly passed: number
      readonly rooms: readonly TestedRoom[]
      readonly smallest: Smallest | null
      readonly problems: readonly string[]
    }

export type Answer = CommonAnswer | OwnAnswer

export type RoomTest =
  | {readonly kind: "none"}
  /// `place` in the queue, 1 for the next; 0 before the service says anything.
  | {readonly kind: "waiting"; readonly place: number; readonly rooms: number}
  | {
      readonly kind: "running"
      readonly rooms: number
      readonly done: number
      readonly passed: number
      readonly shrunk: number
    }
  | {readonly kind: "reported"; readonly report: Answer & {readonly op: "report"}}
  /// `null`: the connection was lost.
  | {readonly kind: "failed"; readonly message: string | null}

/// The state of a test after a message.
export function heard(test: RoomTest, answer: Answer): RoomTest {
  if (test.kind !== "waiting" && test.kind !== "running") return test
  switch (answer.op) {
    case "queued":
      return {kind: "waiting", place: answer.place, rooms: test.rooms}
    case "progress": {
      const {done, passed, shrunk} = answer
      return {kind: "running", rooms: test.rooms, done, passed, shrunk}
    }
    case "report":
      return {kind: "reported", report: answer}
    case "failed":
      return {kind: "failed", message: answer.message}
  }
}

/// Whether the service says no more after this message.
export const isLast = ({op}: Answer): boolean => op === "report" || op === "failed"

/// The page's one message. A room like the one of the page is made from `world`.
export function requestOf(choices: Choices, source: string, world: World | null): object {
  const {family, rooms, seed} = choices
  const like = family === "like" && world !== null ? {world: writeWorld(world)} : {}
  return {op: "test", source, family, rooms, seed, seconds: runSeconds, properties: wordsOf(choices), ...like}
}

/// The properties as the service reads them (protocol §4.1).
export function wordsOf({properties, amounts}: PropertyChoices): string {
  const word = (kind: PropertyKind) => (isMeasured(kind) ? `${kind} ${amounts[kind]} ${units[kind]}` : kind)
  return propertyKinds
    .filter(kind => properties.includes(kind))
    .map(word)
    .join(", ")
}

/// The choices with a property chosen or not.
export function choosing<Chosen extends PropertyChoices>(
  choices: Chosen,
  kind: PropertyKind,
  chosen: boolean,
): Chosen {
  const others = choices.properties.filter(other => other !== kind)
  return {...choices, properties: chosen ? [...others, kind] : others}
}

const point: Decoder<readonly [number, number]> = (value, path) => {
  const [x = Number.NaN, y = Number.NaN] = list(number)(value, path)
  return [x, y]
}

/// The first word names the property; its number stands behind it.
const propertyKind: Decoder<PropertyKind> = (value, path) =>
  oneOf(...propertyKinds)(string(value, path).split(" ")[0], path)

const finding: Decoder<Finding> = object(get => ({
  kind: get("property", propertyKind),
  state: get("state", oneOf("open", "held", "failed")),
  time: get("time", optional(number, null)),
  amount: get("amount", number),
}))

const world: Decoder<World> = (value, path) => {
  const read = readWorld(value)
  if (read.kind === "world") return read.world
  throw new Mismatch(`${path}.${read.fault.path}`, `a room: ${read.fault.why}`)
}

export const testedRoom: Decoder<TestedRoom> = object(get => ({
  room: get("room", number),
  seed: get("seed", number),
  passed: get("passed", boolean),
  problems: get("problems", list(batchProblem)),
  findings: get("findings", list(finding)),
  time: get("time", number),
  world: get("world", world),
  path: get("path", list(point)),
}))

const smallest: Decoder<Smallest> = object(get => ({
  things: get("things", number),
  of: get("of", number),
  minimal: get("minimal", boolean),
  tested: get("tested", testedRoom),
}))

/// A message of the service.
export const readAnswer = batchAnswer<OwnAnswer>({
  progress: object(
    get =>
      ({
        op: "progress",
        done: get("done", number),
        passed: get("passed", number),
        shrunk: get("shrunk", number),
      }) as const,
  ),
  report: object(
    get =>
      ({
        op: "report",
        passed: get("passed", number),
        rooms: get("rooms", list(testedRoom)),
        smallest: get("smallest", optional(smallest, null)),
        problems: get("problems", list(batchProblem)),
      }) as const,
  ),
})
