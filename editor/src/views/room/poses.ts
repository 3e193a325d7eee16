/// Poses: interpolation between frames, and the current poses of movable objects. No I/O.

import type {World} from "../../worlds/world.ts"

export interface Pose {
  readonly x: number
  readonly y: number
  readonly theta: number
}

/// A pose and when it arrived, in milliseconds.
export interface TimedPose {
  readonly pose: Pose
  readonly at: number
}

/// A frame, as far as motion needs it.
interface RunFrame extends Pose {
  readonly run: number
}

/// Frames further apart than this are jumps (a reset, a teleport, a tab in the background), not motion. In metres.
const jump = 0.5

/// Draws one frame behind: from the frame before to the last one, over the time that lay between them.
export function poseAt(before: TimedPose | null, last: TimedPose, now: number): Pose {
  if (before === null) return last.pose
  const gap = last.at - before.at
  if (gap <= 0 || gap > 200) return last.pose
  if (Math.hypot(last.pose.x - before.pose.x, last.pose.y - before.pose.y) > jump) return last.pose
  const part = Math.min(1, Math.max(0, (now - last.at) / gap))
  const mix = (a: number, b: number) => a + (b - a) * part
  return {
    x: mix(before.pose.x, last.pose.x),
    y: mix(before.pose.y, last.pose.y),
    theta: before.pose.theta + normalizeAngle(last.pose.theta - before.pose.theta) * part,
  }
}

/// The robot's pose between the last two frames.
export class RobotMotion {
  private before: TimedPose | null = null
  private last: TimedPose | null = null
  private frame: RunFrame | null = null

  /// Where the robot is at a time, ms; `null` without a frame. A frame of another run, or one that is looked back at, is a jump.
  poseAt(frame: RunFrame | null, isLive: boolean, now: number): Pose | null {
    if (frame !== this.frame) {
      const follows = frame !== null && this.frame !== null && frame.run === this.frame.run
      this.before = follows && isLive ? this.last : null
      this.last = frame === null ? null : {pose: frame, at: now}
      this.frame = frame
    }
    return this.last === null ? null : poseAt(this.before, this.last, now)
  }

  /// Whether it is still on its way to the last frame.
  isMoving(now: number): boolean {
    const {before, last} = this
    return last !== null && before !== null && now - last.at < last.at - before.at
  }
}

/// An angle brought to (-π, π].
export function normalizeAngle(angle: number): number {
  const full = 2 * Math.PI
  const turned = ((angle % full) + full) % full
  return turned > Math.PI ? turned - full : turned
}

export interface MovableObject extends Pose {
  readonly kind: "box" | "drum"
  /// How far a point is from it, m: 0 on it.
  gap(x: number, y: number): number
}

export type Moved = readonly (readonly [number, number, number])[]

export function movableObjectsOf(world: World, moved: Moved): readonly MovableObject[] {
  const boxes = world.boxes.filter(b => b.movable)
  const rounds = world.rounds.filter(r => r.movable)
  return [
    ...boxes.map((box, i): MovableObject => {
      const [x, y, theta] = moved[i] ?? [box.x, box.y, box.theta]
      const gap = (px: number, py: number) => {
        const [c, s] = [Math.cos(theta), Math.sin(theta)]
        const u = Math.abs(c * (px - x) + s * (py - y)) - box.w / 2
        const v = Math.abs(c * (py - y) - s * (px - x)) - box.h / 2
        return Math.hypot(Math.max(0, u), Math.max(0, v))
      }
      return {kind: "box", x, y, theta, gap}
    }),
    ...rounds.map((round, i): MovableObject => {
      const [x, y, theta] = moved[boxes.length + i] ?? [round.x, round.y, 0]
      return {kind: "drum", x, y, theta, gap: (px, py) => Math.max(0, Math.hypot(px - x, py - y) - round.r)}
    }),
  ]
}

/// The number of the thing within reach (m) of a point that is nearest to it.
export function objectAt(
  things: readonly MovableObject[],
  x: number,
  y: number,
  reach: number,
): number | null {
  const gaps = things.map(thing => thing.gap(x, y))
  const least = Math.min(...gaps)
  return least <= reach ? gaps.indexOf(least) : null
}
