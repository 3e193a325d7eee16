/// Two fingers on the drawing.

import {expect, test} from "vitest"
import {twoFingers} from "../../src/views/diagram/drawing/pinch_zoom.ts"

const at = (clientX: number, clientY: number) => ({clientX, clientY})

test("two fingers are so far apart, around a place", () => {
  expect(twoFingers([at(10, 20), at(40, 60)])).toEqual({apart: 50, middle: {x: 25, y: 40}})
})

test("two fingers in one place are apart, so that nothing is divided by zero", () => {
  expect(twoFingers([at(10, 20), at(10, 20)])?.apart).toBe(1)
})

test("one finger or three zoom nothing", () => {
  expect(twoFingers([at(10, 20)])).toBeNull()
  expect(twoFingers([at(1, 1), at(2, 2), at(3, 3)])).toBeNull()
})
