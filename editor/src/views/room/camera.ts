/// Camera: the transform from metres with y up to pixels with y down, and the viewport that it shows. No I/O.

import type {World} from "../../worlds/world.ts"
import type {Pose} from "./poses.ts"

export interface Camera {
  /// Pixels in a metre.
  readonly scale: number
  /// Where the room's lower left corner is, in pixels.
  readonly left: number
  readonly bottom: number
}

/// Size of a canvas, in pixels of the page.
export interface Size {
  readonly w: number
  readonly h: number
  /// The screen's pixels in one of the page's.
  readonly ratio: number
}

/// Room left free around the world, in pixels.
const margin = 18

/// The largest whole view of a world of `width` × `height` metres on a canvas of `w` × `h` pixels.
export function fit(width: number, height: number, w: number, h: number): Camera {
  const scale = Math.max(1, Math.min((w - 2 * margin) / width, (h - 2 * margin) / height))
  return {scale, left: (w - width * scale) / 2, bottom: (h + height * scale) / 2}
}

/// Pixels at the lower edge of the canvas where the hands and the controls of the view lie.
const controlsHeight = 88

/// The part of a canvas from its upper edge, in pixels, in which a world of `width` × `height` metres is seen, so that the controls at the lower edge lie beside it as far
/// as the height that it leaves free allows. It is never smaller for it.
export function heightAboveControls(width: number, height: number, w: number, h: number): number {
  const free = h - height * fit(width, height, w, h).scale
  return h - Math.max(0, Math.min(2 * controlsHeight - free, free - 2 * margin))
}

export function toScreen(camera: Camera, x: number, y: number): {x: number; y: number} {
  return {x: camera.left + x * camera.scale, y: camera.bottom - y * camera.scale}
}

export function toRoom(camera: Camera, x: number, y: number): {x: number; y: number} {
  return {x: (x - camera.left) / camera.scale, y: (camera.bottom - y) / camera.scale}
}

/// How the learner looks at the room: `null` is all of it. The point `x`, `y` of the room (metres) is in the
/// middle, `zoom` times as large as when all is seen.
export type CameraView = {readonly zoom: number; readonly x: number; readonly y: number} | null

const closest = 12

/// The view of a world of `width` × `height` metres on a canvas of `w` × `h` pixels. `corner` is where its lower left
/// corner is, in metres along both axes.
export function lookAt(
  look: CameraView,
  width: number,
  height: number,
  w: number,
  h: number,
  corner: readonly [number, number] = [0, 0],
): Camera {
  const whole = fit(width, height, w, h)
  if (look === null)
    return {
      scale: whole.scale,
      left: whole.left - corner[0] * whole.scale,
      bottom: whole.bottom + corner[1] * whole.scale,
    }
  const scale = whole.scale * look.zoom
  return {scale, left: w / 2 - look.x * scale, bottom: h / 2 + look.y * scale}
}

/// Metres beside a path, and of the room at least, in a view of the path.
const besidePath = 0.3
const leastAroundPath = 1.5

/// The view in which a path fills a canvas of `w` × `h` pixels as far as the room around it allows; all of the room without a path.
export function viewOfPath(
  path: readonly (readonly [number, number])[],
  width: number,
  height: number,
  w: number,
  h: number,
): CameraView {
  if (path.length < 2) return null
  const [xs, ys] = [path.map(([x]) => x), path.map(([, y]) => y)]
  const [left, right] = [Math.min(...xs), Math.max(...xs)]
  const [low, high] = [Math.min(...ys), Math.max(...ys)]
  const across = Math.max(right - left + 2 * besidePath, leastAroundPath)
  const up = Math.max(high - low + 2 * besidePath, leastAroundPath)
  const scale = Math.min(w / across, h / up)
  const zoom = scale / fit(width, height, w, h).scale
  return zoom <= 2 ? null : {zoom, x: (left + right) / 2, y: (low + high) / 2}
}

/// Metres of the room around the robot, at least, when the picture goes with it.
const followed = 3

/// The look that keeps a point of the room in the middle, as close as before, or close enough to see the robot work.
export function follow(
  look: CameraView,
  point: {readonly x: number; readonly y: number},
  width: number,
  height: number,
  w: number,
  h: number,
): CameraView {
  const near = Math.max(1, Math.min(w, h) / followed / fit(width, height, w, h).scale)
  return {zoom: look?.zoom ?? near, x: point.x, y: point.y}
}

/// The look after the picture was moved by so many pixels.
export function pan(
  look: CameraView,
  camera: Camera,
  w: number,
  h: number,
  dx: number,
  dy: number,
): CameraView {
  const middle = toRoom(camera, w / 2 - dx, h / 2 - dy)
  return {zoom: look?.zoom ?? 1, ...middle}
}

/// The look after coming `factor` times closer, with the room's point under `x`, `y` (pixels) staying there.
export function zoom(
  look: CameraView,
  camera: Camera,
  size: {readonly w: number; readonly h: number},
  factor: number,
  x: number,
  y: number,
): CameraView {
  const old = look?.zoom ?? 1
  const now = Math.min(closest, Math.max(1, old * factor))
  // All the way out is the whole room again.
  if (now === 1) return null
  const point = toRoom(camera, x, y)
  const scale = (camera.scale / old) * now
  return {zoom: now, x: point.x + (size.w / 2 - x) / scale, y: point.y + (y - size.h / 2) / scale}
}

/// Where the lower left corner of the floor is: open floor lies around the start.
export function cornerOf(world: World): readonly [number, number] {
  return world.open ? [-world.size[0] / 2, -world.size[1] / 2] : [0, 0]
}

/// Viewport of the room: the size of the canvas, the room that it shows, the learner's view of it, and the camera that follows from them.
export class Viewport {
  size: Size = {w: 0, h: 0, ratio: 1}
  camera: Camera = {scale: 1, left: 0, bottom: 0}
  /// The room that is drawn; `null` before the first.
  world: World | null = null
  /// The page's state does not have it: it is gone with the canvas.
  view: CameraView = null

  /// Where the world is seen: the controls at the lower edge lie beside it.
  seen(): {readonly w: number; readonly h: number} {
    const {w, h} = this.size
    const [width, height] = this.world?.size ?? [1, 1]
    return {w, h: heightAboveControls(width, height, w, h)}
  }

  /// Shows a room, with the robot's pose in the middle if the view follows the robot.
  show(world: World, robot: Pose, follows: boolean): void {
    const [width, height] = world.size
    // Between the floor of a real robot and a room, places and distances mean something else.
    if (this.world !== null && this.world.open !== world.open) this.view = null
    this.world = world
    const {w, h} = this.seen()
    if (follows) this.view = follow(this.view, robot, width, height, w, h)
    this.camera = lookAt(this.view, width, height, w, h, cornerOf(world))
  }

  /// The view after it came `factor` times closer around a point of the canvas.
  zoomed(factor: number, x: number, y: number): CameraView {
    return zoom(this.view, this.camera, this.seen(), factor, x, y)
  }

  /// The view after it was moved by so many pixels.
  panned(dx: number, dy: number): CameraView {
    const {w, h} = this.seen()
    return pan(this.view, this.camera, w, h, dx, dy)
  }

  /// The share of the canvas by which layers are larger: a picture of the whole room does not move; one from nearby may, as far as half of itself.
  margin(): number {
    return this.view === null ? 0 : 0.5
  }

  /// Drawing in metres with y up from now on.
  inMetres(ctx: CanvasRenderingContext2D): void {
    const {size, camera} = this
    const k = size.ratio * camera.scale
    ctx.setTransform(k, 0, 0, -k, camera.left * size.ratio, camera.bottom * size.ratio)
  }

  /// Drawing in pixels of the page from now on.
  inPixels(ctx: CanvasRenderingContext2D): void {
    ctx.setTransform(this.size.ratio, 0, 0, this.size.ratio, 0, 0)
  }

  /// Hands stay in the room: what is dragged out of it stops at its border.
  inside({x, y, theta}: Pose): Pose {
    const [width, height] = this.world?.size ?? [0, 0]
    return {x: Math.min(width, Math.max(0, x)), y: Math.min(height, Math.max(0, y)), theta}
  }
}
