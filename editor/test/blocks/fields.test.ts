import {describe, expect, test} from "vitest"
import {haskellNumber, TextField} from "../../src/views/blocks/construction/text_fields.ts"

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

test.each(["0x1F", "0o17", "0b1010", "1_000_000", "6.022_140e23", "007", "-007"])(
  "a number shows the literal %s of the program as it stands there",
  literal => {
    const ignore = () => {}
    const actions = {
      numbers: () => ({}) as never,
      changed: ignore,
      renamed: ignore,
      pressed: ignore,
      pulled: ignore,
    }
    const field = new TextField("value", "0", "number", "number", actions as never)
    field.setValue(literal)
    expect(field.getValue()).toBe(literal)
    field.setValue("wall")
    expect(field.getValue()).toBe(literal)
  },
)
