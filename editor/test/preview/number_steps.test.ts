/// Numbers that are dragged: where one stands in a line, and what a step makes of it.

import fc from "fast-check"
import {describe, expect, it} from "vitest"
import {inText, numberAt, stepOf, stepsOfWay, withSteps} from "../../src/browser/number_steps.ts"

describe("the number at a place", () => {
  it.each([
    ["move = Velocity 0.5 0", 16, "0.5"],
    ["move = Velocity 0.5 0", 19, "0.5"],
    ["move = Velocity 0.5 0", 21, "0"],
    ["move = Velocity (-0.25) 0", 18, "-0.25"],
    ["drive 50", 7, "50"],
    ["a = x1 + 2", 4, null],
    ["a = x1 + 2", 6, null],
    ["a = 1.5e3", 5, null],
    ["-- 0.5 m/s", 4, null],
    ['say "5 times"', 6, null],
    ["a = b 0.5", 4, null],
  ] as const)("%s, column %i: %s", (line, at, literal) =>
    expect(numberAt(line, at)?.literal ?? null).toBe(literal),
  )
  it("is replaced as a whole, with the parentheses of a negative one", () => {
    const line = "move = Velocity (-0.25) 0"
    const place = numberAt(line, 18)
    expect(line.slice(place?.from, place?.to)).toBe("(-0.25)")
    expect([inText("-0.25"), inText("0.25")]).toEqual(["(-0.25)", "0.25"])
  })
})

describe("a step", () => {
  it.each([
    ["0.5", 0.05],
    ["0.1", 0.05],
    ["0.05", 0.005],
    ["0.0005", 0.001],
    ["0.0", 0.05],
    ["12.5", 0.05],
    ["3", 1],
    ["130", 1],
    ["500", 1],
    ["0", 1],
  ] as const)("of %s is %d", (literal, step) => expect(stepOf(literal)).toBeCloseTo(step, 9))
  it.each([
    ["0.5", 1, "0.55"],
    ["0.5", 2, "0.6"],
    ["0.5", -12, "-0.1"],
    ["0.5", -10, "0.0"],
    ["-0.25", 2, "-0.15"],
    ["0.05", 1, "0.055"],
    ["3", -5, "-2"],
    ["50", 7, "57"],
    ["130", -7, "123"],
  ] as const)("%s and %i steps are %s", (literal, steps, next) =>
    expect(withSteps(literal, steps)).toBe(next),
  )
  it("there and back again is the number it was; a whole number stays whole", () => {
    const decimal = fc.tuple(fc.integer({min: 0, max: 999}), fc.integer({min: 0, max: 99}))
    fc.assert(
      fc.property(decimal, fc.integer({min: -200, max: 200}), ([whole, part], steps) => {
        const literal = `${whole}.${part}`
        const there = Number(withSteps(literal, steps))
        expect(there).toBeCloseTo(Number(literal) + steps * stepOf(literal), 6)
        expect(withSteps(`${whole}`, steps)).toMatch(/^-?\d+$/)
        expect(Number(withSteps(literal, 0))).toBe(Number(literal))
      }),
    )
  })
})

describe("the steps of a way", () => {
  it.each([
    [0, 0],
    [3, 0],
    [4, 1],
    [-30, -7],
    [40, 10],
    [80, 30],
    [200, 210],
  ])("of %i pixels are %i", (pixels, steps) => expect(stepsOfWay(pixels)).toBe(steps))
  it("become larger with the distance, the same to both sides", () => {
    fc.assert(
      fc.property(fc.integer({min: 0, max: 400}), pixels => {
        expect(stepsOfWay(-pixels) + stepsOfWay(pixels)).toBe(0)
        expect(stepsOfWay(pixels + 4) - stepsOfWay(pixels)).toBeGreaterThanOrEqual(1)
      }),
    )
  })
})
