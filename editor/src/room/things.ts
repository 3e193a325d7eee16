/// The things that can be pushed, where they are now: movable boxes, then movable rounds, numbered as in a frame
/// (protocol §4). Pure.

import type {World} from "../worlds/world.ts"
import type {Pose} from "./motion.ts"

export interface Thing extends Pose {
  readonly kind: "box" | "drum"
  /// How far a point is from it, m: 0 on it.
  gap(x: number, y: number): number
}

export type Moved = readonly (readonly [number, number, number])[]

export function thingsOf(world: World, moved: Moved): readonly Thing[] {
  const boxes = world.boxes.filter(b => b.movable)
  const rounds = world.rounds.filter(r => r.movable)
  return [
    ...boxes.map((box, i): Thing => {
      const [x, y, theta] = moved[i] ?? [box.x, box.y, box.theta]
      const gap = (px: number, py: number) => {
        const [c, s] = [Math.cos(theta), Math.sin(theta)]
        const u = Math.abs(c * (px - x) + s * (py - y)) - box.w / 2
        const v = Math.abs(c * (py - y) - s * (px - x)) - box.h / 2
        return Math.hypot(Math.max(0, u), Math.max(0, v))
      }
      return {kind: "box", x, y, theta, gap}
    }),
    ...rounds.map((round, i): Thing => {
      const [x, y, theta] = moved[boxes.length + i] ?? [round.x, round.y, 0]
      return {kind: "drum", x, y, theta, gap: (px, py) => Math.max(0, Math.hypot(px - x, py - y) - round.r)}
    }),
  ]
}

/// The number of the thing within reach (m) of a point that is nearest to it.
export function thingAt(things: readonly Thing[], x: number, y: number, reach: number): number | null {
  const gaps = things.map(thing => thing.gap(x, y))
  const least = Math.min(...gaps)
  return least <= reach ? gaps.indexOf(least) : null
}
