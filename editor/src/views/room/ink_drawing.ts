/// Drawing of the ink on the floor: finished strokes once, on a cached layer; the growing stroke in every frame.

import {type Ink, inkUntil, type Stroke} from "../../state/runs/ink.ts"
import {openLayer} from "./cached_layer.ts"
import type {Camera, Size} from "./camera.ts"
import type {Palette} from "./palette.ts"

/// A stroke is at least this wide on the screen, in pixels.
const leastWidth = 1

export interface InkView {
  /// Draws the ink as it was at `lookedAt` s, or all of it.
  draw(ctx: CanvasRenderingContext2D, ink: Ink, lookedAt: number | null): void
  place(camera: Camera, size: Size): void
  recolour(palette: Palette): void
}

export function openInk(first: Palette, margin: () => number): InkView {
  let palette = first
  let [camera, size]: [Camera, Size] = [
    {scale: 1, left: 0, bottom: 0},
    {w: 0, h: 0, ratio: 1},
  ]
  const layer = openLayer(margin)
  /// The strokes on the layer: so many, of the ink that begins with this one.
  let kept: {first: Stroke | undefined; strokes: number} = {first: undefined, strokes: 0}

  return {
    place(at, of) {
      camera = at
      size = of
    },
    recolour(colours) {
      palette = colours
      layer.forget()
    },
    draw(ctx, all, lookedAt) {
      if (all.length === 0) return
      const ink = lookedAt === null ? all : inkUntil(all, lookedAt)
      const done = Math.max(0, ink.length - 1)
      let goesOn = layer.covers(camera, size)
      if (goesOn && (kept.strokes > done || (kept.strokes > 0 && kept.first !== ink[0]))) {
        layer.forget()
        layer.covers(camera, size)
        goesOn = false
      }
      drawInk(layer.ctx, ink.slice(goesOn ? kept.strokes : 0, done), palette, camera.scale)
      kept = {first: ink[0], strokes: done}
      layer.show(ctx, camera)
      const k = size.ratio * camera.scale
      ctx.setTransform(k, 0, 0, -k, camera.left * size.ratio, camera.bottom * size.ratio)
      drawInk(ctx, ink.slice(done), palette, camera.scale)
    },
  }
}

/// Draws in metres; `scale` is pixels per metre.
export function drawInk(ctx: CanvasRenderingContext2D, ink: Ink, palette: Palette, scale: number): void {
  ctx.lineJoin = "round"
  ctx.lineCap = "round"
  for (const {color, width, points} of ink) {
    const wide = Math.max(width, leastWidth / scale)
    const colour = palette.inks[color] ?? palette.ink
    const [only, ...more] = points
    ctx.beginPath()
    if (only !== undefined && more.length === 0) {
      ctx.fillStyle = colour
      ctx.arc(only.x, only.y, wide / 2, 0, 2 * Math.PI)
      ctx.fill()
      continue
    }
    ctx.strokeStyle = colour
    ctx.lineWidth = wide
    for (const {x, y} of points) ctx.lineTo(x, y)
    ctx.stroke()
  }
}
