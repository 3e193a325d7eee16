import {expect, it} from "vitest"
import {scrolls} from "../../src/views/diagram/drawing/connection_drag.ts"

const long = {scrollHeight: 900, clientHeight: 400}
const short = {scrollHeight: 400, clientHeight: 400}

it.each([
  [{x: 8, y: 0}, long, false],
  // A finger that goes to an actuator further down.
  [{x: 6, y: 8}, long, false],
  [{x: -6, y: -8}, long, false],
  [{x: 1, y: 8}, long, true],
  [{x: 0, y: -8}, long, true],
  // There is nothing to scroll.
  [{x: 0, y: 8}, short, false],
])("a finger that moves by %o in a palette of %o scrolls it: %s", (by, palette, isScroll) => {
  expect(scrolls(by, palette)).toBe(isScroll)
})
