/// Everything that fits compiles: random programs, built only by moves that the checker allows, are accepted by GHC. And what is
/// refused, GHC refuses too.
///
/// Needs the built library; `./rosy test` builds it first. A longer run: `npm run soundness -w codegen -- 20000`.

import {expect, test} from "vitest"
import {packageDatabase} from "../scripts/ghc.ts"
import {completeness, soundness} from "./soundness.ts"

const database = packageDatabase()

test.skipIf(database === undefined)("what fits compiles", {timeout: 300_000}, () => {
  const {programs, whole, refused} = soundness(database ?? "", 0, 100)
  expect(refused).toEqual([])
  expect(programs).toBe(100)
  // Many programs must be finished ones, or the test would show nothing.
  expect(whole).toBeGreaterThan(30)
})

test.skipIf(database === undefined)("what does not fit does not compile", {timeout: 300_000}, () => {
  const {refusals, needless} = completeness(database ?? "", 300, 40)
  expect(needless).toEqual([])
  expect(refusals).toBeGreaterThan(30)
})
