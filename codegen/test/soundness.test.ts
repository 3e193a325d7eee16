/// Everything that fits compiles: random programs, built only by moves that the checker allows, are accepted by GHC.
///
/// Needs the built library; `./rosy test` builds it first. A longer run: `npm run soundness -w codegen -- 20000`.

import {expect, test} from "vitest"
import {packageDatabase} from "../scripts/ghc.ts"
import {soundness} from "./soundness.ts"

const database = packageDatabase()

test.skipIf(database === undefined)("what fits compiles", {timeout: 180_000}, () => {
  const {programs, whole, refused} = soundness(database ?? "", 0, 200)
  expect(refused).toEqual([])
  expect(programs).toBe(200)
  // Most programs must be finished ones, or the test would show nothing.
  expect(whole).toBeGreaterThan(60)
})
