/// What the laser scanner has measured, as points of the room's drawing.

import {expect, test} from "vitest"
import {scanPoints} from "../../src/views/room/robot_drawing.ts"

const scan = (...distances: number[]) => ({channels: {Scan: [0, Math.PI / 2, 0.12, 3.5, ...distances]}})

test("each beam that met something is a point, counter-clockwise from straight ahead", () => {
  const points = scanPoints(scan(1, 2, 3.5, 0.5)).map(([x, y]) => [
    Math.round(x * 100) / 100 + 0,
    Math.round(y * 100) / 100 + 0,
  ])
  expect(points).toEqual([
    [1, 0],
    [0, 2],
    [0, -0.5],
  ])
})

test("there is none while the program does not listen", () => {
  expect(scanPoints({channels: {}})).toEqual([])
  expect(scanPoints({channels: {Scan: []}})).toEqual([])
})
