/// Ink: where the pen draws, in which colour and width, and what of it there was at an earlier time.

import {describe, expect, it} from "vitest"
import {extendInk, type Ink, type InkFrame, inkUntil} from "../../src/state/runs/ink.ts"

/// A frame `x` metres along a straight line, at 0.2 m/s.
const at = (x: number, pen: number, color = 0, width = 0.03): InkFrame => ({
  x,
  y: 1,
  time: x / 0.2,
  channels: {Pen: [pen], PenColor: [color], PenWidth: [width]},
})

function drawn(frames: readonly InkFrame[]): Ink {
  return frames.reduce<{ink: Ink; before: InkFrame | null}>(
    ({ink, before}, frame) => ({ink: extendInk(ink, before, frame), before: frame}),
    {ink: [], before: null},
  ).ink
}

const ends = (ink: Ink) => ink.map(({points}) => [points[0]?.x, points.at(-1)?.x])

describe("the ink", () => {
  it("begins where the pen is lowered and ends where it is raised", () => {
    const ink = drawn([at(0, 0), at(0.1, 0), at(0.2, 1), at(0.3, 1), at(0.4, 0), at(0.5, 1)])
    expect(ends(ink)).toEqual([
      [0.1, 0.3],
      [0.4, 0.5],
    ])
  })

  it("goes on in another colour and another width without a gap", () => {
    const ink = drawn([at(0, 1), at(0.1, 1), at(0.105, 1), at(0.2, 1, 1), at(0.3, 1, 1, 0.05)])
    expect(ends(ink)).toEqual([
      [0, 0.1],
      [0.1, 0.2],
      [0.2, 0.3],
    ])
    expect(ink.map(({color, width}) => [color, width])).toEqual([
      [0, 0.03],
      [1, 0.03],
      [1, 0.05],
    ])
  })

  it("is a dot where the robot stands", () => {
    expect(ends(drawn([at(0.1, 1), at(0.1, 1)]))).toEqual([[0.1, 0.1]])
  })

  it("has no line to where a hand has put the robot", () => {
    const put = {...at(3, 1), time: 0.52}
    expect(ends(drawn([at(0, 1), at(0.1, 1), put]))).toEqual([
      [0, 0.1],
      [3, 3],
    ])
  })

  it("keeps a long line in one piece", () => {
    const ink = drawn(Array.from({length: 500}, (_, i) => at(i * 0.02, 1)))
    expect(ink.length).toBeGreaterThan(1)
    ink.slice(1).forEach((stroke, i) => {
      expect(stroke.points[0]).toEqual(ink[i]?.points.at(-1))
    })
  })

  it("is at most half a metre wide, and never too thin to be seen", () => {
    const widths = [9, 0, -1].map(width => drawn([at(0, 1, 0, width)])[0]?.width)
    expect(widths).toEqual([0.5, 0.002, 0.002])
  })

  it("is at an earlier time what there was of it", () => {
    const ink = drawn([at(0, 1), at(0.1, 1), at(0.2, 1), at(0.3, 1, 1), at(0.4, 0)])
    expect(ends(inkUntil(ink, 0.5))).toEqual([[0, 0.1]])
    expect(inkUntil(ink, 9)).toEqual(ink)
  })
})
