/// Where a dropped definition comes to lie.

import fc from "fast-check"
import {expect, test} from "vitest"
import {type Box, nearestFreePlace, shiftIntoView} from "../../src/views/blocks/dragging/free_place.ts"

const box = (left: number, top: number, width: number, height: number): Box => ({
  left,
  right: left + width,
  top,
  bottom: top + height,
})
const anyBox = fc
  .tuple(fc.nat(800), fc.nat(800), fc.integer({min: 1, max: 300}), fc.integer({min: 1, max: 200}))
  .map(([x, y, width, height]) => box(x, y, width, height))
const overlap = (a: Box, b: Box) =>
  a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom

test("a free place is kept", () => {
  expect(nearestFreePlace(box(0, 0, 100, 50), [box(0, 50, 100, 50)])).toEqual({right: 0, down: 0})
})

test("it comes below what it would cover, 20 units away, if that is the shortest way", () => {
  expect(nearestFreePlace(box(10, 40, 100, 50), [box(0, 0, 200, 60)])).toEqual({right: 0, down: 40})
})

test("it comes beside a tall one", () => {
  expect(nearestFreePlace(box(80, 200, 100, 50), [box(0, 0, 100, 600)])).toEqual({right: 40, down: 0})
})

test.each([
  ["seen whole", 0, 500, 0],
  ["cut off at the right", 420, 500, -32],
  ["out of sight at the left", -300, 500, 312],
  ["wider than the view", 90, 50, -78],
])("a block that is %s comes into view from the side", (_, left, seen, aside) => {
  expect(shiftIntoView({left, right: left + 100}, {left: 0, right: seen})).toBe(aside)
})

test("nothing is ever covered", () => {
  fc.assert(
    fc.property(anyBox, fc.array(anyBox, {maxLength: 12}), (dropped, others) => {
      const {right, down} = nearestFreePlace(dropped, others)
      const now = box(
        dropped.left + right,
        dropped.top + down,
        dropped.right - dropped.left,
        dropped.bottom - dropped.top,
      )
      expect(others.filter(other => overlap(now, other))).toEqual([])
    }),
  )
})
