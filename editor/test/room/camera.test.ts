/// Where things are on the canvas and between frames.

import fc from "fast-check"
import {describe, expect, it} from "vitest"
import {extendTrail, type Trail} from "../../src/state/runs/room_state.ts"
import {
  type CameraView,
  fit,
  follow,
  heightAboveControls,
  lookAt,
  pan,
  toRoom,
  toScreen,
  viewOfPath,
  zoom,
} from "../../src/views/room/camera.ts"
import {normalizeAngle, poseAt} from "../../src/views/room/poses.ts"

const size = fc.double({min: 0.5, max: 60, noNaN: true})
const pixels = fc.integer({min: 100, max: 3000})

describe("the camera", () => {
  it("shows the whole world, whatever the sizes", () => {
    fc.assert(
      fc.property(size, size, pixels, pixels, (width, height, w, h) => {
        const camera = fit(width, height, w, h)
        const low = toScreen(camera, 0, 0)
        const high = toScreen(camera, width, height)
        expect(low.x).toBeGreaterThan(0)
        expect(high.x).toBeLessThan(w)
        expect(low.y).toBeLessThan(h)
        expect(high.y).toBeGreaterThan(0)
      }),
    )
  })

  it("leaves the controls at the lower edge free where the height allows it, and is as large as before", () => {
    fc.assert(
      fc.property(size, size, pixels, pixels, (width, height, w, h) => {
        const all = fit(width, height, w, h)
        const camera = fit(width, height, w, heightAboveControls(width, height, w, h))
        expect(camera.scale).toBeCloseTo(all.scale, 6)
        const [below, above] = [h - camera.bottom, camera.bottom - height * camera.scale]
        expect(above).toBeGreaterThan(0)
        const free = below + above
        expect(below).toBeGreaterThanOrEqual(free / 2 - 1e-6)
        expect(below).toBeGreaterThanOrEqual(Math.min(88, free - 18) - 1e-6)
      }),
    )
  })

  it("goes from room to screen and back", () => {
    fc.assert(
      fc.property(size, size, (x, y) => {
        const camera = fit(10, 8, 640, 480)
        const at = toScreen(camera, x, y)
        const back = toRoom(camera, at.x, at.y)
        expect(back.x).toBeCloseTo(x, 6)
        expect(back.y).toBeCloseTo(y, 6)
      }),
    )
  })
})

describe("looking closer", () => {
  const view = {w: 640, h: 480}
  it("keeps the point under the pointer where it is, until the whole room is seen again", () => {
    fc.assert(
      fc.property(
        fc.array(
          fc.record({
            factor: fc.double({min: 0.5, max: 2, noNaN: true}),
            x: fc.integer({min: 0, max: 640}),
            y: fc.integer({min: 0, max: 480}),
          }),
          {maxLength: 12},
        ),
        steps => {
          let look: CameraView = null
          for (const {factor, x, y} of steps) {
            const before = lookAt(look, 10, 8, view.w, view.h)
            const point = toRoom(before, x, y)
            look = zoom(look, before, view, factor, x, y)
            if (look === null) continue
            const after = toScreen(lookAt(look, 10, 8, view.w, view.h), point.x, point.y)
            expect(after.x).toBeCloseTo(x, 6)
            expect(after.y).toBeCloseTo(y, 6)
          }
        },
      ),
    )
  })

  it("keeps the robot in the middle when it follows, at least as close as to see three metres", () => {
    fc.assert(
      fc.property(size, size, size, size, (width, height, x, y) => {
        const look = follow(null, {x, y}, width, height, view.w, view.h)
        const camera = lookAt(look, width, height, view.w, view.h)
        const at = toScreen(camera, x, y)
        expect(at.x).toBeCloseTo(320, 6)
        expect(at.y).toBeCloseTo(240, 6)
        expect(480 / camera.scale).toBeLessThanOrEqual(3.0001)
      }),
    )
  })

  it("moves the room with the hand", () => {
    const look = {zoom: 2, x: 5, y: 4}
    const camera = lookAt(look, 10, 8, view.w, view.h)
    const corner = toScreen(camera, 0, 0)
    const moved = toScreen(lookAt(pan(look, camera, view.w, view.h, 30, -10), 10, 8, view.w, view.h), 0, 0)
    expect(moved.x - corner.x).toBeCloseTo(30)
    expect(moved.y - corner.y).toBeCloseTo(-10)
  })
})

describe("the pose between two frames", () => {
  const pose = (x: number, theta = 0) => ({x, y: 0, theta})

  it("goes from the one to the other and stays there", () => {
    const [a, b] = [
      {pose: pose(0), at: 100},
      {pose: pose(0.1), at: 120},
    ]
    expect(poseAt(a, b, 120).x).toBe(0)
    expect(poseAt(a, b, 130).x).toBeCloseTo(0.05)
    expect(poseAt(a, b, 500).x).toBeCloseTo(0.1)
  })

  it("jumps when the robot was put elsewhere", () => {
    expect(poseAt({pose: pose(0), at: 0}, {pose: pose(3), at: 20}, 20).x).toBe(3)
  })

  it("turns the short way round", () => {
    expect(normalizeAngle((3 * Math.PI) / 2)).toBeCloseTo(-Math.PI / 2)
    const [a, b] = [
      {pose: pose(0, 3.1), at: 0},
      {pose: pose(0, -3.1), at: 20},
    ]
    expect(Math.abs(poseAt(a, b, 30).theta)).toBeGreaterThan(3.1)
  })
})

describe("the trail", () => {
  it("grows while the robot drives, not while it stands, and leaves its finished pieces as they were", () => {
    let trail: Trail = []
    for (let i = 0; i < 500; i += 1) trail = extendTrail(trail, {x: i * 0.02, y: 0, time: i, speed: 0.5})
    for (let i = 0; i < 500; i += 1)
      trail = extendTrail(trail, {x: 499 * 0.02, y: 0.001, time: 500, speed: 0})
    const points = trail.flat()
    expect(new Set(points.map(p => p.x)).size).toBe(500)
    const later = extendTrail(trail, {x: 99, y: 0, time: 501, speed: 0.5})
    expect(later[0]).toBe(trail[0])
  })
})

describe("the view of a path", () => {
  const square = [
    [1.5, 2],
    [2, 2],
    [2, 2.5],
    [1.5, 2.5],
  ] as const

  it("is all of the room without a path, and with one that crosses it", () => {
    expect(viewOfPath([], 5, 4, 224, 140)).toBeNull()
    expect(
      viewOfPath(
        [
          [0.5, 2],
          [4.5, 2],
        ],
        5,
        4,
        224,
        140,
      ),
    ).toBeNull()
  })

  it("has a short path in its middle and all of it in sight, in a large room", () => {
    const camera = lookAt(viewOfPath(square, 20, 20, 224, 140), 20, 20, 224, 140)
    expect(toRoom(camera, 112, 70).x).toBeCloseTo(1.75)
    expect(toRoom(camera, 112, 70).y).toBeCloseTo(2.25)
    for (const [x, y] of square) {
      const shown = toScreen(camera, x, y)
      expect(shown.x).toBeGreaterThan(0)
      expect(shown.x).toBeLessThan(224)
      expect(shown.y).toBeGreaterThan(0)
      expect(shown.y).toBeLessThan(140)
    }
    expect(camera.scale * 0.5).toBeGreaterThan(30)
  })
})
