/// Where a new line of Haskell begins.

import {describe, expect, it} from "vitest"
import {indentAfter} from "../../src/source/layout.ts"
import {movedRange} from "../../src/state/program.ts"

describe("a new line", () => {
  it.each([
    ["play (Bumper _ Pressed) =", 2],
    ["  case mode of", 4],
    ["main = do -- drive", 2],
    ["  | hit = Velocity 0 0", 2],
    ["  where", 4],
    ["redo x", 0],
    ["", 0],
  ])("after %j stands at column %i", (before, column) => {
    expect(indentAfter(before)).toBe(column)
  })
})

describe("a marked place", () => {
  it("moves with the text around it and shrinks with what it lost", () => {
    expect(movedRange("ab cd ef", "x ab cd ef", {start: 3, end: 5})).toEqual({start: 5, end: 7})
    expect(movedRange("ab cd ef", "ab cd efg", {start: 3, end: 5})).toEqual({start: 3, end: 5})
    expect(movedRange("ab cd ef", "ab ef", {start: 3, end: 5}).end).toBeLessThanOrEqual(5)
  })
})
