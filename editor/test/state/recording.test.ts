/// The frames of a run, found again.

import fc from "fast-check"
import {describe, expect, it} from "vitest"
import type {Frame} from "../../src/state/messages/messages.ts"
import {emptyRecording, frameAt, framesBetween, record, spanOfTime} from "../../src/state/runs/recording.ts"

const frame = (step: number): Frame => ({
  run: 1,
  step,
  time: step * 0.02,
  x: step,
  y: 0,
  theta: 0,
  channels: {Velocity: [0, 0], Bumper: [step % 2, 0, 0]},
  fired: [],
  sensed: [],
  boxes: null,
  ghost: null,
  memory: null,
})
const recorded = (steps: number) => {
  let recording = emptyRecording
  for (let i = 0; i < steps; i += 1) recording = record(recording, frame(i))
  return recording
}

describe("a recording", () => {
  it("finds the frame shown at any time", () => {
    fc.assert(
      fc.property(
        fc.integer({min: 1, max: 900}),
        fc.double({min: -1, max: 30, noNaN: true}),
        (steps, time) => {
          const found = frameAt(recorded(steps), time)
          const wanted = Math.min(
            steps - 1,
            Math.max(0, [...Array(steps).keys()].filter(i => i * 0.02 <= time).length - 1),
          )
          expect(found?.step).toBe(wanted)
        },
      ),
      {numRuns: 40},
    )
  })

  it("gives the frames between two times, across its pieces", () => {
    const steps = [...framesBetween(recorded(600), 5, 5.2)].map(f => f.step)
    expect(steps).toEqual([250, 251, 252, 253, 254, 255, 256, 257, 258, 259, 260])
  })

  it("knows nothing when it is empty", () => {
    expect(frameAt(emptyRecording, 1)).toBeNull()
    expect(spanOfTime(emptyRecording)).toBeNull()
  })

  it("forgets the oldest after twenty minutes", () => {
    const long = recorded(61_000)
    expect(long.length).toBeLessThanOrEqual(235 * 256)
    expect(spanOfTime(long)?.from).toBeGreaterThan(0)
    expect(spanOfTime(long)?.to).toBe(60_999 * 0.02)
  })
})
