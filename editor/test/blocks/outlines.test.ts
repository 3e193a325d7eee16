import {expect, test} from "vitest"
import {outlines, padding, pen, sides} from "../../src/views/blocks/appearance/outlines.ts"

/// Follows relative `l`, `a`, `h` and `v` commands to where they end.
function end(path: string): {x: number; y: number; most: number} {
  let [x, y, most] = [0, 0, 0]
  for (const [, command, rest] of path.matchAll(/([lahv])([^lahv]*)/g)) {
    const numbers = (rest ?? "")
      .trim()
      .split(/[\s,]+/)
      .map(Number)
    if (command === "h") x += numbers[0]!
    else if (command === "v") y += numbers[0]!
    else {
      x += numbers[numbers.length - 2]!
      y += numbers[numbers.length - 1]!
    }
    most = Math.max(most, Math.abs(x))
  }
  return {x, y, most}
}

test.each(outlines)("each side of a %s comes back to where the other side begins", outline => {
  for (const height of [20, 28, 40, 96]) {
    for (const right of [false, true]) {
      const side = right ? sides[outline].right : sides[outline].left
      for (const up of [false, true]) {
        const {x, y, most} = end(side.path(height, pen(right, up)))
        expect(x).toBeCloseTo(0)
        expect(y).toBeCloseTo(up ? -height : height)
        expect(most).toBeCloseTo(side.width(height))
      }
    }
  }
})

test("both sides of an outline take the same room, because Blockly centres contents between them", () => {
  for (const outline of outlines) {
    for (const height of [20, 40, 96]) {
      expect(sides[outline].left.width(height)).toBe(sides[outline].right.width(height))
    }
  }
})

test("no two families that may stand in one socket have the same outline on both sides", () => {
  const drawn = outlines.map(outline =>
    [sides[outline].left.path(28, pen(false, false)), sides[outline].right.path(28, pen(true, false))].join(),
  )
  expect(new Set(drawn).size).toBe(outlines.length)
})

test("contents keep clear of the slopes of a hexagon", () => {
  expect(padding("hexagon", undefined)).toBeGreaterThan(sides.hexagon.left.width(28))
})
