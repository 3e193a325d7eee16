/// A small picture of a room as it is before a run, for the gallery.

import {robotRadius, type World} from "../worlds/world.ts"
import {lookAt} from "./camera.ts"
import {readPalette} from "./palette.ts"
import {drawRobot} from "./robot.ts"
import {drawThings, drawWorld} from "./world.ts"

/// In CSS pixels; the page may show it smaller.
const picture = {w: 224, h: 140}
/// A robot that would be a smaller dot than this is drawn larger, in CSS pixels: one sees where it starts.
const leastRobot = 5

const parked = {bumpers: 0, cliffs: 0, wheels: 0, buttons: 0, led1: 0, led2: 0}

export function drawPicture(canvas: HTMLCanvasElement, world: World): void {
  const ctx = canvas.getContext("2d")
  if (ctx === null) return
  const ratio = window.devicePixelRatio || 1
  canvas.width = picture.w * ratio
  canvas.height = picture.h * ratio
  const palette = readPalette(canvas)
  const camera = lookAt(null, world.size[0], world.size[1], picture.w, picture.h)
  const k = ratio * camera.scale
  ctx.setTransform(k, 0, 0, -k, camera.left * ratio, camera.bottom * ratio)
  drawWorld(ctx, world, palette, camera.scale)
  drawThings(ctx, world, [], palette, camera.scale)
  ctx.translate(world.start.x, world.start.y)
  ctx.rotate(world.start.theta)
  const larger = Math.max(1, leastRobot / (robotRadius * camera.scale))
  ctx.scale(larger, larger)
  drawRobot(ctx, parked, palette, camera.scale * larger)
}
