/// The latest firing of each function at any moment is the one that a search through all firings finds.

import fc from "fast-check"
import {describe, expect, it} from "vitest"
import {addFirings, emptyLog, latestFirings} from "../../src/state/runs/firing_log.ts"
import type {FiringShown} from "../../src/wire/page/explanations.generated.ts"

const firing = (n: number, time: number, name: string): FiringShown => ({
  n,
  time,
  function: name,
  task: 0,
  cause: {by: "tick", value: "", instant: null, event: null, firing: null},
  took: [],
  gave: [],
  branches: [],
})

const steps = fc.array(fc.array(fc.constantFrom("a", "b", "c"), {maxLength: 3}), {maxLength: 700})

describe("the log of firings", () => {
  it("has the latest of each function at every moment", () => {
    fc.assert(
      fc.property(steps, fc.nat(700), (all, at) => {
        const batches = all.map((names, step) => names.map(name => firing(0, step / 50, name)))
        const log = batches.reduce(addFirings, emptyLog)
        const before = batches.flat().filter(f => f.time <= at / 50)
        const wanted = new Map(before.map(f => [f.function, f.time]))
        const found = [...latestFirings(log, at / 50)].map(([name, f]) => [name, f.time])
        expect(Object.fromEntries(found)).toEqual(Object.fromEntries(wanted))
      }),
      {numRuns: 60},
    )
  })

  it("keeps the latest firings of a long run, and says that it is not whole", () => {
    let log = addFirings(emptyLog, [firing(1, 0, "once")])
    for (let n = 2; n < 30_000; n += 1) log = addFirings(log, [firing(n, n / 50, "often")])
    expect(log.pieces.length).toBeLessThan(100)
    expect(log.isWhole).toBe(false)
    expect(latestFirings(log, 599).get("once")?.n).toBe(1)
    expect(latestFirings(log, 599).get("often")?.n).toBe(29_950)
    expect(latestFirings(log, 1).get("often")).toBeUndefined()
  })
})
