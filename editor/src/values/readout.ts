/// Readout of the displayed moment as text, for screen readers and tests. Pure.

import type {PageState} from "../state/page_state.ts"
import {isOn, numberAt, speedOf} from "../state/runs/channels.ts"
import {ledNames, shownFrame} from "../state/runs/room_state.ts"

/// What a screen reader and a test can read of the robot; before a run it stands at the start.
export function readout(state: PageState): {readonly [key: string]: string} | null {
  const {world} = state.room
  const frame = shownFrame(state.room)
  const pose = frame ?? world?.start
  if (pose === undefined) return null
  const led = (value: number) => ledNames[value] ?? "Black"
  const degrees = Math.round((pose.theta * 180) / Math.PI)
  const sides = (channel: string, names: readonly string[]) =>
    names.filter((_, place) => isOn(frame, channel, place)).join(" ")
  return {
    time: (frame?.time ?? 0).toFixed(2),
    x: pose.x.toFixed(3),
    y: pose.y.toFixed(3),
    heading: `${((degrees % 360) + 360) % 360}°`,
    speed: speedOf(frame).toFixed(3),
    bumpers: sides("Bumper", ["left", "centre", "right"]),
    cliffs: sides("Cliff", ["left", "centre", "right"]),
    wheels: sides("Wheel", ["left", "right"]),
    led1: led(numberAt(frame, "Led1")),
    led2: led(numberAt(frame, "Led2")),
  }
}
