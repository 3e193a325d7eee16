/// Segments of the trail by speed or time, and its time marks. Pure; `trail_drawing.ts` draws them.

import type {Point, Trail} from "../../state/runs/room_state.ts"

/// Steps from slow to fast, or from long ago to now.
export const levels = 5

/// Speeds at which the next level begins, m/s; the robot drives at most 0.7.
const speedEdges = [0.1, 0.25, 0.4, 0.55]

export function speedLevel(speed: number): number {
  return speedEdges.filter(edge => speed >= edge).length
}

/// Seconds that the levels of time share between them. It grows in leaps, so that a trail is not coloured anew
/// at every moment.
export function timeSpan(now: number): number {
  let span = 5
  while (span < now) span *= 1.25
  return span
}

export function timeLevel(time: number, span: number): number {
  return Math.min(levels - 1, Math.max(0, Math.floor((levels * time) / span)))
}

/// A stretch of one level. It begins where the one before ends.
export interface TrailSegment {
  readonly level: number
  readonly points: readonly Point[]
}

/// A piece of trail in stretches of one level each. Points closer together than `apart` metres are left out: on
/// the screen they are one.
export function segmentsOf(
  piece: readonly Point[],
  levelOf: (p: Point) => number,
  apart: number,
): readonly TrailSegment[] {
  const found: {level: number; points: Point[]}[] = []
  piece.forEach((p, i) => {
    const level = levelOf(p)
    const current = found.at(-1)
    const tip = current?.points.at(-1)
    if (current === undefined || tip === undefined) found.push({level, points: [p]})
    else if (current.level !== level && i < piece.length - 1) {
      current.points.push(p)
      found.push({level, points: [p]})
    } else if (i === piece.length - 1 || Math.hypot(p.x - tip.x, p.y - tip.y) >= apart) current.points.push(p)
  })
  return found
}

/// Seconds between two marks, the smallest that gives no more than `mostMarks`.
const markSteps = [1, 2, 5, 10, 20, 30, 60, 120, 300, 600]
const mostMarks = 10

/// Where the robot was at round times, at most so often that a learner can read them. Places closer together
/// than `apart` metres share the first one's mark.
export function timeMarks(trail: Trail, now: number, apart: number): readonly Point[] {
  const step = markSteps.find(s => now / s <= mostMarks) ?? Math.ceil(now / mostMarks)
  const marks: Point[] = []
  let time = step
  for (const piece of trail) {
    if ((piece.at(-1)?.time ?? 0) < time) continue
    for (const p of piece) {
      if (p.time < time || p.time > now) continue
      const last = marks.at(-1)
      const round = Math.floor(p.time / step) * step
      if (last === undefined || Math.hypot(p.x - last.x, p.y - last.y) >= apart)
        marks.push({...p, time: round})
      time = round + step
    }
  }
  return marks
}

/// The trail as it was at a time.
export function trailUntil(trail: Trail, time: number): Trail {
  const cut: (readonly Point[])[] = []
  for (const piece of trail) {
    if ((piece[0]?.time ?? 0) > time) break
    cut.push((piece.at(-1)?.time ?? 0) <= time ? piece : piece.filter(p => p.time <= time))
  }
  return cut
}
