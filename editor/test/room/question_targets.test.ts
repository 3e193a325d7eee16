/// What a click in the room asks about.

import {describe, expect, it} from "vitest"
import type {Trail} from "../../src/state/runs/room_state.ts"
import {targetAt} from "../../src/views/room/question_targets.ts"

const point = (x: number, y: number, time: number) => ({x, y, time, speed: 0.5})
const trail: Trail = [
  [point(0, 0, 0), point(1, 0, 2), point(2, 0, 4)],
  [point(2, 0, 4), point(2, 1, 6), point(1, 0, 9)],
]
/// It looks to the right: its LEDs are at the left of its rear.
const robot = {x: 1, y: 1, theta: 0}

describe("a click in the room", () => {
  it.each([
    ["on the robot", {x: 1.1, y: 1}, {kind: "robot"}],
    ["beside the robot, within reach", {x: 1.25, y: 1}, {kind: "robot"}],
    ["on the trail", {x: 1.95, y: 0.9}, {kind: "place", time: 6}],
    ["on a place that the robot came to twice: the last time", {x: 1, y: 0.1}, {kind: "place", time: 9}],
    ["far from both", {x: 3, y: 3}, null],
  ])("%s", (_, at, about) => {
    expect(targetAt(robot, trail, at, 0.3)).toEqual(about)
  })

  it.each([
    ["the first LED", {x: 0.9, y: 1.08}, 0, {kind: "led", command: "Led1"}],
    ["the second LED", {x: 0.88, y: 1.03}, 0, {kind: "led", command: "Led2"}],
    [
      "where the first LED is after a quarter turn",
      {x: 0.92, y: 0.9},
      Math.PI / 2,
      {kind: "led", command: "Led1"},
    ],
    ["where it was before the turn", {x: 0.9, y: 1.08}, Math.PI / 2, {kind: "robot"}],
  ])("on %s asks about it from nearby, and about the robot from far away", (_, at, theta, about) => {
    expect(targetAt({...robot, theta}, trail, at, 0.02)).toEqual(about)
    expect(targetAt({...robot, theta}, trail, at, 0.13)).toEqual({kind: "robot"})
  })

  it("asks about the trail without a robot, and about nothing without a trail", () => {
    expect(targetAt(null, trail, {x: 0, y: 0}, 0.3)).toEqual({kind: "place", time: 0})
    expect(targetAt(null, [], robot, 0.3)).toBeNull()
  })

  it("reaches the whole robot from far away, where a few pixels are much, and nothing else from nearby", () => {
    expect(targetAt(robot, trail, {x: 1.4, y: 1}, 0.5)).toEqual({kind: "robot"})
    expect(targetAt(robot, trail, {x: 1.15, y: 1}, 0.02)).toEqual({kind: "robot"})
    expect(targetAt(robot, trail, {x: 1, y: 0.05}, 0.02)).toBeNull()
  })
})
