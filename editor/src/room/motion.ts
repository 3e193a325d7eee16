/// Smooth motion between frames: the pose to draw now, from the last two frames and when they came. Pure.

export interface Pose {
  readonly x: number
  readonly y: number
  readonly theta: number
}

/// A pose and when it arrived, in milliseconds.
export interface Seen {
  readonly pose: Pose
  readonly at: number
}

/// Frames further apart than this are jumps (a reset, a teleport, a tab in the background), not motion. In metres.
const jump = 0.5

/// Draws one frame behind: from the frame before to the last one, over the time that lay between them.
export function poseAt(before: Seen | null, last: Seen, now: number): Pose {
  if (before === null) return last.pose
  const gap = last.at - before.at
  if (gap <= 0 || gap > 200) return last.pose
  if (Math.hypot(last.pose.x - before.pose.x, last.pose.y - before.pose.y) > jump) return last.pose
  const part = Math.min(1, Math.max(0, (now - last.at) / gap))
  const mix = (a: number, b: number) => a + (b - a) * part
  return {
    x: mix(before.pose.x, last.pose.x),
    y: mix(before.pose.y, last.pose.y),
    theta: before.pose.theta + shortest(last.pose.theta - before.pose.theta) * part,
  }
}

/// An angle brought to (-π, π].
export function shortest(angle: number): number {
  const full = 2 * Math.PI
  const turned = ((angle % full) + full) % full
  return turned > Math.PI ? turned - full : turned
}
