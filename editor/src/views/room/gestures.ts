/// Pointer, touch and keyboard gestures in the room: place and turn the robot, push objects, pan, zoom. Reports the gesture; the listener decides its effect.

import {isChord, type Keys} from "../../state/shortcuts.ts"
import {type Camera, toRoom} from "./camera.ts"
import {type MovableObject, objectAt, type Pose} from "./poses.ts"
import {fingerReach, pointerReach, type QuestionTarget, type Spot} from "./question_targets.ts"

export interface GestureHost {
  camera(): Camera
  /// Where the robot is drawn, or `null` when there is no room yet.
  robot(): Pose | null
  /// What can be pushed, where it is drawn.
  things(): readonly MovableObject[]
  /// The thing that the keyboard holds; `null` is the robot.
  held(): number | null
  /// Whether gestures move the robot and things: only while a program runs.
  able(): boolean
  /// The robot was taken to this pose.
  placed(pose: Pose): void
  /// A thing was pushed towards this pose.
  pushed(thing: number, pose: Pose): void
  /// The keyboard takes another thing, or the robot again.
  holds(thing: number | null): void
  /// The handle that turns the robot is to be seen, or no longer.
  handled(shown: boolean): void
  /// The view was moved by so many pixels.
  panned(dx: number, dy: number): void
  /// The view became `factor` times as close, around a point on the canvas.
  zoomed(factor: number, x: number, y: number): void
  fitted(): void
  /// The view is to go with the robot, or to stay again.
  followed(): void
  /// What a click at a point of the room asks about, within so many metres; `null` when there is nothing.
  targetAt(at: Spot, reach: number): QuestionTarget | null
  asked(about: QuestionTarget): void
  /// The answer is read.
  read(): void
}

export const roomKeys = {
  hands: ["ArrowUp", "ArrowDown", "ArrowLeft", "ArrowRight"],
  turnLeft: [","],
  turnRight: ["."],
  thing: ["b"],
  robot: ["Escape"],
  follow: ["f"],
  why: ["w"],
  place: ["p"],
  closer: ["+"],
  further: ["-"],
  whole: ["0"],
} as const satisfies Keys

type RoomKey = keyof typeof roomKeys
type Acts = Partial<Record<RoomKey, (key: string) => void>>

/// From the robot's middle to the handle that turns it, m.
const handleReach = 0.32
/// The robot's radius, m (see `robot_drawing.ts`); taking hold is a little easier than that.
const reach = 0.22
/// The handle shows while the pointer is so near to the robot, m.
const near = 0.45
/// How far around a pointer is meant, in pixels.
const grasp = 16
/// A pointer that moved no further than this was a click or a tap, in pixels: a finger rolls while it rests.
const still = 4
const stillFinger = 10
/// A key moves the robot so far, in metres, and turns it so far, in radians.
const keyStep = 0.05
const keyTurn = Math.PI / 12

type GestureTarget =
  | {readonly kind: "robot"; readonly dx: number; readonly dy: number; theta: number}
  | {readonly kind: "turn"; readonly by: number}
  | {readonly kind: "thing"; readonly thing: number; readonly dx: number; readonly dy: number; theta: number}
  | {readonly kind: "floor"; readonly x: number; readonly y: number}

export function watchGestures(canvas: HTMLCanvasElement, host: GestureHost): void {
  const at = (event: PointerEvent | WheelEvent): Spot => {
    const box = canvas.getBoundingClientRect()
    return {x: event.clientX - box.left, y: event.clientY - box.top}
  }
  const inRoom = (p: Spot): Spot => toRoom(host.camera(), p.x, p.y)
  const metres = (pixels: number) => pixels / host.camera().scale

  /// What a hand takes hold of at a point of the canvas.
  const gripAt = (p: Spot): GestureTarget => {
    const robot = host.robot()
    const floor: GestureTarget = {kind: "floor", ...p}
    if (robot === null || !host.able()) return floor
    const point = inRoom(p)
    const away = Math.hypot(point.x - robot.x, point.y - robot.y)
    const bearing = Math.atan2(point.y - robot.y, point.x - robot.x)
    const handle = handleOf(robot)
    const toHandle = Math.hypot(point.x - handle.x, point.y - handle.y)
    if (away > reach && toHandle < Math.max(0.07, metres(grasp)))
      return {kind: "turn", by: robot.theta - bearing}
    if (away < Math.max(reach, metres(grasp)))
      return {kind: "robot", dx: robot.x - point.x, dy: robot.y - point.y, theta: robot.theta}
    const things = host.things()
    const thing = objectAt(things, point.x, point.y, metres(grasp / 2))
    const taken = thing === null ? undefined : things[thing]
    if (thing === null || taken === undefined) return floor
    return {kind: "thing", thing, dx: taken.x - point.x, dy: taken.y - point.y, theta: taken.theta}
  }
  /// The hand went to a point of the canvas with what it holds.
  const drag = (grip: GestureTarget, p: Spot) => {
    const point = inRoom(p)
    const robot = host.robot()
    switch (grip.kind) {
      case "robot":
        return host.placed({x: point.x + grip.dx, y: point.y + grip.dy, theta: grip.theta})
      case "turn": {
        if (robot === null) return
        const bearing = Math.atan2(point.y - robot.y, point.x - robot.x)
        return host.placed({x: robot.x, y: robot.y, theta: bearing + grip.by})
      }
      case "thing":
        return host.pushed(grip.thing, {x: point.x + grip.dx, y: point.y + grip.dy, theta: grip.theta})
      case "floor":
        return host.panned(p.x - grip.x, p.y - grip.y)
    }
  }

  let grip: GestureTarget | null = null
  /// Where the pointer went down, and what was there; `null` once it has moved, or another finger came. The robot may drive on before it goes up.
  let pressed: {readonly at: Spot; readonly about: QuestionTarget | null} | null = null
  const askedAt = (p: Spot, {pointerType}: PointerEvent) =>
    host.targetAt(inRoom(p), metres(pointerType === "touch" ? fingerReach : pointerReach))
  // With two fingers the view zooms, or the robot that one of them holds is turned; `fingers` are those on the canvas.
  const fingers = new Map<number, Spot>()
  const otherFinger = (id: number) => [...fingers].find(([other]) => other !== id)?.[1]

  canvas.addEventListener("pointerdown", event => {
    canvas.setPointerCapture(event.pointerId)
    const p = at(event)
    fingers.set(event.pointerId, p)
    pressed = fingers.size === 1 && event.button === 0 ? {at: p, about: askedAt(p, event)} : null
    if (fingers.size > 1) return
    grip = gripAt(p)
    host.handled(grip.kind === "robot" || grip.kind === "turn")
  })
  canvas.addEventListener("pointermove", event => {
    const p = at(event)
    if (grip === null) {
      const under = gripAt(p).kind
      canvas.style.cursor = under !== "floor" ? "grab" : askedAt(p, event) === null ? "" : "help"
      const robot = host.robot()
      const point = inRoom(p)
      if (event.pointerType === "mouse")
        host.handled(robot !== null && Math.hypot(point.x - robot.x, point.y - robot.y) < near)
      return
    }
    if (pressed !== null) {
      const moved = Math.hypot(p.x - pressed.at.x, p.y - pressed.at.y)
      // Until then nothing is dragged: a tap on the robot leaves it where it is.
      if (moved <= (event.pointerType === "touch" ? stillFinger : still)) return
      pressed = null
    }
    const mine = fingers.get(event.pointerId)
    const other = otherFinger(event.pointerId)
    fingers.set(event.pointerId, p)
    if (mine !== undefined && other !== undefined) twoFingers(mine, p, other)
    else {
      canvas.style.cursor = grip.kind === "floor" ? "" : "grabbing"
      drag(grip, p)
      if (grip.kind === "floor") grip = {kind: "floor", ...p}
    }
  })
  const twoFingers = (before: Spot, now: Spot, other: Spot) => {
    const robot = host.robot()
    if (grip?.kind === "robot" && robot !== null) {
      // Pixels count y downwards, the room counts it upwards.
      const angle = (p: Spot) => Math.atan2(other.y - p.y, p.x - other.x)
      grip.theta += angle(now) - angle(before)
      host.placed({x: robot.x, y: robot.y, theta: grip.theta})
      return
    }
    const spread = (p: Spot) => Math.hypot(p.x - other.x, p.y - other.y)
    if (spread(before) > 0 && spread(now) > 0)
      host.zoomed(spread(now) / spread(before), (now.x + other.x) / 2, (now.y + other.y) / 2)
  }
  const release = (event: PointerEvent) => {
    fingers.delete(event.pointerId)
    if (fingers.size === 0) grip = null
    canvas.style.cursor = ""
  }
  canvas.addEventListener("pointerup", event => {
    const about = pressed?.about ?? null
    pressed = null
    release(event)
    if (about !== null) host.asked(about)
  })
  canvas.addEventListener("pointercancel", event => {
    pressed = null
    release(event)
  })
  canvas.addEventListener("pointerleave", event => event.pointerType === "mouse" && host.handled(false))

  canvas.addEventListener(
    "wheel",
    event => {
      event.preventDefault()
      const p = at(event)
      if (grip?.kind === "robot" || grip?.kind === "thing") {
        // The wheel turns what the hand holds.
        grip.theta += Math.sign(event.deltaY) * keyTurn
        drag(grip, p)
      } else host.zoomed(1.0015 ** -event.deltaY, p.x, p.y)
    },
    {passive: false},
  )
  canvas.addEventListener("dblclick", () => host.fitted())

  canvas.addEventListener("keydown", event => {
    const middle = {x: canvas.clientWidth / 2, y: canvas.clientHeight / 2}
    const acts: Acts = {
      closer: () => host.zoomed(1.25, middle.x, middle.y),
      further: () => host.zoomed(0.8, middle.x, middle.y),
      whole: () => host.fitted(),
      follow: () => host.followed(),
      why: () => host.asked({kind: "robot"}),
      place: () => host.asked({kind: "place", time: null}),
      ...keyHands(host),
      ...(host.held() === null ? {robot: () => host.read()} : {}),
    }
    const wanted = Object.entries(roomKeys).find(([, chords]) => chords.some(chord => isChord(event, chord)))
    const act = wanted === undefined ? undefined : acts[wanted[0] as RoomKey]
    if (act === undefined) return
    event.preventDefault()
    act(event.key)
  })
}

/// Where the handle that turns the robot is.
export function handleOf(robot: Pose): Spot {
  return {x: robot.x + handleReach * Math.cos(robot.theta), y: robot.y + handleReach * Math.sin(robot.theta)}
}

/// What the keys do to what they hold: the robot, or with `b` one thing after the other.
function keyHands(host: GestureHost): Acts {
  const robot = host.robot()
  const things = host.things()
  const held = host.held()
  const thing = held === null ? undefined : things[held]
  if (robot === null || !host.able()) return {}
  const pose = thing ?? robot
  const put = (dx: number, dy: number, turn: number) => () => {
    const to = {x: pose.x + dx, y: pose.y + dy, theta: pose.theta + turn}
    if (held === null || thing === undefined) host.placed(to)
    else host.pushed(held, to)
  }
  const next = held === null ? 0 : held + 1
  return {
    hands: key => {
      const [x, y] = directions[key] ?? [0, 0]
      put(x * keyStep, y * keyStep, 0)()
    },
    turnLeft: put(0, 0, keyTurn),
    turnRight: put(0, 0, -keyTurn),
    thing: () => host.holds(next < things.length ? next : null),
    robot: () => host.holds(null),
  }
}

const directions: Readonly<Record<string, readonly [x: number, y: number]>> = {
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
}
