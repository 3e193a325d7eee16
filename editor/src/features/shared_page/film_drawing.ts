/// Draws one moment of a film on a canvas: the room, the path so far, the movable objects, the robot and what it says.

import {cornerOf, follow, lookAt, type Size, toScreen} from "../../views/room/camera.ts"
import type {Palette} from "../../views/room/palette.ts"
import {drawBubble, drawRobot} from "../../views/room/robot_drawing.ts"
import {drawInk} from "../../views/room/trail_drawing.ts"
import {drawObjects, drawWorld} from "../../views/room/world_drawing.ts"
import {isLarge} from "../../worlds/world.ts"
import {type Film, momentAt} from "./film.ts"

/// `time` in seconds of the run. The view follows the robot in a large room.
export function drawFilm(
  ctx: CanvasRenderingContext2D,
  film: Film,
  time: number,
  {w, h, ratio}: Size,
  palette: Palette,
): void {
  const [width, height] = film.world.size
  const moment = momentAt(film, time)
  const look = isLarge(film.world) ? follow(null, moment, width, height, w, h) : null
  const camera = lookAt(look, width, height, w, h, cornerOf(film.world))
  ctx.setTransform(1, 0, 0, 1, 0, 0)
  ctx.fillStyle = palette.around
  ctx.fillRect(0, 0, w * ratio, h * ratio)
  const k = ratio * camera.scale
  ctx.setTransform(k, 0, 0, -k, camera.left * ratio, camera.bottom * ratio)
  drawWorld(ctx, film.world, palette, camera.scale)
  ctx.beginPath()
  for (const [x, y] of moment.path) ctx.lineTo(x, y)
  ctx.lineJoin = "round"
  ctx.lineCap = "round"
  ctx.lineWidth = Math.max(2.5 / camera.scale, 0.02)
  ctx.strokeStyle = palette.trail
  ctx.stroke()
  drawInk(ctx, moment.ink, palette, camera.scale)
  drawObjects(ctx, film.world, moment.objects, palette, camera.scale)
  ctx.save()
  ctx.translate(moment.x, moment.y)
  ctx.rotate(moment.theta)
  drawRobot(ctx, moment, palette, camera.scale, film.world.robot)
  ctx.restore()
  ctx.setTransform(ratio, 0, 0, ratio, 0, 0)
  if (moment.said !== null) {
    const at = toScreen(camera, moment.x, moment.y)
    drawBubble(ctx, moment.said, at, 0.2 * camera.scale + 14, {w, h}, palette)
  }
  ctx.setTransform(1, 0, 0, 1, 0, 0)
}
