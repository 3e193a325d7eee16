/// Turns of the stories: each file that takes turns is played on one of nineteen days, nightly, and while it has changed.

import {readdirSync, readFileSync} from "node:fs"
import {expect} from "@playwright/test"
import {test} from "./story.ts"
import {isPlayed, isPlayedEveryFourth, turns} from "./turns.ts"

const folder = new URL(".", import.meta.url)
const takesTurns = (name: string) => readFileSync(new URL(name, folder), "utf8").includes("= inTurn(")

/// The names of all files of stories that take turns.
const names = readdirSync(folder)
  .filter(name => name.endsWith(".spec.ts") && name !== "turns.spec.ts" && takesTurns(name))
  .map(name => name.replace(".spec.ts", ""))
  .sort()

const ordinary = {isFull: false, seed: 0, changed: []}

test("nineteen days play every file that takes turns once, whichever day is first", () => {
  expect(turns.length).toBe(19)
  expect(turns.flat().sort()).toEqual(names)
  for (const first of [0, 20_783, 20_784, 20_785, 20_789])
    for (const name of names)
      expect(turns.filter((_, day) => isPlayed(name, {...ordinary, seed: first + day})).length).toBe(1)
})

test("nightly plays every file, and so does a day after a change of it", () => {
  for (const name of names) {
    expect(isPlayed(name, {...ordinary, isFull: true})).toBe(true)
    const days = turns.map((_, seed) => ({...ordinary, seed}))
    const changed = ["README.md", `e2e-tests/stories/${name}.spec.ts`]
    expect(days.filter(day => isPlayed(name, {...day, changed})).length).toBe(turns.length)
  }
})

test("what is played every fourth day is missing on three of four days at most, and never after a change of the page or of the service", () => {
  for (const name of names)
    for (const fourth of [0, 1, 2, 3] as const) {
      for (const seed of [0, 1, 18, 19, 20_785])
        expect([0, 1, 2, 3].some(n => isPlayedEveryFourth(fourth, name, {...ordinary, seed: seed + n}))).toBe(
          true,
        )
      const otherDay = {...ordinary, seed: fourth === 0 ? 1 : 0}
      for (const source of ["editor/src/index.ts", "codegen/src/index.ts", "sim-service/rosy_sim/config.py"])
        expect(isPlayedEveryFourth(fourth, name, {...otherDay, changed: [source]})).toBe(true)
      expect(isPlayedEveryFourth(fourth, name, {...otherDay, isFull: true})).toBe(true)
      expect(isPlayedEveryFourth(fourth, name, otherDay)).toBe(isPlayed(name, otherDay))
    }
})
