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
  /// The other robots that a hand can take to another place: those before a run.
  companions(): readonly Pose[]
  /// `isDropped`: the hand lets it go there.
  companionPlaced(companion: number, pose: Pose, isDropped: boolean): void
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
  | {
      readonly kind: "companion"
      readonly companion: number
      readonly dx: number
      readonly dy: number
      theta: number
    }
  | {readonly kind: "floor"; readonly x: number; readonly y: number}

export function watchGestures(canvas: HTMLCanvasElement, host: GestureHost): void {
  const pointers = new PointerGestures(canvas, host)
  canvas.addEventListener("pointerdown", event => pointers.down(event))
  canvas.addEventListener("pointermove", event => pointers.move(event))
  canvas.addEventListener("pointerup", event => pointers.up(event))
  canvas.addEventListener("pointercancel", event => pointers.cancel(event))
  canvas.addEventListener("pointerleave", event => event.pointerType === "mouse" && host.handled(false))
  canvas.addEventListener("wheel", event => pointers.wheel(event), {passive: false})
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

/// Gestures of a mouse, a pen or fingers: what is held, and where the fingers are.
class PointerGestures {
  private readonly canvas: HTMLCanvasElement
  private readonly host: GestureHost
  private grip: GestureTarget | null = null
  /// Where the pointer went down, and what was there; `null` once it has moved, or another finger came. The robot may drive on before it goes up.
  private pressed: {readonly at: Spot; readonly about: QuestionTarget | null} | null = null
  // With two fingers the view zooms, or the robot that one of them holds is turned; these are those on the canvas.
  private readonly fingers = new Map<number, Spot>()

  constructor(canvas: HTMLCanvasElement, host: GestureHost) {
    this.canvas = canvas
    this.host = host
  }

  down(event: PointerEvent): void {
    const {fingers} = this
    this.canvas.setPointerCapture(event.pointerId)
    const p = this.at(event)
    fingers.set(event.pointerId, p)
    this.pressed = fingers.size === 1 && event.button === 0 ? {at: p, about: this.askedAt(p, event)} : null
    if (fingers.size > 1) return
    this.grip = this.gripAt(p)
    this.host.handled(this.grip.kind === "robot" || this.grip.kind === "turn")
  }

  move(event: PointerEvent): void {
    const {canvas, fingers, grip, pressed} = this
    const p = this.at(event)
    if (grip === null) {
      this.hover(p, event)
      return
    }
    if (pressed !== null) {
      const moved = Math.hypot(p.x - pressed.at.x, p.y - pressed.at.y)
      // Until then nothing is dragged: a tap on the robot leaves it where it is.
      if (moved <= (event.pointerType === "touch" ? stillFinger : still)) return
      this.pressed = null
    }
    const mine = fingers.get(event.pointerId)
    const other = [...fingers].find(([id]) => id !== event.pointerId)?.[1]
    fingers.set(event.pointerId, p)
    if (mine !== undefined && other !== undefined) this.twoFingers(grip, mine, p, other)
    else {
      canvas.style.cursor = grip.kind === "floor" ? "" : "grabbing"
      this.drag(grip, p)
      if (grip.kind === "floor") this.grip = {kind: "floor", ...p}
    }
  }

  up(event: PointerEvent): void {
    const about = this.pressed?.about ?? null
    if (this.grip?.kind === "companion" && this.pressed === null) this.drag(this.grip, this.at(event), true)
    this.cancel(event)
    if (about !== null) this.host.asked(about)
  }

  cancel(event: PointerEvent): void {
    this.pressed = null
    this.fingers.delete(event.pointerId)
    if (this.fingers.size === 0) this.grip = null
    this.canvas.style.cursor = ""
  }

  wheel(event: WheelEvent): void {
    const {grip} = this
    event.preventDefault()
    const p = this.at(event)
    if (grip?.kind === "robot" || grip?.kind === "thing" || grip?.kind === "companion") {
      // The wheel turns what the hand holds.
      grip.theta += Math.sign(event.deltaY) * keyTurn
      this.drag(grip, p)
    } else this.host.zoomed(1.0015 ** -event.deltaY, p.x, p.y)
  }

  private at(event: PointerEvent | WheelEvent): Spot {
    const box = this.canvas.getBoundingClientRect()
    return {x: event.clientX - box.left, y: event.clientY - box.top}
  }

  private inRoom(p: Spot): Spot {
    return toRoom(this.host.camera(), p.x, p.y)
  }

  private metres(pixels: number): number {
    return pixels / this.host.camera().scale
  }

  private askedAt(p: Spot, {pointerType}: PointerEvent): QuestionTarget | null {
    const reach = this.metres(pointerType === "touch" ? fingerReach : pointerReach)
    return this.host.targetAt(this.inRoom(p), reach)
  }

  /// What a hand takes hold of at a point of the canvas.
  private gripAt(p: Spot): GestureTarget {
    const {host} = this
    const robot = host.robot()
    const floor: GestureTarget = {kind: "floor", ...p}
    const point = this.inRoom(p)
    const companions = host.companions()
    const companion = companions.findIndex(at => Math.hypot(point.x - at.x, point.y - at.y) < reach)
    const found = companions[companion]
    if (found !== undefined)
      return {
        kind: "companion",
        companion,
        dx: found.x - point.x,
        dy: found.y - point.y,
        theta: found.theta,
      }
    if (robot === null || !host.able()) return floor
    const away = Math.hypot(point.x - robot.x, point.y - robot.y)
    const bearing = Math.atan2(point.y - robot.y, point.x - robot.x)
    const handle = handleOf(robot)
    const toHandle = Math.hypot(point.x - handle.x, point.y - handle.y)
    if (away > reach && toHandle < Math.max(0.07, this.metres(grasp)))
      return {kind: "turn", by: robot.theta - bearing}
    if (away < Math.max(reach, this.metres(grasp)))
      return {kind: "robot", dx: robot.x - point.x, dy: robot.y - point.y, theta: robot.theta}
    const things = host.things()
    const thing = objectAt(things, point.x, point.y, this.metres(grasp / 2))
    const taken = thing === null ? undefined : things[thing]
    if (thing === null || taken === undefined) return floor
    return {kind: "thing", thing, dx: taken.x - point.x, dy: taken.y - point.y, theta: taken.theta}
  }

  /// The hand went to a point of the canvas with what it holds.
  private drag(grip: GestureTarget, p: Spot, isDropped = false): void {
    const {host} = this
    const point = this.inRoom(p)
    if (grip.kind === "floor") host.panned(p.x - grip.x, p.y - grip.y)
    else if (grip.kind === "turn") {
      const robot = host.robot()
      if (robot === null) return
      const bearing = Math.atan2(point.y - robot.y, point.x - robot.x)
      host.placed({x: robot.x, y: robot.y, theta: bearing + grip.by})
    } else {
      const pose = {x: point.x + grip.dx, y: point.y + grip.dy, theta: grip.theta}
      if (grip.kind === "companion") host.companionPlaced(grip.companion, pose, isDropped)
      else if (grip.kind === "robot") host.placed(pose)
      else host.pushed(grip.thing, pose)
    }
  }

  /// A pointer that holds nothing is over a point of the canvas.
  private hover(p: Spot, event: PointerEvent): void {
    const under = this.gripAt(p).kind
    this.canvas.style.cursor = under !== "floor" ? "grab" : this.askedAt(p, event) === null ? "" : "help"
    if (event.pointerType !== "mouse") return
    const robot = this.host.robot()
    const point = this.inRoom(p)
    this.host.handled(robot !== null && Math.hypot(point.x - robot.x, point.y - robot.y) < near)
  }

  private twoFingers(grip: GestureTarget, before: Spot, now: Spot, other: Spot): void {
    const {host} = this
    const robot = host.robot()
    if (grip.kind === "robot" && robot !== null) {
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
