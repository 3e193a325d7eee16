/// What a click in the room asks about: the robot, or a point of its trail. Pure.

import type {Trail} from "../state/room_state.ts"

/// `time` is in seconds of the run; `null` is the displayed moment.
export type QuestionTarget = {readonly kind: "robot"} | {readonly kind: "place"; readonly time: number | null}

interface Spot {
  readonly x: number
  readonly y: number
}

/// The robot's radius, m (see `robot_drawing.ts`).
const radius = 0.18

/// The robot where it is drawn, else the nearest point of the trail within `reach` metres: of points equally near the latest.
export function targetAt(robot: Spot | null, trail: Trail, at: Spot, reach: number): QuestionTarget | null {
  const away = ({x, y}: Spot) => Math.hypot(x - at.x, y - at.y)
  if (robot !== null && away(robot) < Math.max(radius, reach)) return {kind: "robot"}
  let nearest: number | null = null
  let least = reach
  for (const piece of trail)
    for (const point of piece) {
      const distance = away(point)
      if (distance > least) continue
      nearest = point.time
      least = distance
    }
  return nearest === null ? null : {kind: "place", time: nearest}
}
