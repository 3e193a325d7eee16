/// The room on a canvas. `draw` is called once per frame with the page's state and decides nothing; what does
/// not move, and what of the trail is finished, is kept on layers beside it.

import type {Frame} from "../state/messages.ts"
import {type RoomState, shownFrame, speech, type TrailStyle} from "../state/room.ts"
import type {World} from "../worlds/world.ts"
import {drawBubble} from "./bubble.ts"
import {type Camera, follow, type Look, lookAt, pan, toScreen, zoom} from "./camera.ts"
import {watchGestures} from "./gestures.ts"
import {openLayer, type Size} from "./layer.ts"
import {type Pose, poseAt, type Seen} from "./motion.ts"
import {readPalette} from "./palette.ts"
import {openPath} from "./path.ts"
import {drawGhost, drawRobot} from "./robot.ts"
import {drawThings, drawWorld} from "./world.ts"

export interface RoomView {
  /// Draws the room as it is; answers whether something still moves, so that another frame is worth drawing.
  draw(room: RoomState, sight: Sight, now: number): boolean
  /// Comes `factor` times closer, around the middle.
  zoom(factor: number): void
  /// Shows all of the room.
  whole(): void
  /// The theme changed: colours are read anew.
  recolour(): void
  dispose(): void
}

/// How the learner wants to see the room.
export interface Sight {
  readonly trail: TrailStyle
  /// The picture goes with the robot.
  readonly follows: boolean
}

const parked = {bumpers: 0, cliffs: 0, wheels: 0, buttons: 0, led1: 0, led2: 0}

export interface RoomListener {
  /// The picture must be drawn again.
  changed(): void
  /// The learner took the robot to this pose (room coordinates).
  placed(pose: Pose): void
  /// The picture is to go with the robot, or no longer: the learner moved it by hand, or asked for all of the room.
  follows(follows: boolean): void
}

export function openRoom(canvas: HTMLCanvasElement, listener: RoomListener): RoomView {
  const ctx = canvas.getContext("2d", {alpha: false})
  if (ctx === null) throw new Error("expected a canvas with a 2d context, found none")

  let palette = readPalette(canvas)
  let size: Size = {w: 0, h: 0, ratio: 1}
  let drawnWorld: World | null = null
  let camera: Camera = {scale: 1, left: 0, bottom: 0}
  // How the room is looked at is no knowledge of the page's: it is gone with the canvas.
  let look: Look = null
  let following = false
  let shown: Pose | null = null
  let before: Seen | null = null
  let last: Seen | null = null
  let lastFrame: Frame | null = null
  // A picture of the whole room does not move; one from nearby may, as far as half of itself.
  const margin = () => (look === null ? 0 : 0.5)
  const ground = openLayer(margin)
  const path = openPath(palette, margin)

  const measure = () => {
    const box = canvas.getBoundingClientRect()
    size = {w: box.width, h: box.height, ratio: window.devicePixelRatio || 1}
    canvas.width = Math.max(1, Math.round(size.w * size.ratio))
    canvas.height = Math.max(1, Math.round(size.h * size.ratio))
    listener.changed()
  }
  const watcher = new ResizeObserver(measure)
  watcher.observe(canvas)
  measure()

  const looked = (to: Look) => {
    look = to
    listener.changed()
  }
  const whole = () => {
    listener.follows(false)
    looked(null)
  }
  const zoomed = (factor: number, x: number, y: number) => looked(zoom(look, camera, size, factor, x, y))
  watchGestures(canvas, {
    camera: () => camera,
    robot: () => shown,
    placed: pose => listener.placed(pose),
    panned: (dx, dy) => {
      if (look === null) return
      listener.follows(false)
      looked(pan(look, camera, size.w, size.h, dx, dy))
    },
    zoomed,
    fitted: whole,
    followed: () => listener.follows(!following),
  })

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
    if (following) look = follow(look, pose, width, height, size.w, size.h)
    camera = lookAt(look, width, height, size.w, size.h)
    path.place(camera, size)
    if (world !== drawnWorld) ground.forget()
    drawnWorld = world
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
      const {world} = room
      const frame = shownFrame(room)
      following = sight.follows
      ctx.setTransform(1, 0, 0, 1, 0, 0)
      ctx.fillStyle = palette.around
      ctx.fillRect(0, 0, canvas.width, canvas.height)
      if (world === null) {
        shown = null
        return false
      }
      const pose = poseOf(room, world, frame, now)
      shown = pose
      place(world, pose)
      ground.show(ctx, camera)
      path.draw(ctx, room, sight.trail, pose)
      metres()
      drawThings(ctx, world, frame?.boxes ?? [], palette, camera.scale)
      if (frame !== null && frame.ghost !== null)
        drawAt(...frame.ghost, () => drawGhost(ctx, palette, camera.scale))
      drawAt(pose.x, pose.y, pose.theta, () => drawRobot(ctx, frame ?? parked, palette, camera.scale))
      const words = speech(room)
      if (words !== null) {
        ctx.setTransform(size.ratio, 0, 0, size.ratio, 0, 0)
        drawBubble(ctx, words, toScreen(camera, pose.x, pose.y), 0.2 * camera.scale + 14, size, palette)
      }
      return last !== null && before !== null && now - last.at < last.at - before.at
    },
    zoom: factor => zoomed(factor, size.w / 2, size.h / 2),
    whole,
    recolour() {
      palette = readPalette(canvas)
      path.recolour(palette)
      ground.forget()
      listener.changed()
    },
    dispose() {
      watcher.disconnect()
    },
  }
}
