/// The values of a run, as numbers, as a list and as a table.

import fc from "fast-check"
import {describe, expect, it} from "vitest"
import {openCurves, windowOf} from "../../src/page/panels/chart_data.ts"
import type {Frame} from "../../src/state/messages/messages.ts"
import {speedOf} from "../../src/state/runs/channels.ts"
import {emptyRecording, record} from "../../src/state/runs/recording.ts"
import {namedMemory, numberIn, quantities, quantitiesOf, toCsv} from "../../src/values/quantities.ts"
import type {MemoryValue} from "../../src/wire/link_messages.generated.ts"

const parked: Frame = {
  run: 1,
  step: 0,
  time: 0,
  x: 0,
  y: 0,
  theta: 0,
  channels: {Velocity: [0, 0]},
  fired: [],
  sensed: [],
  boxes: null,
  ghost: null,
  memory: null,
}
const recorded = (frames: readonly Frame[]) => frames.reduce(record, emptyRecording)
const at = (step: number, more: Partial<Frame> = {}): Frame => ({...parked, step, time: step * 0.02, ...more})

describe("a remembered value", () => {
  it("is a number when Haskell writes one, and a truth is 1 or 0", () => {
    expect(["3", "-2.5", "1.0e-2", "True", "False"].map(numberIn)).toEqual([3, -2.5, 0.01, 1, 0])
    expect(["Just 3", "[1,2]", "", "Infinity", "0x10", "_", "3 "].map(numberIn)).toEqual(Array(7).fill(null))
  })

  it("has a name of its own, even when two tasks remember the same type", () => {
    const memory = ["Memory Int", "Memory Bool", "Memory Int"].map(type => ({type, value: "0"}))
    expect(namedMemory(memory).map(r => r.name)).toEqual(["Memory Int", "Memory Bool", "Memory Int (2)"])
  })

  it("can be drawn when it is a number, also from before it was one", () => {
    const memory = (value: string): readonly MemoryValue[] => [
      {type: "Memory Int", value},
      {type: "Memory [Int]", value: "[1]"},
    ]
    const last = at(3, {memory: memory("7")})
    const drawn = quantitiesOf(last).slice(quantities.length)
    expect(drawn.map(q => q.name)).toEqual(["Memory Int"])
    expect([at(1), at(2, {memory: memory("5")}), last].map(f => drawn[0]?.of(f))).toEqual([null, 5, 7])
  })
})

describe("the table of a run", () => {
  it("has a column for each value, and a negative number stays one", () => {
    const frames = [
      at(0),
      at(1, {
        x: -1,
        channels: {Velocity: [0, 0], Bumper: [1, 0, 0], Button: [0, 1, 0], Led1: [3]},
        memory: [{type: "Memory [Int]", value: "[1,2]"}],
      }),
    ]
    const [header = [], ...rows] = toCsv(recorded(frames))
      .trimEnd()
      .split("\r\n")
      .map(row => row.slice(1, -1).split('","'))
    expect(header).toEqual(["time", ...quantities.map(q => q.key), "led1", "led2", "Memory [Int]"])
    const cell = (row: readonly string[] | undefined, name: string) => row?.[header.indexOf(name)]
    const names = ["time", "x", "bumperLeft", "bumperRight", "button1", "led1", "led2", "Memory [Int]"]
    expect(names.map(name => cell(rows[0], name))).toEqual(["0.00", "0", "0", "0", "0", "Black", "Black", ""])
    expect(names.map(name => cell(rows[1], name))).toEqual([
      "0.02",
      "-1",
      "1",
      "0",
      "1",
      "Red",
      "Black",
      "[1,2]",
    ])
  })

  it("computes no memory of a program", () => {
    const memory = [{type: "Memory String", value: "=1+1"}]
    expect(toCsv(recorded([at(0, {memory})]))).toContain(`"'=1+1"`)
  })
})

describe("a curve", () => {
  const speed = quantities[0]
  if (speed === undefined) throw new Error("expected a first quantity, found none")
  const wave = (steps: number) =>
    recorded(Array.from({length: steps}, (_, i) => at(i, {channels: {Velocity: [Math.sin(i / 37), 0]}})))

  it("has the run's highest and lowest however long the run, in few points, in order of time", () => {
    fc.assert(
      fc.property(fc.integer({min: 300, max: 20_000}), steps => {
        const run = wave(steps)
        const curve = openCurves().of(run, speed, windowOf(run, null, "all"))
        const values = run.pieces.flat().map(speedOf)
        expect(curve.high).toBe(Math.max(0, ...values))
        expect(curve.low).toBe(Math.min(0, ...values))
        expect(curve.points.length).toBeLessThanOrEqual(1300)
        expect(curve.points.every((p, i) => i === 0 || p.time >= (curve.points[i - 1]?.time ?? 0))).toBe(true)
      }),
      {numRuns: 15},
    )
  })

  it("tells the value of the frame before a time", () => {
    const run = wave(100)
    const curve = openCurves().of(run, speed, windowOf(run, null, 20))
    expect(curve.at(0.99)).toBe(Math.sin(49 / 37))
    expect(curve.at(-5)).toBeNull()
  })

  it("shows the window that ends now, or the one around the time that is looked at", () => {
    const run = wave(5000)
    expect(windowOf(run, null, 20)).toEqual({from: 79.98, to: 99.98})
    expect(windowOf(run, 30, 20)).toEqual({from: 20, to: 40})
    expect(windowOf(run, 1, 60)).toEqual({from: 0, to: 60})
    expect(windowOf(run, 30, "all")).toEqual({from: 0, to: 99.98})
  })
})
