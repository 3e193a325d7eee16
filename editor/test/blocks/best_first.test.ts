/// What the search offers first for the chosen place.

import {expect, test} from "vitest"
import {bestFirst} from "../../src/views/blocks/interaction/toolbox_search.ts"

const item = (label: string) => ({label, block: {type: "x"}})

test.each(["1", "-180", "0.5"])(
  "a number that is typed comes before blocks with the number in them: %s",
  number => {
    const typed = [item(number)]
    const found = [item(`drive back for ${number} s`), item(`turn between ${number} and 180`)]
    expect(bestFirst(found, typed, number, () => "here", new Set())[0]?.label).toBe(number)
  },
)

test("an operator is found by its sign", () => {
  expect(bestFirst([item("turn"), item("_ + _")], [], "+", () => "here", new Set())[0]?.label).toBe("_ + _")
})
