/// Film of a run for a file without a service: the recorded frames as few whole numbers, and the state of the room at any time between them. Pure.

import type {Frame} from "../../state/messages/messages.ts"
import type {Channels} from "../../state/runs/channels.ts"
import {extendInk, type Ink, type InkFrame} from "../../state/runs/ink.ts"
import {framesBetween} from "../../state/runs/recording.ts"
import {type RoomState, speech} from "../../state/runs/room_state.ts"
import {normalizeAngle} from "../../views/room/poses.ts"
import type {World} from "../../worlds/world.ts"

type Triple = readonly [number, number, number]

/// Milliseconds of the run, millimetres, milliradians; then the drawn channels and the movable objects (as the pose), each only where they have changed.
type Shot = readonly [
  ms: number,
  x: number,
  y: number,
  theta: number,
  channels?: Channels | null,
  objects?: readonly Triple[],
]

export interface Film {
  readonly world: World
  readonly shots: readonly Shot[]
  /// What the robot said, and when, in milliseconds.
  readonly words: readonly (readonly [number, string])[]
}

/// The channels that show on the robot (`views/room/robot_drawing.ts`), and what its pen draws with.
const drawnChannels = ["Bumper", "Cliff", "Wheel", "Button", "Led1", "Led2", "Pen", "PenColor", "PenWidth"]

/// Shots of a film: a minute at 25 a second. A longer run has them further apart, so that the file stays small.
const mostShots = 1500
/// Milliseconds between two shots, at least.
const leastGap = 40

const thousandths = (value: number) => Math.round(value * 1000)
const triple = ([x, y, theta]: Triple): Triple => [thousandths(x), thousandths(y), thousandths(theta)]

/// The film of the recorded run; `null` before the first run and without a room.
export function filmOf(room: RoomState): Film | null {
  const {world, recording, run} = room
  const frames = [...framesBetween(recording, Number.NEGATIVE_INFINITY, Number.POSITIVE_INFINITY)]
  const [first] = frames
  if (world === null || run === null || first === undefined) return null
  const shots: Shot[] = []
  const gap = Math.max(leastGap, ((frames.at(-1) ?? first).time - first.time) * (1000 / mostShots))
  let [channels, objects] = ["", ""]
  let last = Number.NEGATIVE_INFINITY
  frames.forEach((frame, i) => {
    const shown = drawnOf(frame)
    const seen = JSON.stringify(shown)
    const ms = thousandths(frame.time)
    const isNew = seen !== channels
    // A short press would fall between two shots.
    if (!isNew && ms - last < gap && i < frames.length - 1) return
    const moved = frame.boxes?.map(triple) ?? []
    const isMoved = JSON.stringify(moved) !== objects
    const [x, y, theta] = triple([frame.x, frame.y, frame.theta])
    shots.push([
      ms,
      x,
      y,
      theta,
      ...(isNew || isMoved ? [isNew ? shown : null] : []),
      ...(isMoved ? [moved] : []),
    ] as unknown as Shot)
    channels = seen
    objects = JSON.stringify(moved)
    last = ms
  })
  return {world, shots, words: room.words.map(({text, time}) => [thousandths(time), text])}
}

function drawnOf({channels}: Frame): Channels {
  return Object.fromEntries(
    drawnChannels.flatMap(name => {
      const values = channels[name]
      return values === undefined ? [] : [[name, values]]
    }),
  )
}

/// When a film begins and ends, s.
export function durationOf({shots}: Film): {readonly from: number; readonly to: number} {
  return {from: (shots[0]?.[0] ?? 0) / 1000, to: (shots.at(-1)?.[0] ?? 0) / 1000}
}

/// Seconds of a film file; a longer run is shown faster.
export const longestFilm = 60

/// Seconds of the run in a second of its film file: 1, or more for a run that is longer than `longestFilm`.
export function paceOf(film: Film): number {
  const {from, to} = durationOf(film)
  return Math.max(1, (to - from) / longestFilm)
}

/// What is drawn at one time.
export interface Moment {
  readonly x: number
  readonly y: number
  readonly theta: number
  readonly channels: Channels
  readonly objects: readonly Triple[]
  /// The path up to here, m.
  readonly path: readonly (readonly [number, number])[]
  /// What the pen has drawn up to here.
  readonly ink: Ink
  /// What the bubble of speech says.
  readonly said: string | null
}

/// Shots further apart are a jump of the robot (a hand has moved it), not a motion, mm.
const jump = 500

/// The room at `time` seconds: between two shots the pose lies on the straight line between theirs.
export function momentAt({shots, words, world}: Film, time: number): Moment {
  const ms = time * 1000
  let channels: Channels = {}
  let objects: readonly Triple[] = []
  const path: (readonly [number, number])[] = []
  let ink: Ink = []
  let before: InkFrame | null = null
  let [at, next]: [Shot | undefined, Shot | undefined] = [shots[0], undefined]
  for (const shot of shots) {
    if (shot[0] > ms && path.length > 0) {
      next = shot
      break
    }
    at = shot
    channels = shot[4] ?? channels
    objects = shot[5] ?? objects
    path.push([shot[1] / 1000, shot[2] / 1000])
    const drawing: InkFrame = {time: shot[0] / 1000, x: shot[1] / 1000, y: shot[2] / 1000, channels}
    ink = extendInk(ink, before, drawing)
    before = drawing
  }
  const {start} = world
  const [from, x, y, theta] = at ?? [0, ...triple([start.x, start.y, start.theta])]
  const isMotion = next !== undefined && Math.hypot(next[1] - x, next[2] - y) <= jump && ms > from
  const [to, nextX, nextY, nextTheta] = isMotion && next !== undefined ? next : [from + 1, x, y, theta]
  const part = isMotion ? (ms - from) / (to - from) : 0
  const pose = {
    x: (x + (nextX - x) * part) / 1000,
    y: (y + (nextY - y) * part) / 1000,
    theta: theta / 1000 + normalizeAngle((nextTheta - theta) / 1000) * part,
  }
  path.push([pose.x, pose.y])
  const said = words.map(([when, text]) => ({time: when / 1000, text}))
  const bubble = speech({words: said, lookedAt: time, frame: null})
  return {
    ...pose,
    channels,
    objects: objects.map(([a, b, c]) => [a / 1000, b / 1000, c / 1000]),
    path,
    ink,
    said: bubble?.text ?? null,
  }
}
