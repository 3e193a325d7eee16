/// Drawing of a compared run below the trail: a dotted path, the robot's outline at the displayed moment, and the names of both runs beside their robots.

import type {Trail} from "../../state/runs/room_state.ts"
import {type Camera, toScreen} from "./camera.ts"
import type {Overlay} from "./overlay.ts"
import type {Palette} from "./palette.ts"
import {usualRadius} from "./robot_drawing.ts"
import {trailUntil} from "./trail_segments.ts"

/// Sizes on the screen, pixels: round dots with gaps between them.
const dotWidth = 4
const gap = 8
const labelDistance = 8

/// Metres between two points of a drawn path; a preview has the same.
const pointDistance = 0.02
/// Points of a drawn path; a longer path has them farther apart.
const mostPoints = 4000

/// Draws in metres; `scale` is pixels per metre.
export function drawOverlay(
  ctx: CanvasRenderingContext2D,
  {trail, until, pose}: Overlay,
  palette: Palette,
  scale: number,
  robotRadius: number,
): void {
  ctx.save()
  ctx.strokeStyle = palette.compared
  ctx.lineJoin = "round"
  ctx.lineCap = "round"
  ctx.lineWidth = dotWidth / scale
  // Dashes without a length are round dots.
  ctx.setLineDash([0, gap / scale])
  ctx.stroke(until === null ? wholePath(trail) : pathOf(trailUntil(trail, until)))
  ctx.setLineDash([])
  ctx.translate(pose.x, pose.y)
  ctx.rotate(pose.theta)
  ctx.lineWidth = 2 / scale
  ctx.beginPath()
  ctx.arc(0, 0, robotRadius, 0, 2 * Math.PI)
  ctx.moveTo(0, 0)
  ctx.lineTo(robotRadius, 0)
  ctx.stroke()
  ctx.restore()
}

const whole = new WeakMap<Trail, Path2D>()

function wholePath(trail: Trail): Path2D {
  const known = whole.get(trail) ?? pathOf(trail)
  whole.set(trail, known)
  return known
}

function pathOf(trail: Trail): Path2D {
  const path = new Path2D()
  const points = trail.flat()
  const every = Math.ceil(points.length / mostPoints)
  let last: {readonly x: number; readonly y: number} | null = null
  points.forEach((point, i) => {
    const isEnd = i === points.length - 1
    if (last === null) path.moveTo(point.x, point.y)
    else if (isEnd || (i % every === 0 && Math.hypot(point.x - last.x, point.y - last.y) >= pointDistance))
      path.lineTo(point.x, point.y)
    else return
    last = point
  })
  return path
}

/// Writes the names beside the robots, in pixels of the screen: that of the shown run above its robot, the other below.
export function drawRunNames(
  ctx: CanvasRenderingContext2D,
  names: {readonly shown: string; readonly compared: string},
  at: {readonly shown: {readonly x: number; readonly y: number}; readonly compared: Overlay["pose"]},
  camera: Camera,
  palette: Palette,
): void {
  ctx.font = `600 13px ${palette.font}`
  ctx.textAlign = "center"
  ctx.lineJoin = "round"
  ctx.lineWidth = 4
  ctx.strokeStyle = palette.floor
  const away = usualRadius * camera.scale + labelDistance
  const write = (text: string, point: {x: number; y: number}, colour: string, above: boolean) => {
    const {x, y} = toScreen(camera, point.x, point.y)
    ctx.textBaseline = above ? "bottom" : "top"
    ctx.strokeText(text, x, above ? y - away : y + away)
    ctx.fillStyle = colour
    ctx.fillText(text, x, above ? y - away : y + away)
  }
  write(names.compared, at.compared, palette.compared, false)
  write(names.shown, at.shown, palette.trail, true)
}
