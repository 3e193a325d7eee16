/// What the trail tells.

import fc from "fast-check"
import {describe, expect, it} from "vitest"
import {extendTrail, type Point, type Trail} from "../../src/state/runs/room_state.ts"
import {
  levels,
  segmentsOf,
  speedLevel,
  timeLevel,
  timeMarks,
  timeSpan,
  trailUntil,
} from "../../src/views/room/trail_segments.ts"

const drive = (steps: number, speed = 0.5): Trail => {
  let trail: Trail = []
  for (let i = 0; i < steps; i += 1)
    trail = extendTrail(trail, {x: i * 0.02 * speed, y: 0, time: i * 0.02, speed})
  return trail
}

describe("levels of the trail", () => {
  it("rise with the speed and with the time, and stay within their number", () => {
    const number = fc.double({min: 0, max: 2000, noNaN: true})
    fc.assert(
      fc.property(number, number, (a, b) => {
        const [low, high] = [Math.min(a, b), Math.max(a, b)]
        expect(speedLevel(low / 1000)).toBeLessThanOrEqual(speedLevel(high / 1000))
        const span = timeSpan(high)
        expect(timeLevel(low, span)).toBeLessThanOrEqual(timeLevel(high, span))
        expect(timeLevel(high, span)).toBeLessThan(levels)
        // The newest stretch is always among the strongest colours.
        if (high > 5) expect(timeLevel(high, span)).toBeGreaterThanOrEqual(levels - 2)
      }),
    )
    expect(speedLevel(0)).toBe(0)
    expect(speedLevel(0.7)).toBe(levels - 1)
  })
})

describe("stretches of a piece", () => {
  const piece = fc.array(
    fc.record({
      x: fc.double({min: 0, max: 5, noNaN: true}),
      y: fc.constant(0),
      time: fc.constant(0),
      speed: fc.double({min: 0, max: 0.7, noNaN: true}),
    }),
    {minLength: 2, maxLength: 60},
  )

  it("hang together from the first point to the last", () => {
    fc.assert(
      fc.property(piece, fc.double({min: 0, max: 0.5, noNaN: true}), (points, apart) => {
        const found = segmentsOf(points, p => speedLevel(p.speed), apart)
        expect(found[0]?.points[0]).toBe(points[0])
        expect(found.at(-1)?.points.at(-1)).toBe(points.at(-1))
        for (const [i, stretch] of found.entries())
          if (i > 0) expect(stretch.points[0]).toBe(found[i - 1]?.points.at(-1))
      }),
    )
  })

  it("leave out what would be one point on the screen", () => {
    const points: Point[] = Array.from({length: 101}, (_, i) => ({x: i * 0.01, y: 0, time: i, speed: 0.5}))
    expect(segmentsOf(points, () => 0, 0.1)[0]?.points.length).toBeLessThan(14)
  })
})

describe("marks of time", () => {
  it("stand at round times where the robot was then, and never become a crowd", () => {
    fc.assert(
      fc.property(fc.integer({min: 100, max: 20_000}), steps => {
        const trail = drive(steps)
        const now = (steps - 1) * 0.02
        const marks = timeMarks(trail, now, 0.05)
        expect(marks.length).toBeLessThanOrEqual(10)
        if (now > 2) expect(marks.length).toBeGreaterThan(0)
        for (const mark of marks) {
          expect(mark.time).toBe(Math.round(mark.time))
          expect(mark.x).toBeCloseTo(mark.time * 0.5, 1)
        }
      }),
      {numRuns: 40},
    )
  })

  it("know nothing of later than the time that is looked at", () => {
    const trail = drive(3000)
    expect(timeMarks(trail, 20, 0.05).at(-1)?.time).toBeLessThanOrEqual(20)
    const cut = trailUntil(trail, 20)
    expect(cut.flat().every(p => p.time <= 20)).toBe(true)
    expect(cut[0]).toBe(trail[0])
  })
})
