/// Clicks and keys in the room that ask a question, on a canvas without a page.

import {beforeEach, describe, expect, it} from "vitest"
import {type GestureHost, watchGestures} from "../../src/views/room/gestures.ts"
import type {Pose} from "../../src/views/room/poses.ts"
import type {QuestionTarget} from "../../src/views/room/question_targets.ts"

/// 100 pixels are one metre; the room's lower left corner is at the lower left of the canvas.
const camera = {scale: 100, left: 0, bottom: 400}

class FakeCanvas extends EventTarget {
  readonly style = {cursor: ""}
  readonly clientWidth = 500
  readonly clientHeight = 400
  getBoundingClientRect = () => ({left: 0, top: 0})
  setPointerCapture = () => undefined
}

let canvas: FakeCanvas
let asked: QuestionTarget[]
let held: number | null
let closed: number
let looked: (readonly [x: number, y: number])[]
let reaches: number[]
let placed: Pose[]
let companions: readonly Pose[]
let moved: (readonly [companion: number, pose: Pose, isDropped: boolean])[]
let able: boolean

beforeEach(() => {
  canvas = new FakeCanvas()
  asked = []
  held = null
  closed = 0
  looked = []
  reaches = []
  placed = []
  companions = []
  moved = []
  able = false
  const ignore = () => undefined
  const host: GestureHost = {
    camera: () => camera,
    robot: () => ({x: 1, y: 1, theta: 0}),
    things: () => [],
    companions: () => companions,
    companionPlaced: (companion, pose, isDropped) => moved.push([companion, pose, isDropped]),
    held: () => held,
    able: () => able,
    placed: pose => placed.push(pose),
    pushed: ignore,
    holds: ignore,
    handled: ignore,
    panned: ignore,
    zoomed: ignore,
    fitted: ignore,
    followed: ignore,
    targetAt(at, reach) {
      reaches.push(reach)
      looked.push([at.x, at.y])
      return at.x < 2 ? {kind: "place", time: at.x} : null
    },
    asked: about => asked.push(about),
    read() {
      closed += 1
    },
  }
  watchGestures(canvas as unknown as HTMLCanvasElement, host)
})

const pointer = (type: string, x: number, y: number, more: object = {}) =>
  canvas.dispatchEvent(
    Object.assign(new Event(type), {
      clientX: x,
      clientY: y,
      pointerId: 1,
      button: 0,
      pointerType: "mouse",
      ...more,
    }),
  )
const key = (name: string) => {
  const event = Object.assign(new Event("keydown", {cancelable: true}), {
    key: name,
    ctrlKey: false,
    metaKey: false,
    altKey: false,
    shiftKey: false,
  })
  canvas.dispatchEvent(event)
  return event.defaultPrevented
}

describe("a click in the room", () => {
  it("asks about what is there, in metres", () => {
    pointer("pointerdown", 100, 200)
    pointer("pointermove", 102, 201)
    pointer("pointerup", 102, 201)
    expect(looked).toEqual([[1, 2]])
    expect(asked).toEqual([{kind: "place", time: 1}])
  })

  it("asks nothing where there is nothing to ask about", () => {
    pointer("pointerdown", 300, 200)
    pointer("pointerup", 300, 200)
    expect(asked).toEqual([])
  })

  it("is none when the view was moved, even back to where it began", () => {
    pointer("pointerdown", 100, 200)
    pointer("pointermove", 120, 200)
    pointer("pointermove", 100, 200)
    pointer("pointerup", 100, 200)
    expect(asked).toEqual([])
  })

  it("is none with a second finger or another button, nor when it was cancelled", () => {
    pointer("pointerdown", 100, 200, {pointerType: "touch"})
    pointer("pointerdown", 140, 200, {pointerType: "touch", pointerId: 2})
    pointer("pointerup", 140, 200, {pointerType: "touch", pointerId: 2})
    pointer("pointerup", 100, 200, {pointerType: "touch"})
    pointer("pointerdown", 100, 200, {button: 2})
    pointer("pointerup", 100, 200, {button: 2})
    pointer("pointerdown", 100, 200)
    pointer("pointercancel", 100, 200)
    pointer("pointerup", 100, 200)
    expect(asked).toEqual([])
  })
})

describe("another robot before a run", () => {
  it("is dragged to another place, and the wheel turns it meanwhile", () => {
    companions = [
      {x: 3, y: 1, theta: 0},
      {x: 3, y: 2, theta: 0},
    ]
    pointer("pointerdown", 305, 200)
    pointer("pointermove", 405, 200)
    expect(moved).toHaveLength(1)
    expect(moved[0]?.[0]).toBe(1)
    expect(moved[0]?.[1].x).toBeCloseTo(4)
    expect(moved[0]?.[1].y).toBeCloseTo(2)
    pointer("wheel", 405, 200, {deltaY: 1})
    expect(moved[1]?.[1].theta).toBeCloseTo(Math.PI / 12)
    pointer("pointerup", 405, 200)
    expect(moved.map(([, , isDropped]) => isDropped)).toEqual([false, false, true])
    expect(placed).toEqual([])
  })
})

describe("a tap on the room", () => {
  const finger = {pointerType: "touch"}

  it("reaches 22 pixels around it, a mouse 8", () => {
    pointer("pointerdown", 100, 200, finger)
    pointer("pointerup", 100, 200, finger)
    pointer("pointerdown", 100, 200)
    pointer("pointerup", 100, 200)
    expect(reaches).toEqual([0.22, 0.08])
  })

  it("by a finger that rolls asks, and leaves the robot where it is", () => {
    able = true
    pointer("pointerdown", 100, 300, finger)
    pointer("pointermove", 106, 305, finger)
    pointer("pointerup", 106, 305, finger)
    expect(asked).toEqual([{kind: "place", time: 1}])
    expect(placed).toEqual([])
  })

  it("that goes on as a drag takes the robot along, and asks nothing", () => {
    able = true
    pointer("pointerdown", 100, 300, finger)
    pointer("pointermove", 106, 300, finger)
    pointer("pointermove", 150, 300, finger)
    pointer("pointerup", 150, 300, finger)
    expect(asked).toEqual([])
    expect(placed).toEqual([{x: 1.5, y: 1, theta: 0}])
  })

  it("asks about what was there when the finger came down", () => {
    pointer("pointerdown", 190, 200, finger)
    pointer("pointermove", 199, 200, finger)
    pointer("pointerup", 205, 200, finger)
    expect(asked).toEqual([{kind: "place", time: 1.9}])
  })
})

describe("a pointer over the room", () => {
  it("shows that a click would ask", () => {
    pointer("pointermove", 100, 200)
    expect(canvas.style.cursor).toBe("help")
    pointer("pointermove", 300, 200)
    expect(canvas.style.cursor).toBe("")
  })
})

describe("a key in the room", () => {
  it("asks about the motion of the robot, or about its place", () => {
    expect([key("w"), key("p"), key("q")]).toEqual([true, true, false])
    expect(asked).toEqual([{kind: "robot"}, {kind: "place", time: null}])
  })

  it("closes the answer, unless the keyboard holds a thing", () => {
    key("Escape")
    expect(closed).toBe(1)
    held = 0
    key("Escape")
    expect(closed).toBe(1)
  })
})
