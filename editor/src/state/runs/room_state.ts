/// State of the room: the world, the robot's newest frame, its trail, its speech, and the console's lines. Pure.

import type {Branch} from "../../wire/firing.generated.ts"
import type {Goal} from "../../wire/page/runs.generated.ts"
import type {World} from "../../worlds/world.ts"
import {type FixPreviews, noFixPreviews} from "../messages/fix_previews.ts"
import type {Frame} from "../messages/messages.ts"
import {noPreview, type PreviewState} from "../messages/preview.ts"
import {speedOf} from "./channels.ts"
import {addFirings, emptyLog, type FiringLog, firingsUntil} from "./firing_log.ts"
import {extendInk, type Ink, inkUntil} from "./ink.ts"
import {emptyRecording, frameAt, framesBetween, type Recording, record, recordedUntil} from "./recording.ts"

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
  /// What the pen has drawn.
  readonly ink: Ink
  /// What the robot said, oldest first, and when, in seconds of the run.
  readonly words: readonly Words[]
  /// The goals of the world and how far they are in this run.
  readonly goals: readonly Goal[]
  /// When each function fired last, in seconds of the run.
  readonly fired: {readonly [name: string]: number}
  /// What functions took and gave; only while the values are shown.
  readonly firings: FiringLog
  /// Equations, guards and alternatives between which the functions of the running program choose.
  readonly branches: readonly Branch[]
  /// The movable thing that the keyboard holds, numbered as in a frame; `null` is the robot.
  readonly held: number | null
  /// The run whose frames are drawn; `null` before the first one and after a reset.
  readonly run: number | null
  /// The program of that run; `null` without one.
  readonly source: string | null
  /// Without a run, frames are drawn too: ROS clients and the learner's hands move the robot. But what still comes from
  /// the run before a reset is not; it ends when the service sends the room again.
  readonly idle: boolean
  /// Where the edited program would drive.
  readonly preview: PreviewState
  /// Where the offered fixes would make it drive.
  readonly fixPreviews: FixPreviews
}

export const emptyRoom: RoomState = {
  world: null,
  frame: null,
  recording: emptyRecording,
  lookedAt: null,
  trail: [],
  ink: [],
  words: [],
  goals: [],
  fired: {},
  firings: emptyLog,
  branches: [],
  held: null,
  run: null,
  source: null,
  idle: false,
  preview: noPreview,
  fixPreviews: noFixPreviews,
}

/// Whether messages about this run are shown.
export function isShown(room: RoomState, run: number): boolean {
  return run === room.run || (room.run === null && room.idle)
}

/// Whether the robot stands where the room puts it, and has not been driven since.
export function isUntouched({run, frame, world}: RoomState): boolean {
  if (run !== null) return false
  if (frame === null || world === null) return true
  return Math.hypot(frame.x - world.start.x, frame.y - world.start.y) < 1e-6 && speedOf(frame) === 0
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

/// The room as it was at a time of its run, s: what came later is forgotten.
export function roomUntil(room: RoomState, time: number): RoomState {
  const recording = recordedUntil(room.recording, time)
  const trail = room.trail.map(piece => piece.filter(point => point.time <= time))
  const fired: {[name: string]: number} = {}
  for (const frame of framesBetween(recording, Number.NEGATIVE_INFINITY, time))
    for (const name of frame.fired) fired[name] = frame.time
  return {
    ...room,
    recording,
    frame: frameAt(recording, time),
    lookedAt: null,
    trail: trail.filter(piece => piece.length > 0),
    ink: inkUntil(room.ink, time),
    words: room.words.filter(said => said.time <= time),
    fired,
    firings: firingsUntil(room.firings, time),
  }
}

/// A bubble stays this long, in seconds of the run.
const speechSeconds = 3

/// Words kept for looking back; the oldest go first.
const maxWords = 1000

export function addSpeech(room: RoomState, text: string, time: number): RoomState {
  return {...room, words: [...room.words.slice(1 - maxWords), {text, time}]}
}

/// What the bubble says at the time that is looked at; `null` when there is none.
export function speech(room: Pick<RoomState, "words" | "lookedAt" | "frame">): Words | null {
  const now = room.lookedAt ?? room.frame?.time ?? 0
  const last = room.lookedAt === null ? room.words.at(-1) : room.words.findLast(w => w.time <= now)
  return last === undefined || now > last.time + speechSeconds ? null : last
}

export function addFrame(room: RoomState, heard: Frame): RoomState {
  if (!isShown(room, heard.run)) return room
  // Firings are kept in a log of their own.
  const {firings = [], ...told} = heard
  // A frame carries only values that have changed.
  const {boxes, others, memory, channels} = {
    boxes: null,
    others: null,
    memory: null,
    channels: {},
    ...room.frame,
  }
  const frame = {
    ...told,
    channels: {...channels, ...told.channels},
    boxes: told.boxes ?? boxes,
    others: told.others ?? others,
    memory: told.memory ?? memory,
  }
  const fired =
    frame.fired.length === 0
      ? room.fired
      : {...room.fired, ...Object.fromEntries(frame.fired.map(name => [name, frame.time]))}
  const recording = record(room.recording, frame)
  const trail = extendTrail(room.trail, {...frame, speed: Math.abs(speedOf(frame))})
  const ink = extendInk(room.ink, room.frame, frame)
  return {...room, frame, recording, trail, ink, fired, firings: addFirings(room.firings, firings ?? [])}
}

/// The frame to draw: the newest, or the one the learner looks back at.
export function shownFrame(room: RoomState): Frame | null {
  return room.lookedAt === null ? room.frame : frameAt(room.recording, room.lookedAt)
}

/// A function glows this long after it fired, in seconds of the run.
const glowSeconds = 0.2

/// The functions that glow now, in the order of their names.
export function recentlyFired(room: RoomState): readonly string[] {
  if (room.lookedAt !== null) return [...new Set(shownFrame(room)?.fired)].sort()
  const now = room.frame?.time ?? 0
  return Object.keys(room.fired)
    .filter(name => now - (room.fired[name] ?? 0) <= glowSeconds)
    .sort()
}

/// A line of the console. `count` says how many equal lines in a row it stands for.
export type ConsoleLine = {readonly time: number; readonly count: number} & (
  | {readonly kind: "said"; readonly text: string}
  /// What another robot in the room said, or why its program has ended; the text names it.
  | {readonly kind: "companion"; readonly text: string}
  | {readonly kind: "sensed"; readonly text: string}
  | {readonly kind: "sound"; readonly text: string}
  /// The safety rules began to override the program.
  | {readonly kind: "safety"; readonly text: ""}
  /// The robot pushes against something and does not move; the text says whether with its bumper.
  | {readonly kind: "blocked"; readonly text: "bumper" | ""}
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
  return [...lines.slice(-maxLines + 1), {kind, text, time, count: 1} as ConsoleLine]
}

/// Events of the robot that the console shows on request only: the end of a contact, whether the robot is online, distances, and how far a goal
/// is, which come five times a second (channels of protocol/robots).
export function isMinorEvent({kind, text}: Pick<ConsoleLine, "kind" | "text">): boolean {
  return (
    kind === "sensed" &&
    /^Online$|^Offline$|^Ahead |^Scan |^Reply \S+ Feedback$| (?:Released|Floor|Ground)$/.test(text)
  )
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
