/// Data of a strip chart: time window, value range, and downsampled points. Pure.

import type {Frame} from "../../state/messages/messages.ts"
import type {ChartSpan} from "../../state/page_state.ts"
import {type Recording, spanOfTime} from "../../state/runs/recording.ts"
import type {Quantity} from "../../values/quantities.ts"

export interface Point {
  readonly time: number
  readonly value: number
}

export interface Curve {
  /// Seconds of the run.
  readonly from: number
  readonly to: number
  readonly low: number
  readonly high: number
  readonly points: readonly Point[]
  /// The value at a time: that of the last point before it; `null` when there was none yet.
  at(time: number): number | null
}

/// Points that a strip has room for; where there are more frames, each group of them is its lowest and highest.
const room = 600

/// The window ends now, or lies around the time that the learner looks back at.
export function windowOf(
  recording: Recording,
  lookedAt: number | null,
  seconds: ChartSpan,
): {from: number; to: number} {
  const span = spanOfTime(recording) ?? {from: 0, to: 0}
  if (seconds === "all") return {from: span.from, to: Math.max(span.to, span.from + 1)}
  const middle = lookedAt === null ? span.to : Math.min(span.to, lookedAt + seconds / 2)
  const to = Math.max(middle, span.from + seconds)
  return {from: to - seconds, to}
}

/// A window of both runs, when all of them is shown.
export function unitedWindow(
  shown: {readonly from: number; readonly to: number},
  other: Recording | null,
  seconds: ChartSpan,
): {from: number; to: number} {
  const span = other === null || seconds !== "all" ? null : spanOfTime(other)
  return span === null ? {...shown} : {from: Math.min(shown.from, span.from), to: Math.max(shown.to, span.to)}
}

/// Two curves with the same scale, so that they can be drawn in one picture.
export function withSameScale(a: Curve, b: Curve): readonly [Curve, Curve] {
  const scale = {low: Math.min(a.low, b.low), high: Math.max(a.high, b.high)}
  return [
    {...a, ...scale},
    {...b, ...scale},
  ]
}

/// The points of a piece of the recording, one per frame, or the lowest and the highest of each group of `every`.
function pointsOf(piece: readonly Frame[], quantity: Quantity, every: number): readonly Point[] {
  const points: Point[] = []
  let low: Point | null = null
  let high: Point | null = null
  piece.forEach((frame, i) => {
    const value = quantity.of(frame)
    if (value !== null) {
      const point = {time: frame.time, value}
      if (every === 1) points.push(point)
      if (low === null || value < low.value) low = point
      if (high === null || value >= high.value) high = point
    }
    if (every === 1 || low === null || high === null) return
    if ((i + 1) % every !== 0 && i < piece.length - 1) return
    if (low === high) points.push(low)
    else points.push(...(low.time < high.time ? [low, high] : [high, low]))
    low = null
    high = null
  })
  return points
}

/// Keeps the points of finished pieces, so that a long run costs no more per picture than a short one.
export interface Curves {
  of(recording: Recording, quantity: Quantity, shown: {readonly from: number; readonly to: number}): Curve
}

export function openCurves(): Curves {
  const kept = new WeakMap<readonly Frame[], Map<string, readonly Point[]>>()

  const points = (piece: readonly Frame[], quantity: Quantity, every: number, done: boolean) => {
    if (!done) return pointsOf(piece, quantity, every)
    const known = kept.get(piece) ?? new Map<string, readonly Point[]>()
    kept.set(piece, known)
    const key = `${every} ${quantity.key}`
    const found = known.get(key) ?? pointsOf(piece, quantity, every)
    known.set(key, found)
    return found
  }

  return {
    of(recording, quantity, shown) {
      const {pieces} = recording
      const seen = pieces.filter(
        piece => (piece.at(-1)?.time ?? 0) >= shown.from && (piece[0]?.time ?? 0) <= shown.to,
      )
      const frames = seen.reduce((n, piece) => n + piece.length, 0)
      // Powers of two: a run that grows is not looked through anew at every moment.
      const every = frames <= 2 * room ? 1 : 2 ** Math.ceil(Math.log2((2 * frames) / room))
      const inside: Point[] = []
      for (const piece of seen)
        for (const p of points(piece, quantity, every, piece !== pieces.at(-1)))
          if (p.time >= shown.from && p.time <= shown.to) inside.push(p)
      let low = 0
      let high = quantity.unit === "" ? 1 : 0
      for (const {value} of inside) {
        low = Math.min(low, value)
        high = Math.max(high, value)
      }
      // A flat line is drawn in the middle of some height, not on the edge of none.
      if (high - low < 1e-6) high = low + 1
      return {
        ...shown,
        low,
        high,
        points: inside,
        at: time => inside.findLast(p => p.time <= time)?.value ?? null,
      }
    },
  }
}
