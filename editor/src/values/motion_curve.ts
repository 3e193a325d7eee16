/// Speed and position of a run on one time axis, and the rate of change at a moment. Pure.

import type {Frame} from "../state/messages/messages.ts"
import {speedOf} from "../state/runs/channels.ts"
import {frameAt, type Recording, spanOfTime} from "../state/runs/recording.ts"

export interface MotionPoint {
  /// Seconds of the run.
  readonly time: number
  /// How far ahead of its start the robot is, m: the `x` of the program's `Position`.
  readonly position: number
  /// In the direction of the start, m/s: what the position changes by each second.
  readonly rate: number
}

/// Points that the chart has room for.
const mostPoints = 300

export interface MotionCurve {
  readonly from: number
  readonly to: number
  readonly points: readonly MotionPoint[]
  /// At the displayed moment.
  readonly now: MotionPoint
}

/// `null` before the first frame. `at` is the displayed moment, s; now when it is `null`.
export function motionCurve(recording: Recording, at: number | null): MotionCurve | null {
  const span = spanOfTime(recording)
  const start = recording.pieces[0]?.[0]
  if (span === null || start === undefined) return null
  const shown = at === null ? recording.pieces.at(-1)?.at(-1) : frameAt(recording, at)
  const every = Math.max(1, Math.ceil(recording.length / mostPoints))
  const frames = recording.pieces.flat()
  const points = frames.filter((_, i) => i % every === 0 || i === frames.length - 1)
  return {
    from: span.from,
    to: Math.max(span.to, span.from + 1),
    points: points.map(frame => pointOf(start, frame)),
    now: pointOf(start, shown ?? start),
  }
}

function pointOf(start: Frame, frame: Frame): MotionPoint {
  const [cos, sin] = [Math.cos(start.theta), Math.sin(start.theta)]
  return {
    time: frame.time,
    position: (frame.x - start.x) * cos + (frame.y - start.y) * sin,
    rate: speedOf(frame) * Math.cos(frame.theta - start.theta),
  }
}
