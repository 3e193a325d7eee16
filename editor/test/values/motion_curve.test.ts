/// Speed and position on one time axis: the position is that of the program, and the speed is its rate of change.

import {expect, it} from "vitest"
import {emptyRecording, record} from "../../src/state/runs/recording.ts"
import {motionCurve} from "../../src/values/motion_curve.ts"
import {frame} from "../state/event_player.ts"

/// A frame of a robot that began at (1, 2) with the heading 90°.
function at(time: number, y: number, speed: number, theta = Math.PI / 2) {
  const event = frame(1, {time, x: 1, y, theta, channels: {Velocity: [speed, 0]}})
  if (event.kind !== "heard" || event.message.op !== "frame") throw new Error("no frame")
  return event.message.frame
}
const recording = [at(0, 2, 0), at(1, 2.2, 0.4), at(2, 2.6, 0.4, -Math.PI / 2)].reduce(record, emptyRecording)

it("measures the position ahead of the start, and a turned robot goes back", () => {
  const curve = motionCurve(recording, null)
  expect(curve?.points.map(({position}) => +position.toFixed(6))).toEqual([0, 0.2, 0.6])
  expect(curve?.points.map(({rate}) => +rate.toFixed(6))).toEqual([0, 0.4, -0.4])
})

it("has the displayed moment, and all of the run", () => {
  const curve = motionCurve(recording, 1.5)
  expect([curve?.from, curve?.to, curve?.now.time]).toEqual([0, 2, 1])
})

it("is nothing before a run", () => {
  expect(motionCurve(emptyRecording, null)).toBeNull()
})
