/// Numbers that are dragged: where one stands in a line, and what a step makes of it.

import fc from "fast-check"
import {describe, expect, it} from "vitest"
import {inText, numberAt, stepOf, withSteps} from "../../src/preview/number_steps.ts"

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
    ["0.5", 0.01],
    ["0.05", 0.001],
    ["0.0", 0.1],
    ["12.5", 0.1],
    ["3", 1],
    ["50", 1],
    ["500", 10],
    ["0", 1],
  ] as const)("of %s is %d", (literal, step) => expect(stepOf(literal)).toBeCloseTo(step, 9))
  it.each([
    ["0.5", 1, "0.51"],
    ["0.5", -60, "-0.1"],
    ["0.5", -50, "0.0"],
    ["-0.25", 10, "-0.15"],
    ["3", -5, "-2"],
    ["50", 7, "57"],
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
