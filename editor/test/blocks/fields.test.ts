import {describe, expect, test} from "vitest"
import {haskellNumber} from "../../src/blocks/construction/text_fields.ts"

describe("what is typed into a number", () => {
  test.each([
    ["0.5", "0.5"],
    [" 2 ", "2"],
    [".5", "0.5"],
    ["-.5", "-0.5"],
    ["5.", "5"],
    ["0,25", "0.25"],
    ["007", "7"],
    ["-0.50", "-0.50"],
    ["1e-3", "1e-3"],
    ["2.e3", "2e3"],
  ])("%j becomes the literal %s", (typed, literal) => expect(haskellNumber(typed)).toBe(literal))

  test.each(["", "-", ".", "x", "1.2.3", "NaN", "Infinity", "0x10", "1 2"])("%j is refused", typed =>
    expect(haskellNumber(typed)).toBeNull(),
  )
})
