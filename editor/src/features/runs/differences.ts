/// Differences between a run on a real robot and the run of the same program in the simulator beside it. Pure.

import type {Frame} from "../../state/messages/messages.ts"
import {isOn} from "../../state/runs/channels.ts"
import {frameAt, framesBetween, type Recording, spanOfTime} from "../../state/runs/recording.ts"

/// Channels that tell that the robot touched or felt something, in the order in which differences are told.
const feltChannels = ["Bumper", "Cliff", "Wheel"] as const
export type FeltChannel = (typeof feltChannels)[number]

export interface Differences {
  /// The moment at which both are compared, s: the end of the shorter run, unless an earlier one is asked for.
  readonly time: number
  /// The real robot turned so many radians more or less than the simulated one, or, where these turned in different directions, further to this side.
  readonly turned: {readonly angle: number; readonly how: "more" | "less" | "left" | "right"} | null
  /// It drove so many metres further or less.
  readonly drove: {readonly way: number; readonly how: "further" | "less"} | null
  /// It is so many metres from the simulated one; `null` when that is near.
  readonly apart: number | null
  /// What only one of them felt, or each at another time: when it began, s, or `null` for never.
  readonly felt: readonly {
    readonly channel: FeltChannel
    readonly real: number | null
    readonly simulated: number | null
  }[]
}

/// What is less is the same, m, rad, s: a hand sets the real robot no better, and it is told what to do a little later.
const same = {way: 0.03, angle: (3 * Math.PI) / 180, place: 0.05, time: 0.5} as const
/// So small a part of a long way or of many turns is the same.
const samePart = 0.02

/// A turn of less than this has no direction, rad.
const straight = (5 * Math.PI) / 180

const sensors = 3

/// What a run did until a moment.
interface Drive {
  /// Radians to the left, in all; not wrapped.
  readonly turn: number
  /// Metres, forwards and backwards.
  readonly way: number
  readonly place: Pick<Frame, "x" | "y">
  /// When each channel was first on, s.
  readonly felt: ReadonlyMap<FeltChannel, number>
}

/// The runs until their common end, or until an earlier moment, s; `null` before both have begun.
export function differences(
  real: Recording,
  simulated: Recording,
  until: number | null = null,
): Differences | null {
  const ends = [real, simulated].map(spanOfTime)
  if (ends.includes(null)) return null
  const time = Math.min(...ends.map(span => span?.to ?? 0), until ?? Number.POSITIVE_INFINITY)
  const [one, other] = [driveUntil(real, time), driveUntil(simulated, time)]
  if (one === null || other === null) return null
  const apart = Math.hypot(one.place.x - other.place.x, one.place.y - other.place.y)
  return {
    time,
    turned: turnDifference(one.turn, other.turn),
    drove: wayDifference(one.way, other.way),
    apart: apart < same.place ? null : apart,
    felt: feltChannels.flatMap(channel => {
      const [a, b] = [one.felt.get(channel) ?? null, other.felt.get(channel) ?? null]
      const isSame = a === b || (a !== null && b !== null && Math.abs(a - b) < same.time)
      return isSame ? [] : [{channel, real: a, simulated: b}]
    }),
  }
}

/// Whether nothing differs that is worth a word.
export const isSame = ({turned, drove, apart, felt}: Differences): boolean =>
  turned === null && drove === null && apart === null && felt.length === 0

function turnDifference(real: number, simulated: number): Differences["turned"] {
  const angle = Math.abs(real - simulated)
  if (angle < Math.max(same.angle, samePart * Math.abs(simulated))) return null
  const isTurn = Math.min(Math.abs(real), Math.abs(simulated)) > straight
  if (isTurn && Math.sign(real) === Math.sign(simulated))
    return {angle, how: Math.abs(real) > Math.abs(simulated) ? "more" : "less"}
  return {angle, how: real > simulated ? "left" : "right"}
}

function wayDifference(real: number, simulated: number): Differences["drove"] {
  const way = Math.abs(real - simulated)
  if (way < Math.max(same.way, samePart * simulated)) return null
  return {way, how: real > simulated ? "further" : "less"}
}

function driveUntil(recording: Recording, time: number): Drive | null {
  const place = frameAt(recording, time)
  if (place === null) return null
  const felt = new Map<FeltChannel, number>()
  let turn = 0
  let way = 0
  let before: Frame | null = null
  for (const frame of framesBetween(recording, 0, time)) {
    if (before !== null) {
      turn += wrapped(frame.theta - before.theta)
      way += Math.hypot(frame.x - before.x, frame.y - before.y)
    }
    for (const channel of feltChannels)
      if (!felt.has(channel) && isAnyOn(frame, channel)) felt.set(channel, frame.time)
    before = frame
  }
  return {turn, way, place, felt}
}

/// Odometry wraps its heading; between two frames a robot turns less than half a turn.
const wrapped = (angle: number): number => angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI))

function isAnyOn(frame: Frame, channel: FeltChannel): boolean {
  for (let place = 0; place < sensors; place += 1) if (isOn(frame, channel, place)) return true
  return false
}
