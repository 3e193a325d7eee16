/// The room on a canvas. `draw` is called once per frame with the page's state and decides nothing; what does
/// not move is kept on a second canvas, and finished pieces of the trail as paths.

import type {Frame, World} from "../state/messages.ts"
import {type Point, type RoomState, shownFrame} from "../state/room.ts"
import {type Camera, type Look, lookAt, pan, toScreen, zoom} from "./camera.ts"
import {watchGestures} from "./gestures.ts"
import {type Pose, poseAt, type Seen} from "./motion.ts"
import {readPalette} from "./palette.ts"
import {drawGhost, drawRobot} from "./robot.ts"
import {drawThings, drawWorld} from "./world.ts"

export interface RoomView {
  /// Draws the room as it is; answers whether something still moves, so that another frame is worth drawing.
  draw(room: RoomState, now: number): boolean
  /// The theme changed: colours are read anew.
  recolour(): void
  dispose(): void
}

const parked = {bumpers: 0, cliffs: 0, wheels: 0, led1: 0, led2: 0}

export interface RoomListener {
  /// The picture must be drawn again.
  changed(): void
  /// The learner took the robot to this pose (room coordinates).
  placed(pose: Pose): void
}

export function openRoom(canvas: HTMLCanvasElement, listener: RoomListener): RoomView {
  const ctx = canvas.getContext("2d")
  const still = document.createElement("canvas")
  const under = still.getContext("2d")
  if (ctx === null || under === null) throw new Error("expected a canvas with a 2d context, found none")

  let palette = readPalette(canvas)
  let size = {w: 0, h: 0, ratio: 1}
  let drawnWorld: World | null = null
  let camera: Camera = {scale: 1, left: 0, bottom: 0}
  // How the room is looked at is no knowledge of the page's: it is gone with the canvas.
  let look: Look = null
  let shown: Pose | null = null
  let before: Seen | null = null
  let last: Seen | null = null
  let lastFrame: Frame | null = null
  const paths = new WeakMap<readonly Point[], Path2D>()

  const measure = () => {
    const box = canvas.getBoundingClientRect()
    size = {w: box.width, h: box.height, ratio: window.devicePixelRatio || 1}
    for (const c of [canvas, still]) {
      c.width = Math.max(1, Math.round(size.w * size.ratio))
      c.height = Math.max(1, Math.round(size.h * size.ratio))
    }
    drawnWorld = null
    listener.changed()
  }
  const watcher = new ResizeObserver(measure)
  watcher.observe(canvas)
  measure()

  const looked = (to: Look) => {
    look = to
    drawnWorld = null
    listener.changed()
  }
  watchGestures(canvas, {
    camera: () => camera,
    robot: () => shown,
    placed: pose => listener.placed(pose),
    panned: (dx, dy) => {
      if (look !== null) looked(pan(look, camera, size.w, size.h, dx, dy))
    },
    zoomed: (factor, x, y) => looked(zoom(look, camera, size, factor, x, y)),
    fitted: () => looked(null),
  })

  const metres = (c: CanvasRenderingContext2D) => {
    const k = size.ratio * camera.scale
    c.setTransform(k, 0, 0, -k, camera.left * size.ratio, camera.bottom * size.ratio)
  }

  const pieceOf = (piece: readonly Point[]): Path2D => {
    const known = paths.get(piece)
    if (known !== undefined) return known
    const path = new Path2D()
    addLine(path, piece)
    paths.set(piece, path)
    return path
  }

  const drawTrail = (room: RoomState, tip: Pose) => {
    metres(ctx)
    ctx.lineJoin = "round"
    ctx.lineCap = "round"
    ctx.lineWidth = Math.max(0.02, 2.5 / camera.scale)
    ctx.strokeStyle = palette.trail
    ctx.globalAlpha = 0.55
    // One stroke for all pieces: where two meet, a second stroke would show through the first.
    const path = new Path2D()
    const until = room.lookedAt ?? Number.POSITIVE_INFINITY
    const pieces = room.trail.filter(piece => (piece[0]?.time ?? 0) <= until)
    for (const piece of pieces.slice(0, -1)) path.addPath(pieceOf(piece))
    const end = pieces.at(-1)
    if (end !== undefined) {
      // The tip is drawn to where the robot is shown, which lags one frame behind the last point.
      const passed = room.lookedAt === null ? end.slice(0, -1) : end.filter(p => p.time <= until)
      addLine(path, passed)
      if (passed.length === 0) path.moveTo(tip.x, tip.y)
      path.lineTo(tip.x, tip.y)
    }
    ctx.stroke(path)
    ctx.globalAlpha = 1
  }

  const drawSpeech = (text: string, pose: Pose) => {
    ctx.setTransform(size.ratio, 0, 0, size.ratio, 0, 0)
    ctx.font = `500 14px ${palette.font}`
    const short = text.length > 40 ? `${text.slice(0, 39)}…` : text
    const width = Math.min(ctx.measureText(short).width + 22, size.w - 8)
    const at = toScreen(camera, pose.x, pose.y)
    const lift = 0.2 * camera.scale + 14
    const left = Math.min(Math.max(4, at.x - width / 2), size.w - width - 4)
    const above = at.y - lift - 30 > 4
    const top = above ? at.y - lift - 30 : at.y + lift
    ctx.fillStyle = palette.ink
    ctx.beginPath()
    ctx.roundRect(left, top, width, 30, 9)
    ctx.fill()
    ctx.beginPath()
    const foot = above ? top + 30 : top
    const dip = above ? 8 : -8
    const tail = Math.min(Math.max(left + 16, at.x), left + width - 16)
    ctx.moveTo(tail - 7, foot)
    ctx.lineTo(tail, foot + dip)
    ctx.lineTo(tail + 7, foot)
    ctx.fill()
    ctx.fillStyle = palette.paper
    ctx.textAlign = "center"
    ctx.textBaseline = "middle"
    ctx.fillText(short, left + width / 2, top + 16, width - 16)
  }

  return {
    draw(room, now) {
      const {world} = room
      const frame = shownFrame(room)
      if (world !== drawnWorld) {
        under.setTransform(1, 0, 0, 1, 0, 0)
        under.clearRect(0, 0, still.width, still.height)
        drawnWorld = world
        if (world !== null) {
          camera = lookAt(look, world.size[0], world.size[1], size.w, size.h)
          metres(under)
          drawWorld(under, world, palette, camera.scale)
        }
      }
      ctx.setTransform(1, 0, 0, 1, 0, 0)
      ctx.clearRect(0, 0, canvas.width, canvas.height)
      if (world === null) {
        shown = null
        return false
      }
      ctx.drawImage(still, 0, 0)

      if (frame !== lastFrame) {
        const follows = frame !== null && lastFrame !== null && frame.run === lastFrame.run
        before = follows && room.lookedAt === null ? last : null
        last = frame === null ? null : {pose: frame, at: now}
        lastFrame = frame
      }
      const pose = last === null ? world.start : poseAt(before, last, now)
      shown = pose
      metres(ctx)
      drawThings(ctx, world, frame?.boxes ?? [], palette, camera.scale)
      drawTrail(room, pose)
      metres(ctx)
      if (frame !== null && frame.ghost !== null) {
        const [x, y, theta] = frame.ghost
        ctx.save()
        ctx.translate(x, y)
        ctx.rotate(theta)
        drawGhost(ctx, palette, camera.scale)
        ctx.restore()
      }
      ctx.translate(pose.x, pose.y)
      ctx.rotate(pose.theta)
      drawRobot(ctx, frame ?? parked, palette, camera.scale)
      if (room.speech !== null && room.lookedAt === null) drawSpeech(room.speech.text, pose)
      return last !== null && before !== null && now - last.at < last.at - before.at
    },
    recolour() {
      palette = readPalette(canvas)
      drawnWorld = null
      listener.changed()
    },
    dispose() {
      watcher.disconnect()
    },
  }
}

function addLine(path: Path2D, points: readonly Point[]): void {
  const [first, ...rest] = points
  if (first === undefined) return
  path.moveTo(first.x, first.y)
  for (const p of rest) path.lineTo(p.x, p.y)
}
