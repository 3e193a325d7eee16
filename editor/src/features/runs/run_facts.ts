/// Facts about a run that a list or a table shows: its length, the way that it drove, its goals, its path as a picture draws it. Pure.

import {goalsOf, type RoomState, type Trail} from "../../state/runs/room_state.ts"
import type {Goal} from "../../wire/page/runs.generated.ts"

export interface RunFacts {
  /// Seconds.
  readonly length: number
  /// Metres.
  readonly way: number
  readonly goals: readonly Goal[]
}

export function factsOf(room: RoomState): RunFacts {
  return {length: room.frame?.time ?? 0, way: lengthOf(room.trail), goals: goalsOf(room)}
}

function lengthOf(trail: Trail): number {
  let length = 0
  for (const piece of trail)
    for (let i = 1; i < piece.length; i += 1) {
      const [a, b] = [piece[i - 1], piece[i]]
      if (a !== undefined && b !== undefined) length += Math.hypot(b.x - a.x, b.y - a.y)
    }
  return length
}

/// Points of a path in a picture; a longer path has fewer of its own.
const mostPoints = 400

/// The path with so many points that a small picture of it looks the same.
export function picturePath(trail: Trail): readonly (readonly [number, number])[] {
  const points = trail.flat()
  const every = Math.ceil(points.length / mostPoints)
  return points.filter((_, i) => i % every === 0 || i === points.length - 1).map(({x, y}) => [x, y] as const)
}
