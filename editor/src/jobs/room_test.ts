/// A test in many rooms: the learner's choices, the request made of them, the service's messages (protocol §4.1), and the state of a test.

import {Mismatch, mapped, readerOf} from "../wire/decode.ts"
import type {Queued} from "../wire/page/jobs.generated.ts"
import {
  type FindingShown,
  type Progress,
  type RoomTestRequest,
  roomTestAnswer,
  type TestedRoom as ShownRoom,
  type SmallestRoom,
} from "../wire/page/room_tests.generated.ts"
import type {World} from "../worlds/world.ts"
import {worldAt} from "../worlds/world_decoder.ts"
import {writeWorld} from "../worlds/world_encoder.ts"
import {batchFailure, batchProblem} from "./batch_answer.ts"

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

export interface Finding extends Omit<FindingShown, "property"> {
  readonly kind: PropertyKind
}

export interface TestedRoom extends Omit<ShownRoom, "ended" | "findings" | "problems" | "world"> {
  /// The program itself failed in this room; its own words.
  readonly problems: readonly string[]
  readonly findings: readonly Finding[]
  readonly world: World
}

export interface Smallest extends Omit<SmallestRoom, "tested"> {
  readonly tested: TestedRoom
}

export type Answer =
  | Queued
  | {readonly op: "failed"; readonly message: string}
  | Progress
  | {
      readonly op: "report"
      readonly passed: number
      readonly rooms: readonly TestedRoom[]
      readonly smallest: Smallest | null
      readonly problems: readonly string[]
    }

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
export function requestOf(choices: Choices, source: string, world: World | null): RoomTestRequest {
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

/// The first word names the property; its number stands behind it.
function finding({property, ...shown}: FindingShown): Finding {
  const word = property.split(" ")[0]
  const kind = propertyKinds.find(known => known === word)
  if (kind === undefined) throw new Mismatch("property", `one of ${propertyKinds.join(", ")}`)
  return {kind, ...shown}
}

/// A room of a message as the page keeps it.
export const testedRoom = ({ended: _, findings, problems, world, ...shown}: ShownRoom): TestedRoom => ({
  ...shown,
  findings: findings.map(finding),
  problems: problems.map(batchProblem),
  world: worldAt("world", world),
})

/// A message of the service.
export const readAnswer = readerOf(
  mapped(roomTestAnswer, (answer): Answer => {
    if (answer.op === "failed") return {op: "failed", message: batchFailure(answer)}
    if (answer.op !== "report") return answer
    const {smallest, rooms, problems} = answer
    return {
      ...answer,
      rooms: rooms.map(testedRoom),
      smallest: smallest && {...smallest, tested: testedRoom(smallest.tested)},
      problems: problems.map(batchProblem),
    }
  }),
)
