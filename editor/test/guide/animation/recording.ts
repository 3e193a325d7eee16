/// Recording of a run for an animation of the guide: `docs/recordings/<name>.json`, which `sim-service/tests/system/test_guide_recordings.py` writes.

import type {Channels} from "../../../src/state/runs/channels.ts"
import type {Pose, World} from "../../../src/worlds/world.ts"
import {readWorld} from "../../../src/worlds/world_decoder.ts"

export interface Recording {
  readonly world: World
  /// s, from the start to the last pose.
  readonly seconds: number
  /// The first one is the start at 0 s.
  readonly poses: readonly TimedPose[]
  /// How the robot is drawn from a time on; the first one from the start.
  readonly looks: readonly {readonly time: number; readonly channels: Channels}[]
}

export interface TimedPose extends Pose {
  readonly time: number
}

export function readRecording(text: string): Recording {
  const {room, poses, looks} = JSON.parse(text) as {
    readonly room: unknown
    readonly poses: readonly (readonly [number, number, number, number])[]
    readonly looks: Recording["looks"]
  }
  const read = readWorld(room)
  if (read.kind === "fault") throw new Error(`the room of a recording is none: ${read.fault.why}`)
  const timed = poses.map(([time, x, y, theta]) => ({time, x, y, theta}))
  return {
    world: read.world,
    seconds: timed.at(-1)?.time ?? 0,
    poses: withoutTurnsBack([{time: 0, ...read.world.start}, ...timed]),
    looks,
  }
}

/// Angles that go on from one pose to the next, beyond half a turn: π and -π are one direction.
function withoutTurnsBack(poses: readonly TimedPose[]): readonly TimedPose[] {
  let theta = poses[0]?.theta ?? 0
  return poses.map(pose => {
    const turned = pose.theta - theta
    theta += turned - 2 * Math.PI * Math.round(turned / (2 * Math.PI))
    return {...pose, theta}
  })
}
