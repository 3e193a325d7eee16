/// What the room shows: the world, the robot, the path it drove, what it says, and the console beside it.

import type {World} from "../worlds/world.ts"
import type {Frame, Goal} from "./messages.ts"
import {emptyRecording, frameAt, type Recording, record} from "./recording.ts"

export interface Point {
  readonly x: number
  readonly y: number
  /// When the robot was here, in seconds of the run.
  readonly time: number
  /// How fast it drove, forwards or backwards, m/s.
  readonly speed: number
}

/// What the colour and the width of the trail tell: nothing, how fast the robot drove, or when it was there.
export type TrailStyle = "plain" | "speed" | "time"

/// The path in pieces: only the last grows, so a long trail costs no more per frame than a short one, and a
/// finished piece can be drawn from a cache.
export type Trail = readonly (readonly Point[])[]

/// Points in a piece of trail.
const pieceLength = 128
/// A new point is kept when the robot has moved this far, in metres.
const trailStep = 0.01
/// Pieces kept: about 640 m of path.
const maxPieces = 500

export function extendTrail(trail: Trail, at: Point): Trail {
  const last = trail.at(-1)
  const tip = last?.at(-1)
  if (tip !== undefined && Math.hypot(at.x - tip.x, at.y - tip.y) < trailStep) return trail
  const point = {x: at.x, y: at.y, time: at.time, speed: at.speed}
  if (last === undefined) return [[point]]
  if (last.length < pieceLength) return [...trail.slice(0, -1), [...last, point]]
  return [...trail.slice(-maxPieces + 1), [last.at(-1) as Point, point]]
}

export interface Words {
  readonly text: string
  readonly time: number
}

export interface RoomState {
  readonly world: World | null
  /// The newest frame of the run.
  readonly frame: Frame | null
  readonly recording: Recording
  /// The learner looks back at this time of the run, in seconds; `null` shows the newest frame.
  readonly lookedAt: number | null
  readonly trail: Trail
  /// What the robot said, oldest first, and when, in seconds of the run.
  readonly words: readonly Words[]
  /// The goals of the world and how far they are in this run.
  readonly goals: readonly Goal[]
  /// When each function fired last, in seconds of the run.
  readonly fired: {readonly [name: string]: number}
  /// The movable thing that the keyboard holds, numbered as in a frame; `null` is the robot.
  readonly held: number | null
  /// The run whose frames are drawn; `null` before the first one and after a reset.
  readonly run: number | null
  /// Without a run, frames are drawn too: ROS clients and the learner's hands move the robot. But what still comes from
  /// the run before a reset is not; it ends when the service tells the room anew.
  readonly idle: boolean
}

export const emptyRoom: RoomState = {
  world: null,
  frame: null,
  recording: emptyRecording,
  lookedAt: null,
  trail: [],
  words: [],
  goals: [],
  fired: {},
  held: null,
  run: null,
  idle: false,
}

/// Whether what the service tells about this run is to be seen.
export function isShown(room: RoomState, run: number): boolean {
  return run === room.run || (room.run === null && room.idle)
}

/// Whether the robot stands where the room puts it, and has not been driven since.
export function isUntouched({run, frame, world}: RoomState): boolean {
  if (run !== null) return false
  if (frame === null || world === null) return true
  return Math.hypot(frame.x - world.start.x, frame.y - world.start.y) < 1e-6 && frame.v === 0
}

/// What is to be done here: as the run has it, or as the world says it before a run.
export function goalsOf(room: RoomState): readonly Goal[] {
  if (room.goals.length > 0 || room.world === null) return room.goals
  return room.world.goals.map(({kind, title}) => ({kind, title, state: "open", progress: 0, time: null}))
}

/// The room as it is before a run (or before any, with `run` null): the world stays.
export function clearRoom(room: RoomState, run: number | null): RoomState {
  return {...emptyRoom, world: room.world, run}
}

/// A bubble stays this long, in seconds of the run.
export const speechSeconds = 3

/// Words kept for looking back; the oldest go first.
const maxWords = 1000

export function hear(room: RoomState, text: string, time: number): RoomState {
  return {...room, words: [...room.words.slice(1 - maxWords), {text, time}]}
}

/// What the bubble says at the time that is looked at; `null` when there is none.
export function speech(room: RoomState): string | null {
  const now = room.lookedAt ?? room.frame?.time ?? 0
  const last = room.lookedAt === null ? room.words.at(-1) : room.words.findLast(w => w.time <= now)
  return last === undefined || now > last.time + speechSeconds ? null : last.text
}

export function showFrame(room: RoomState, told: Frame): RoomState {
  if (!isShown(room, told.run)) return room
  // What has not changed is not told again.
  const {boxes, memory} = room.frame ?? {boxes: null, memory: null}
  const frame = {...told, boxes: told.boxes ?? boxes, memory: told.memory ?? memory}
  const fired =
    frame.fired.length === 0
      ? room.fired
      : {...room.fired, ...Object.fromEntries(frame.fired.map(name => [name, frame.time]))}
  const recording = record(room.recording, frame)
  const trail = extendTrail(room.trail, {...frame, speed: Math.abs(frame.v)})
  return {...room, frame, recording, trail, fired}
}

/// The frame to draw: the newest, or the one the learner looks back at.
export function shownFrame(room: RoomState): Frame | null {
  return room.lookedAt === null ? room.frame : frameAt(room.recording, room.lookedAt)
}

/// A function glows this long after it fired, in seconds of the run.
const glowSeconds = 0.2

/// The functions that glow now, in the order of their names.
export function glowing(room: RoomState): readonly string[] {
  if (room.lookedAt !== null) return [...new Set(shownFrame(room)?.fired)].sort()
  const now = room.frame?.time ?? 0
  return Object.keys(room.fired)
    .filter(name => now - (room.fired[name] ?? 0) <= glowSeconds)
    .sort()
}

/// A line of the console. `count` says how often the same thing was told in a row.
export type ConsoleLine = {readonly time: number; readonly count: number} & (
  | {readonly kind: "said"; readonly text: string}
  | {readonly kind: "sensed"; readonly text: string}
  | {readonly kind: "sound"; readonly text: string}
)

/// Lines the console keeps; the oldest go first.
const maxLines = 500

export function addLine(
  lines: readonly ConsoleLine[],
  kind: ConsoleLine["kind"],
  text: string,
  time: number,
): readonly ConsoleLine[] {
  const last = lines.at(-1)
  if (last !== undefined && last.kind === kind && last.text === text)
    return [...lines.slice(0, -1), {...last, time, count: last.count + 1}]
  return [...lines.slice(-maxLines + 1), {kind, text, time, count: 1}]
}

const bumperNames = ["RightBumper", "CenterBumper", "LeftBumper"]
const cliffNames = ["RightCliff", "CenterCliff", "LeftCliff"]
const wheelNames = ["RightWheel", "LeftWheel"]

/// What the robot began to sense between two frames, in Haskell's words: bumps, holes and lifted wheels.
export function sensedBetween(before: Frame | null, after: Frame): readonly string[] {
  const news = (bits: (f: Frame) => number, names: readonly string[], say: (name: string) => string) =>
    names
      .filter((_, i) => bits(after) & (1 << i) && !((before === null ? 0 : bits(before)) & (1 << i)))
      .map(say)
  return [
    ...news(
      f => f.bumpers,
      bumperNames,
      name => `Bumper ${name} Pressed`,
    ),
    ...news(
      f => f.cliffs,
      cliffNames,
      name => `Cliff ${name} Hole`,
    ),
    ...news(
      f => f.wheels,
      wheelNames,
      name => `Wheel ${name} Air`,
    ),
  ]
}

/// protocol §2, `/mobile_base/commands/sound`; the names are the program's.
export const soundNames = [
  "OnSound",
  "OffSound",
  "RechargeSound",
  "ButtonSound",
  "ErrorSound",
  "CleaningStartSound",
  "CleaningEndSound",
] as const

/// protocol §2, `/mobile_base/commands/led1`; the names are the program's.
export const ledNames = ["Black", "Green", "Orange", "Red"] as const
