/// What a strip chart shows: a window of time, a range of values, and the points between. Pure.

import {framesBetween, type Quantity, type Recording, spanOfTime} from "../state/recording.ts"

export interface Curve {
  /// Seconds of the run.
  readonly from: number
  readonly to: number
  readonly low: number
  readonly high: number
  readonly points: readonly {readonly time: number; readonly value: number}[]
  /// The value at a time: that of the last point before it.
  at(time: number): number | null
}

/// Seconds that a strip shows.
export const windowSeconds = 20

/// The window ends now, or lies around the time that the learner looks back at.
export function windowOf(recording: Recording, lookedAt: number | null): {from: number; to: number} {
  const span = spanOfTime(recording) ?? {from: 0, to: 0}
  const middle = lookedAt === null ? span.to : Math.min(span.to, lookedAt + windowSeconds / 2)
  const to = Math.max(middle, span.from + windowSeconds)
  return {from: to - windowSeconds, to}
}

export function curveOf(
  recording: Recording,
  quantity: Quantity,
  shown: {readonly from: number; readonly to: number},
): Curve {
  const points = [...framesBetween(recording, shown.from, shown.to)].map(f => ({
    time: f.time,
    value: quantity.of(f),
  }))
  let low = 0
  let high = quantity.unit === "" ? 1 : 0
  for (const {value} of points) {
    low = Math.min(low, value)
    high = Math.max(high, value)
  }
  // A flat line is drawn in the middle of some height, not on the edge of none.
  if (high - low < 1e-6) high = low + 1
  return {
    ...shown,
    low,
    high,
    points,
    at: time => points.findLast(p => p.time <= time)?.value ?? points[0]?.value ?? null,
  }
}
