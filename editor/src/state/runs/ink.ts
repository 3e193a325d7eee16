/// Ink on the floor: the strokes that the robot's pen has drawn in a run. In: frames, whose channels say where the pen is, its colour and its width.
/// Pure; `views/room/trail_drawing.ts` draws it.

import {numberAt, type Sensed} from "./channels.ts"

export interface InkPoint {
  readonly x: number
  readonly y: number
  /// When the pen was here, in seconds of the run.
  readonly time: number
}

/// A line of one colour and width. A stroke of one point is a dot.
export interface Stroke {
  /// The number of the colour (`PenColor` of protocol/robots).
  readonly color: number
  /// Metres.
  readonly width: number
  readonly points: readonly InkPoint[]
}

/// Oldest first. Only the last stroke grows, so that the others can be drawn from a cache.
export type Ink = readonly Stroke[]

/// The robot at one time, with its channels.
export type InkFrame = InkPoint & Sensed

/// Points of a stroke; a longer line goes on in a stroke of its own.
const mostPoints = 128
/// A new point is kept when the robot has moved this far, in metres.
const inkStep = 0.01
/// Strokes kept: about 2.5 km of line. The oldest go first.
const mostStrokes = 2000
/// A hand moved the robot when it is farther away than this after no time, in metres; the pen draws no line to there.
const jump = 0.25
/// No robot drives faster, m/s.
const fastest = 1
/// Widths that are drawn, in metres.
const [narrowest, widest] = [0.002, 0.5]

const isDown = (frame: InkFrame) => numberAt(frame, "Pen") === 1

/// The ink after a frame; `before` is the frame that came before it.
export function extendInk(ink: Ink, before: InkFrame | null, frame: InkFrame): Ink {
  if (!isDown(frame)) return ink
  const color = numberAt(frame, "PenColor")
  const width = Math.min(widest, Math.max(narrowest, numberAt(frame, "PenWidth")))
  const at = pointOf(frame)
  const last = ink.at(-1)
  const from = before === null || isJump(before, frame) ? null : before
  // A pen that was down goes on where the ink ends, which is a little behind the robot.
  const tip = from === null ? undefined : isDown(from) ? last?.points.at(-1) : pointOf(from)
  if (tip === undefined) return [...ink.slice(1 - mostStrokes), {color, width, points: [at]}]
  const isSame =
    last !== undefined && from !== null && isDown(from) && last.color === color && last.width === width
  if (isSame && Math.hypot(at.x - tip.x, at.y - tip.y) < inkStep) return ink
  if (isSame && last.points.length < mostPoints)
    return [...ink.slice(0, -1), {...last, points: [...last.points, at]}]
  return [...ink.slice(1 - mostStrokes), {color, width, points: [tip, at]}]
}

const pointOf = ({x, y, time}: InkPoint): InkPoint => ({x, y, time})

function isJump(before: InkPoint, frame: InkPoint): boolean {
  const time = Math.max(0, frame.time - before.time)
  return Math.hypot(frame.x - before.x, frame.y - before.y) > jump + fastest * time
}

/// The ink as it was at a time.
export function inkUntil(ink: Ink, time: number): Ink {
  const cut: Stroke[] = []
  for (const stroke of ink) {
    if ((stroke.points[0]?.time ?? 0) > time) break
    const isWhole = (stroke.points.at(-1)?.time ?? 0) <= time
    cut.push(isWhole ? stroke : {...stroke, points: stroke.points.filter(point => point.time <= time)})
  }
  return cut
}
