/// Whose inputs are being written.

import {describe, expect, it} from "vitest"
import {callAt, inputsOf} from "../../src/source/call_at_cursor.ts"

describe("at the end of", () => {
  it.each([
    ["move = Velocity ", "Velocity", 0],
    ["move = Velocity 0.5 ", "Velocity", 1],
    ["move = Velocity 0.5 0", "Velocity", 1],
    ["move = Velocity (v + 0.5) ", "Velocity", 1],
    ["move = f (g 1 ", "g", 1],
    ["move = f (g 1) ", "f", 1],
    ["move = map show $ filter ", "filter", 0],
    ["main = do\n  drive 1 2\n  turn ", "turn", 0],
    ["xs = [Velocity 1 2, Velocity ", "Velocity", 0],
    ["x = task start (run speed ", "run", 1],
    ["x = drive\n  speed ", "drive", 1],
    ['x = say "a b" ', "say", 1],
    ["x = f -- g\n  1 ", "f", 1],
  ])("%j it is %s's input %i", (before, name, argument) => {
    expect(callAt(before)).toEqual({name, argument})
  })

  it.each([["move = "], ["move = Velo"], ["move = 1 "], ["x = (+) "], [""]])(
    "%j it is in no call",
    before => {
      expect(callAt(before)).toBeNull()
    },
  )
})

describe("a type", () => {
  it.each([
    ["Double -> Double -> Velocity", ["Double", "Double", "Velocity"]],
    ["(a -> b) -> [a] -> [b]", ["(a -> b)", "[a]", "[b]"]],
    ["(Eq a, Show a) => a -> String", ["a", "String"]],
    ["Velocity", ["Velocity"]],
  ])("%j has its inputs", (type, parts) => {
    expect(inputsOf(type)).toEqual(parts)
  })
})
