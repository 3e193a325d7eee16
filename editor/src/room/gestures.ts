/// Hands in the room: take the robot and put it elsewhere, turn it, move the view, look closer. With mouse,
/// touch and keyboard. Says what was wanted; what becomes of it is decided elsewhere.

import {type Camera, toRoom} from "./camera.ts"
import type {Pose} from "./motion.ts"

export interface GestureHost {
  camera(): Camera
  /// Where the robot is drawn, or `null` when there is no room yet.
  robot(): Pose | null
  /// The robot was taken to this pose.
  placed(pose: Pose): void
  /// The view was moved by so many pixels.
  panned(dx: number, dy: number): void
  /// The view became `factor` times as close, around a point on the canvas.
  zoomed(factor: number, x: number, y: number): void
  fitted(): void
  /// The view is to go with the robot, or to stay again.
  followed(): void
}

/// Kobuki's radius, m (see `robot.ts`); taking hold is a little easier than that.
const reach = 0.22
/// A key moves the robot so far, in metres, and turns it so far, in radians.
const keyStep = 0.05
const keyTurn = Math.PI / 12

export function watchGestures(canvas: HTMLCanvasElement, host: GestureHost): void {
  const at = (event: PointerEvent | WheelEvent) => {
    const box = canvas.getBoundingClientRect()
    return {x: event.clientX - box.left, y: event.clientY - box.top}
  }
  const holds = (event: PointerEvent): boolean => {
    const robot = host.robot()
    if (robot === null) return false
    const p = at(event)
    const point = toRoom(host.camera(), p.x, p.y)
    return Math.hypot(point.x - robot.x, point.y - robot.y) < Math.max(reach, 16 / host.camera().scale)
  }

  let grip:
    | {kind: "robot"; dx: number; dy: number; theta: number}
    | {kind: "floor"; x: number; y: number}
    | null = null
  // With two fingers the view zooms; `fingers` are those on the canvas.
  const fingers = new Map<number, {x: number; y: number}>()

  canvas.addEventListener("pointerdown", event => {
    canvas.setPointerCapture(event.pointerId)
    const p = at(event)
    fingers.set(event.pointerId, p)
    const robot = host.robot()
    if (robot !== null && holds(event)) {
      const point = toRoom(host.camera(), p.x, p.y)
      grip = {kind: "robot", dx: robot.x - point.x, dy: robot.y - point.y, theta: robot.theta}
    } else grip = {kind: "floor", ...p}
  })
  canvas.addEventListener("pointermove", event => {
    const p = at(event)
    if (grip === null) {
      canvas.style.cursor = holds(event) ? "grab" : ""
      return
    }
    if (fingers.size === 2) {
      const other = [...fingers].find(([id]) => id !== event.pointerId)?.[1]
      const mine = fingers.get(event.pointerId)
      if (other !== undefined && mine !== undefined) {
        const spread =
          Math.hypot(p.x - other.x, p.y - other.y) / Math.hypot(mine.x - other.x, mine.y - other.y)
        host.zoomed(spread, (p.x + other.x) / 2, (p.y + other.y) / 2)
      }
    } else if (grip.kind === "robot") {
      const point = toRoom(host.camera(), p.x, p.y)
      canvas.style.cursor = "grabbing"
      host.placed({x: point.x + grip.dx, y: point.y + grip.dy, theta: grip.theta})
    } else {
      host.panned(p.x - grip.x, p.y - grip.y)
      grip = {kind: "floor", ...p}
    }
    fingers.set(event.pointerId, p)
  })
  const release = (event: PointerEvent) => {
    fingers.delete(event.pointerId)
    if (fingers.size === 0) grip = null
    canvas.style.cursor = ""
  }
  canvas.addEventListener("pointerup", release)
  canvas.addEventListener("pointercancel", release)

  canvas.addEventListener(
    "wheel",
    event => {
      event.preventDefault()
      const p = at(event)
      const robot = host.robot()
      if (grip?.kind === "robot" && robot !== null) {
        grip.theta += Math.sign(event.deltaY) * keyTurn
        host.placed({...robot, theta: grip.theta})
      } else host.zoomed(1.0015 ** -event.deltaY, p.x, p.y)
    },
    {passive: false},
  )
  canvas.addEventListener("dblclick", () => host.fitted())

  canvas.addEventListener("keydown", event => {
    const robot = host.robot()
    const middle = {x: canvas.clientWidth / 2, y: canvas.clientHeight / 2}
    const moves: Record<string, () => void> = {
      "+": () => host.zoomed(1.25, middle.x, middle.y),
      "-": () => host.zoomed(0.8, middle.x, middle.y),
      "0": () => host.fitted(),
      f: () => host.followed(),
    }
    if (robot !== null) {
      const place = (dx: number, dy: number, turn: number) => () =>
        host.placed({x: robot.x + dx, y: robot.y + dy, theta: robot.theta + turn})
      Object.assign(moves, {
        ArrowUp: place(0, keyStep, 0),
        ArrowDown: place(0, -keyStep, 0),
        ArrowLeft: place(-keyStep, 0, 0),
        ArrowRight: place(keyStep, 0, 0),
        ",": place(0, 0, keyTurn),
        ".": place(0, 0, -keyTurn),
      })
    }
    const move = event.ctrlKey || event.metaKey || event.altKey ? undefined : moves[event.key]
    if (move === undefined) return
    event.preventDefault()
    move()
  })
}
