/// Layered map: compared with a plain map of all entries, for any order and number of lookups.

import fc from "fast-check"
import {expect, test} from "vitest"
import {LayeredMap} from "../src/workspace/inference/layered_map.ts"

const layer = fc.array(fc.tuple(fc.constantFrom(..."abcdefgh"), fc.nat())).map(entries => new Map(entries))

test("a layered map is the map of all entries, the last of a key counts", () => {
  fc.assert(
    fc.property(
      fc.array(layer),
      fc.array(fc.constantFrom(..."abcdefghij")),
      fc.nat(40),
      (layers, keys, repeats) => {
        const whole = new Map(layers.flatMap(entries => [...entries]))
        const layered = new LayeredMap(layers)
        for (let i = 0; i <= repeats; i++)
          for (const key of keys) expect(layered.get(key)).toBe(whole.get(key))
        expect([...layered]).toEqual([...whole])
        expect([...layered.keys()]).toEqual([...whole.keys()])
        expect([...layered.values()]).toEqual([...whole.values()])
        expect(layered.size).toBe(whole.size)
        for (const key of keys)
          expect([layered.has(key), layered.get(key)]).toEqual([whole.has(key), whole.get(key)])
      },
    ),
    {seed: 1},
  )
})
