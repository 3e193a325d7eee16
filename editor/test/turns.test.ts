/// Turns of the test files that need a browser: each is run once in seven days, nightly, and while what it tests has changed.

import {readdirSync} from "node:fs"
import {expect, test} from "vitest"
import {dayOf, waiting} from "../../codegen/test/turns.ts"
import {turns} from "./turns.ts"

const files = ["blocks", "source"].flatMap(folder =>
  readdirSync(new URL(`${folder}/`, import.meta.url))
    .filter(name => name.endsWith(".web.test.ts"))
    .map(name => `${folder}/${name.replace(".web.test.ts", "")}`),
)

test.each([0, 20_783, 20_784])("seven days from %s run each file that takes turns once", first => {
  expect(turns.days.flat().filter(name => !files.includes(name))).toEqual([])
  for (const name of turns.days.flat()) {
    const days = turns.days.filter(
      (_, day) => !waiting(turns, {seed: first + day, changed: []}).includes(name),
    )
    expect(days.length, name).toBe(1)
  }
})

test("nothing waits by night, by hand, or after a change of the block view", () => {
  expect(waiting(turns, dayOf({ROSY_TEST_SEED: "1", ROSY_TEST_SHARE: "1"}))).toEqual([])
  expect(waiting(turns, dayOf({}))).toEqual([])
  const day = {ROSY_TEST_SEED: "1", ROSY_TEST_SHARE: "0.1"}
  expect(waiting(turns, dayOf({...day, ROSY_TEST_CHANGED: "README.md"})).length).toBeGreaterThan(3)
  expect(waiting(turns, dayOf({...day, ROSY_TEST_CHANGED: "a\neditor/src/blocks/bin.ts"}))).toEqual([])
})
