/// Turns of the test files that take long: each is run once in as many days as its table has, nightly, and while what it tests has changed.

import {existsSync} from "node:fs"
import {expect, test} from "vitest"
import {dayOf, turns, waiting} from "./turns.ts"

test.each([0, 20_783, 20_784])("the days from %s run each file that takes turns once", first => {
  for (const name of turns.days.flat()) {
    expect(existsSync(new URL(`${name}.test.ts`, import.meta.url)), name).toBe(true)
    const days = turns.days.filter(
      (_, day) => !waiting(turns, {seed: first + day, changed: []}).includes(name),
    )
    expect(days.length, name).toBe(1)
  }
})

test("nothing waits by night, by hand, or after a change of what is tested", () => {
  expect(waiting(turns, dayOf({ROSY_TEST_SEED: "1", ROSY_TEST_SHARE: "1"}))).toEqual([])
  expect(waiting(turns, dayOf({}))).toEqual([])
  const day = {ROSY_TEST_SEED: "1", ROSY_TEST_SHARE: "0.1"}
  expect(waiting(turns, dayOf({...day, ROSY_TEST_CHANGED: "README.md"})).length).toBeGreaterThan(3)
  expect(waiting(turns, dayOf({...day, ROSY_TEST_CHANGED: "a\ncodegen/src/index.ts"}))).toEqual([])
})
