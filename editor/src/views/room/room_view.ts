/// The room's view on a canvas. `draw` is called once per frame with the state. Static parts and finished pieces of the trail are cached on layers.

import type {Frame} from "../../state/messages/messages.ts"
import {shownPreview} from "../../state/messages/preview.ts"
import {
  type RoomState,
  shownFrame,
  speech,
  type Trail,
  type TrailStyle,
  type Words,
} from "../../state/runs/room_state.ts"
import type {World} from "../../worlds/world.ts"
import {openLayer, type Size} from "./cached_layer.ts"
import {
  type Camera,
  type CameraView,
  follow,
  heightAboveControls,
  lookAt,
  pan,
  toScreen,
  zoom,
} from "./camera.ts"
import {handleOf, watchGestures} from "./gestures.ts"
import type {Overlay} from "./overlay.ts"
import {drawOverlay, drawRunNames} from "./overlay_drawing.ts"
import {type Palette, readPalette} from "./palette.ts"
import {type MovableObject, movableObjectsOf, type Pose, poseAt, type TimedPose} from "./poses.ts"
import {drawPreview} from "./preview_drawing.ts"
import {type QuestionTarget, targetAt} from "./question_targets.ts"
import {drawBeams, drawBubble, drawGhost, drawRobot} from "./robot_drawing.ts"
import {openPath} from "./trail_drawing.ts"
import {trailUntil} from "./trail_segments.ts"
import {cornerOf, drawObjects, drawWorld} from "./world_drawing.ts"

export interface RoomView {
  /// Draws the room if it looks different from what is drawn; answers whether something still moves, so that another frame is worth drawing.
  draw(room: RoomState, sight: RoomViewOptions, now: number): boolean
  /// Comes `factor` times closer, around the middle.
  zoom(factor: number): void
  /// Shows all of the room.
  whole(): void
  /// The theme changed: colours are read anew.
  recolour(): void
  dispose(): void
}

/// How the learner wants to see the room.
export interface RoomViewOptions {
  readonly trail: TrailStyle
  /// The picture goes with the robot.
  readonly follows: boolean
  /// Hands can take hold of things: a program runs, and the learner looks at it as it is now.
  readonly hands: boolean
  /// The thing that the keyboard holds.
  readonly held: number | null
  /// A run to compare with the shown one, and the names of both.
  readonly overlay: (Overlay & {readonly names: {readonly shown: string; readonly compared: string}}) | null
}

const parked = {channels: {}}

export interface RoomListener {
  /// The picture must be drawn again.
  changed(): void
  /// The learner took the robot to this pose (room coordinates).
  placed(pose: Pose): void
  /// The learner pushed a movable thing towards this pose, or took hold of it by keyboard.
  pushed(thing: number, pose: Pose): void
  holds(thing: number | null): void
  /// The picture is to go with the robot, or no longer: the learner moved it by hand, or asked for all of the room.
  follows(follows: boolean): void
  /// The learner asks why the robot moves, shines or speaks as it does, or why it was at a point of its trail.
  asked(about: QuestionTarget): void
  /// The learner has read the answer.
  read(): void
}

export function openRoom(canvas: HTMLCanvasElement, listener: RoomListener): RoomView {
  const ctx = canvas.getContext("2d", {alpha: false})
  if (ctx === null) throw new Error("expected a canvas with a 2d context, found none")

  let palette = readPalette(canvas)
  let size: Size = {w: 0, h: 0, ratio: 1}
  let drawnWorld: World | null = null
  let camera: Camera = {scale: 1, left: 0, bottom: 0}
  // How the room is looked at is no knowledge of the page's: it is gone with the canvas.
  let look: CameraView = null
  let following = false
  let hands = {able: false, held: null as number | null, handle: false}
  let things: readonly MovableObject[] = []
  let shown: Pose | null = null
  let trail: Trail = []
  /// The speech bubble where it is drawn, in pixels.
  let bubble: {readonly words: Words; readonly box: ReturnType<typeof drawBubble>} | null = null
  // Without a run there is nothing to ask about.
  let canAsk = false
  let before: TimedPose | null = null
  let last: TimedPose | null = null
  let lastFrame: Frame | null = null
  /// The state of the last drawing; `null` forces a new one.
  let drawn: {readonly room: RoomState; readonly sight: RoomViewOptions} | null = null
  // A picture of the whole room does not move; one from nearby may, as far as half of itself.
  const margin = () => (look === null ? 0 : 0.5)
  const ground = openLayer(margin)
  const path = openPath(palette, margin)

  const changed = () => {
    drawn = null
    listener.changed()
  }
  const measure = () => {
    const box = canvas.getBoundingClientRect()
    size = {w: box.width, h: box.height, ratio: window.devicePixelRatio || 1}
    canvas.width = Math.max(1, Math.round(size.w * size.ratio))
    canvas.height = Math.max(1, Math.round(size.h * size.ratio))
    changed()
  }
  const watcher = new ResizeObserver(measure)
  watcher.observe(canvas)
  measure()

  /// Where the world is seen: the controls at the lower edge lie beside it.
  const seen = () => {
    const [width, height] = drawnWorld?.size ?? [1, 1]
    return {w: size.w, h: heightAboveControls(width, height, size.w, size.h)}
  }
  const looked = (to: CameraView) => {
    look = to
    changed()
  }
  const whole = () => {
    listener.follows(false)
    looked(null)
  }
  const zoomed = (factor: number, x: number, y: number) => looked(zoom(look, camera, seen(), factor, x, y))
  watchGestures(canvas, {
    camera: () => camera,
    robot: () => shown,
    things: () => things,
    held: () => hands.held,
    able: () => hands.able,
    placed: pose => listener.placed(inside(drawnWorld, pose)),
    pushed: (thing, pose) => listener.pushed(thing, inside(drawnWorld, pose)),
    holds(held) {
      // At once: the next key may come before the next picture.
      hands = {...hands, held}
      listener.holds(held)
    },
    handled(handle) {
      if (hands.handle === handle) return
      hands = {...hands, handle}
      changed()
    },
    panned: (dx, dy) => {
      if (look === null) return
      listener.follows(false)
      const {w, h} = seen()
      looked(pan(look, camera, w, h, dx, dy))
    },
    zoomed,
    fitted: whole,
    followed: () => listener.follows(!following),
    targetAt(at, reach) {
      if (!canAsk) return null
      if (bubble !== null && isWithin(bubble.box, toScreen(camera, at.x, at.y)))
        return {kind: "speech", ...bubble.words}
      return targetAt(shown, trail, at, reach)
    },
    asked: about => listener.asked(about),
    read: () => listener.read(),
  })

  const recolour = () => {
    palette = readPalette(canvas)
    path.recolour(palette)
    ground.forget()
    changed()
  }
  // A browser may drop what is drawn, as after a fault of the graphics card.
  canvas.addEventListener("contextrestored", recolour)

  const metres = () => {
    const k = size.ratio * camera.scale
    ctx.setTransform(k, 0, 0, -k, camera.left * size.ratio, camera.bottom * size.ratio)
  }

  /// Where the robot is drawn now: between the last two frames.
  const poseOf = (room: RoomState, world: World, frame: Frame | null, now: number): Pose => {
    if (frame !== lastFrame) {
      const follows = frame !== null && lastFrame !== null && frame.run === lastFrame.run
      before = follows && room.lookedAt === null ? last : null
      last = frame === null ? null : {pose: frame, at: now}
      lastFrame = frame
    }
    return last === null ? world.start : poseAt(before, last, now)
  }

  const place = (world: World, pose: Pose) => {
    const [width, height] = world.size
    // Between the floor of a real robot and a room, places and distances mean something else.
    if (drawnWorld !== null && drawnWorld.open !== world.open) look = null
    if (world !== drawnWorld) ground.forget()
    drawnWorld = world
    const {w, h} = seen()
    if (following) look = follow(look, pose, width, height, w, h)
    camera = lookAt(look, width, height, w, h, cornerOf(world))
    path.place(camera, size)
    if (!ground.covers(camera, size)) drawWorld(ground.ctx, world, palette, camera.scale)
  }

  const drawAt = (x: number, y: number, theta: number, draw: () => void) => {
    ctx.save()
    ctx.translate(x, y)
    ctx.rotate(theta)
    draw()
    ctx.restore()
  }

  return {
    draw(room, sight, now) {
      if (drawn !== null && looksSame(drawn.room, room) && isSameSight(drawn.sight, sight)) return false
      const {world} = room
      const frame = shownFrame(room)
      following = sight.follows
      hands = {...hands, able: sight.hands, held: sight.held}
      ctx.setTransform(1, 0, 0, 1, 0, 0)
      ctx.fillStyle = palette.around
      ctx.fillRect(0, 0, canvas.width, canvas.height)
      drawn = {room, sight}
      if (world === null) {
        shown = null
        things = []
        bubble = null
        return false
      }
      const pose = poseOf(room, world, frame, now)
      shown = pose
      canAsk = room.run !== null
      trail = room.lookedAt === null ? room.trail : trailUntil(room.trail, room.lookedAt)
      place(world, pose)
      ground.show(ctx, camera)
      const preview = shownPreview(room.preview)
      if (preview !== null) {
        metres()
        drawPreview(ctx, preview.preview, preview.current, palette, camera.scale)
      }
      const {overlay} = sight
      if (overlay !== null) {
        metres()
        drawOverlay(ctx, overlay, palette, camera.scale)
      }
      path.draw(ctx, room, sight.trail, pose)
      metres()
      things = movableObjectsOf(world, frame?.boxes ?? [])
      drawObjects(ctx, world, frame?.boxes ?? [], palette, camera.scale)
      if (frame !== null && frame.ghost !== null)
        drawAt(...frame.ghost, () => drawGhost(ctx, palette, camera.scale))
      if (frame !== null)
        drawAt(pose.x, pose.y, pose.theta, () => drawBeams(ctx, frame, palette, camera.scale))
      drawAt(pose.x, pose.y, pose.theta, () => drawRobot(ctx, frame ?? parked, palette, camera.scale))
      if (hands.able) drawHands(ctx, hands, pose, things, palette, camera.scale)
      if (overlay !== null) {
        ctx.setTransform(size.ratio, 0, 0, size.ratio, 0, 0)
        drawRunNames(ctx, overlay.names, {shown: pose, compared: overlay.pose}, camera, palette)
      }
      const words = speech(room)
      bubble = null
      if (words !== null) {
        ctx.setTransform(size.ratio, 0, 0, size.ratio, 0, 0)
        const at = toScreen(camera, pose.x, pose.y)
        bubble = {words, box: drawBubble(ctx, words.text, at, 0.2 * camera.scale + 14, size, palette)}
      }
      const moves = last !== null && before !== null && now - last.at < last.at - before.at
      if (moves) drawn = null
      return moves
    },
    zoom: factor => zoomed(factor, seen().w / 2, seen().h / 2),
    whole,
    recolour,
    dispose() {
      watcher.disconnect()
      canvas.removeEventListener("contextrestored", recolour)
    },
  }
}

/// Whether a room looks as another does: a question for a preview is not seen.
function looksSame(one: RoomState, other: RoomState): boolean {
  if (one === other) return true
  const keys = Object.keys(one) as (keyof RoomState)[]
  const [mine, others] = [shownPreview(one.preview), shownPreview(other.preview)]
  return (
    keys.every(key => key === "preview" || one[key] === other[key]) &&
    mine?.preview === others?.preview &&
    mine?.current === others?.current
  )
}

/// Two runs that are compared are always drawn.
function isSameSight(one: RoomViewOptions, other: RoomViewOptions): boolean {
  const keys = Object.keys(one) as (keyof RoomViewOptions)[]
  return keys.every(key => one[key] === other[key])
}

function isWithin(
  {left, top, width, height}: ReturnType<typeof drawBubble>,
  {x, y}: {readonly x: number; readonly y: number},
): boolean {
  return left <= x && x <= left + width && top <= y && y <= top + height
}

/// Hands stay in the room: what is dragged out of it stops at its border.
function inside(world: World | null, {x, y, theta}: Pose): Pose {
  const [width, height] = world?.size ?? [0, 0]
  return {x: Math.min(width, Math.max(0, x)), y: Math.min(height, Math.max(0, y)), theta}
}

/// The handle that turns the robot, and a ring around the thing that the keyboard holds.
function drawHands(
  ctx: CanvasRenderingContext2D,
  hands: {readonly held: number | null; readonly handle: boolean},
  robot: Pose,
  things: readonly MovableObject[],
  palette: Palette,
  scale: number,
): void {
  ctx.strokeStyle = palette.trail
  ctx.fillStyle = palette.trail
  ctx.lineWidth = 2 / scale
  const thing = hands.held === null ? undefined : things[hands.held]
  if (thing !== undefined) {
    ctx.beginPath()
    ctx.arc(thing.x, thing.y, Math.max(0.12, 12 / scale), 0, 2 * Math.PI)
    ctx.stroke()
  }
  if (!hands.handle) return
  const {x, y} = handleOf(robot)
  ctx.beginPath()
  ctx.arc(x, y, 6.5 / scale, 0, 2 * Math.PI)
  ctx.fill()
}
