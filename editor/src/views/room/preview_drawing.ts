/// Drawing of a preview below the trail: the ink of its pen, a dashed path, the robot's outline where it would end, crosses where it would touch something, and ticks or crosses for goals.

import type {PathPoint, Preview} from "../../state/messages/preview.ts"
import {placeAt} from "../../state/messages/preview.ts"
import {previewInk} from "../../state/runs/preview_ink.ts"
import type {Palette} from "./palette.ts"
import {drawInk} from "./trail_drawing.ts"

/// Sizes on the screen, pixels.
const lineWidth = 3
const dash = [9, 6]
const markRadius = 7

/// How much of a preview is seen that is about the program before the last change.
const faded = 0.45
/// How much of its ink is seen: the ink of a run covers the floor.
const inkOpacity = 0.5

/// Draws in metres; `scale` is pixels per metre. `current`: it is about the program as it is now.
export function drawPreview(
  ctx: CanvasRenderingContext2D,
  preview: Preview,
  current: boolean,
  palette: Palette,
  scale: number,
  robotRadius: number,
): void {
  ctx.save()
  const opacity = current ? 1 : faded
  ctx.globalAlpha = opacity * inkOpacity
  drawInk(ctx, previewInk(preview), palette, scale)
  ctx.globalAlpha = opacity
  ctx.strokeStyle = palette.preview
  ctx.lineJoin = "round"
  ctx.lineCap = "butt"
  drawPath(ctx, preview.path, scale)
  for (const {x, y} of preview.collisions) drawMark(ctx, x, y, "cross", palette, scale)
  for (const goal of preview.goals) {
    const place = goal.time === null || goal.state === "open" ? null : placeAt(preview.path, goal.time)
    if (place !== null)
      drawMark(ctx, place.x, place.y, goal.state === "done" ? "tick" : "cross", palette, scale)
  }
  drawOutline(ctx, preview, palette, scale, robotRadius)
  ctx.restore()
}

function drawPath(ctx: CanvasRenderingContext2D, path: readonly PathPoint[], scale: number): void {
  ctx.lineWidth = lineWidth / scale
  ctx.setLineDash(dash.map(length => length / scale))
  ctx.beginPath()
  path.forEach(({x, y}, i) => {
    if (i === 0) ctx.moveTo(x, y)
    else ctx.lineTo(x, y)
  })
  ctx.stroke()
  ctx.setLineDash([])
}

/// Where the robot would stand at the end, and where it would look.
function drawOutline(
  ctx: CanvasRenderingContext2D,
  {x, y, theta}: Preview,
  palette: Palette,
  scale: number,
  robotRadius: number,
): void {
  ctx.save()
  ctx.translate(x, y)
  ctx.rotate(theta)
  ctx.lineWidth = 2 / scale
  ctx.beginPath()
  ctx.arc(0, 0, robotRadius, 0, 2 * Math.PI)
  ctx.fillStyle = palette.preview
  const alpha = ctx.globalAlpha
  ctx.globalAlpha = alpha * 0.15
  ctx.fill()
  ctx.globalAlpha = alpha
  ctx.stroke()
  ctx.beginPath()
  ctx.moveTo(robotRadius * 0.3, robotRadius * 0.35)
  ctx.lineTo(robotRadius * 0.8, 0)
  ctx.lineTo(robotRadius * 0.3, -robotRadius * 0.35)
  ctx.stroke()
  ctx.restore()
}

export function drawMark(
  ctx: CanvasRenderingContext2D,
  x: number,
  y: number,
  kind: "cross" | "tick",
  palette: Palette,
  scale: number,
): void {
  const r = markRadius / scale
  ctx.lineWidth = 2 / scale
  ctx.beginPath()
  ctx.arc(x, y, r, 0, 2 * Math.PI)
  ctx.fillStyle = palette.floor
  ctx.fill()
  ctx.stroke()
  const part = 0.45 * r
  ctx.beginPath()
  if (kind === "cross") {
    ctx.moveTo(x - part, y - part)
    ctx.lineTo(x + part, y + part)
    ctx.moveTo(x - part, y + part)
    ctx.lineTo(x + part, y - part)
  } else {
    ctx.moveTo(x - part * 1.2, y)
    ctx.lineTo(x - part * 0.2, y - part)
    ctx.lineTo(x + part * 1.2, y + part)
  }
  ctx.stroke()
}
