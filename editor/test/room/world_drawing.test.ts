/// Drawing of the static world: what no scan has seen is hatched, and is no block.

import {expect, test} from "vitest"
import {paletteOf} from "../../src/views/room/palette.ts"
import {drawObjects, drawWorld} from "../../src/views/room/world_drawing.ts"
import type {World} from "../../src/worlds/world.ts"
import {readWorld} from "../../src/worlds/world_decoder.ts"

/// A context that records its calls.
function recorder() {
  const calls: (readonly [string, ...unknown[]])[] = []
  const context = new Proxy({} as Record<string, unknown>, {
    get: (fields, name: string) =>
      name in fields ? fields[name] : (...values: unknown[]) => void calls.push([name, ...values]),
  })
  return {calls, context: context as unknown as CanvasRenderingContext2D}
}

function roomWith(...boxes: readonly object[]): World {
  const read = readWorld({size: [4, 2], start: {x: 1, y: 1}, boxes})
  if (read.kind === "fault") throw new Error(read.fault.why)
  return read.world
}

test("an unknown area is a clipped hatching, turned as it lies, and is not drawn as a block", () => {
  const palette = paletteOf(name => name)
  const {calls, context} = recorder()
  drawWorld(context, roomWith({x: 3, y: 1, w: 1, h: 0.5, theta: Math.PI / 2, unknown: true}), palette, 100)
  const names = calls.map(([name]) => name)
  const clip = names.indexOf("clip")
  expect(clip).toBeGreaterThan(0)
  const corners = calls
    .slice(clip - 6, clip - 2)
    .map(([, x, y]) => [Number(x).toFixed(2), Number(y).toFixed(2)])
  expect(corners.sort()).toEqual([
    ["2.75", "0.50"],
    ["2.75", "1.50"],
    ["3.25", "0.50"],
    ["3.25", "1.50"],
  ])
  expect(names.slice(clip).filter(name => name === "lineTo").length).toBeGreaterThan(20)
  expect(names).not.toContain("roundRect")
  const plain = recorder()
  drawWorld(plain.context, roomWith({x: 3, y: 1, w: 1, h: 0.5}), palette, 100)
  expect(plain.calls.map(([name]) => name)).not.toContain("clip")
  expect(plain.calls.map(([name]) => name)).toContain("roundRect")
  const moved = recorder()
  drawObjects(moved.context, roomWith({x: 3, y: 1, w: 1, h: 0.5, unknown: true}), [], palette, 100)
  expect(moved.calls).toEqual([])
})
