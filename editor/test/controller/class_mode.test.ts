/// Start of class mode with its two conditions in both orders.

import {describe, expect, test} from "vitest"
import {type ClassMode, openClassMode} from "../../src/controller/class_mode.ts"

type Step = keyof ClassMode

/// How often class mode was opened after each step.
function opened(...steps: readonly Step[]): readonly number[] {
  let times = 0
  const mode = openClassMode(() => {
    times += 1
  })
  return steps.map(step => {
    mode[step]()
    return times
  })
}

describe("class mode", () => {
  test("opens when the first program is open, if the class was announced before", () => {
    expect(opened("announced", "programOpened")).toEqual([0, 1])
  })
  test("opens when the class is announced, if the first program was open before", () => {
    expect(opened("programOpened", "announced")).toEqual([0, 1])
  })
  test("opens once, also when the connection is lost and comes back", () => {
    expect(opened("announced", "announced", "programOpened", "announced")).toEqual([0, 0, 1, 1])
  })
})
