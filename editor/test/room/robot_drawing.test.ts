/// What the laser scanner has measured, as points of the room's drawing.

import {expect, test} from "vitest"
import {ledPlaces, ledSize, scanPoints, usualRadius} from "../../src/views/room/robot_drawing.ts"

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

// A room of 4 m in 500 px, one of 10 m in 500 px, and a view from nearby.
test.each([125, 50, 1000])("the LEDs lie beside each other on the robot, at %d px a metre", scale => {
  const [first, second] = ledPlaces(scale)
  const size = ledSize(scale)
  expect(Math.hypot(first![0] - second![0], first![1] - second![1])).toBeGreaterThanOrEqual(2 * size)
  for (const [x, y] of ledPlaces(scale)) expect(Math.hypot(x, y) + size).toBeLessThan(usualRadius)
})

test("an LED is large enough to be seen in a whole room", () => {
  expect(125 * ledSize(125)).toBeGreaterThan(4)
  expect(ledSize(1000)).toBe(0.023)
})
