/// Drawing of what the robot leaves on the floor, its trail and the ink of its pen: finished pieces once, on a cached layer; the growing piece in every frame.

import {type Ink, inkUntil, type Stroke} from "../../state/runs/ink.ts"
import type {Point, RoomState, Trail, TrailStyle} from "../../state/runs/room_state.ts"
import {openLayer} from "./cached_layer.ts"
import {type Camera, type Size, toScreen} from "./camera.ts"
import type {Palette} from "./palette.ts"
import {segmentsOf, speedLevel, timeLevel, timeMarks, timeSpan, trailUntil} from "./trail_segments.ts"

/// Widths on the screen, in pixels, from level to level; where a metre is large, the path is as wide as `perMetre` says.
const widths = {
  plain: [2.5],
  speed: [1.5, 2.5, 3.75, 5.25, 7],
  time: [1.25, 1.75, 2.5, 3.5, 4.75],
} as const satisfies Record<TrailStyle, readonly number[]>
/// 2.5 pixels are 2 cm.
const perMetre = 125

/// Points closer together than this on the screen are drawn as one, in pixels.
const apart = 1.2

export interface PathView {
  /// `tip` is where the robot is drawn: a frame behind the trail's last point.
  draw(
    ctx: CanvasRenderingContext2D,
    room: RoomState,
    style: TrailStyle,
    tip: {readonly x: number; readonly y: number},
  ): void
  place(camera: Camera, size: Size): void
  recolour(palette: Palette): void
}

/// What a trail is drawn with, and where.
interface Pen {
  readonly palette: Palette
  readonly camera: Camera
  readonly size: Size
}

export function openPath(first: Palette, margin: () => number): PathView {
  let pen: Pen = {palette: first, camera: {scale: 1, left: 0, bottom: 0}, size: {w: 0, h: 0, ratio: 1}}
  const layer = openLayer(margin)
  /// What is on the layer: pieces of this trail, in this manner.
  let kept: {manner: string; first: readonly Point[] | undefined; pieces: number} | null = null

  return {
    place(camera, size) {
      pen = {...pen, camera, size}
    },
    recolour(palette) {
      pen = {...pen, palette}
      layer.forget()
    },
    draw(ctx, room, style, tip) {
      const {camera, size} = pen
      const now = room.lookedAt ?? room.frame?.time ?? 0
      const span = timeSpan(now)
      const trail = room.lookedAt === null ? room.trail : trailUntil(room.trail, room.lookedAt)
      const growing = trail.at(-1) ?? []
      const manner = `${style} ${style === "time" ? span : 0} ${room.lookedAt}`
      // All pieces but the last are finished.
      const done = Math.max(0, trail.length - 1)
      const covered = layer.covers(camera, size)
      const goesOn =
        covered &&
        kept?.manner === manner &&
        (kept.pieces === 0 || (kept.pieces <= done && kept.first === trail[0]))
      if (covered && !goesOn) {
        layer.forget()
        layer.covers(camera, size)
      }
      const drawn = goesOn ? (kept?.pieces ?? 0) : 0
      for (const piece of trail.slice(drawn, done)) drawLine(layer.ctx, pen, piece, style, span)
      kept = {manner, first: trail[0], pieces: done}
      layer.show(ctx, camera)

      const k = size.ratio * camera.scale
      ctx.setTransform(k, 0, 0, -k, camera.left * size.ratio, camera.bottom * size.ratio)
      const last = growing.at(-1)
      const passed = room.lookedAt === null ? growing.slice(0, -1) : growing
      if (last !== undefined) drawLine(ctx, pen, [...passed, {...last, ...tip}], style, span)
      if (style === "time") drawMarks(ctx, pen, trail, now)
    },
  }
}

function drawLine(
  c: CanvasRenderingContext2D,
  {palette, camera}: Pen,
  piece: readonly Point[],
  style: TrailStyle,
  span: number,
): void {
  const levelOf = (p: Point) =>
    style === "speed" ? speedLevel(p.speed) : style === "time" ? timeLevel(p.time, span) : 0
  c.lineJoin = "round"
  c.lineCap = "round"
  for (const {level, points} of segmentsOf(piece, levelOf, apart / camera.scale)) {
    const width = widths[style][level] ?? widths.plain[0]
    c.lineWidth = Math.max(width / camera.scale, width / perMetre)
    c.strokeStyle = style === "plain" ? palette.trail : (palette.ramp[level] ?? palette.trail)
    c.beginPath()
    points.forEach((p, i) => {
      if (i === 0) c.moveTo(p.x, p.y)
      else c.lineTo(p.x, p.y)
    })
    c.stroke()
  }
}

/// The times at points of the trail.
function drawMarks(
  ctx: CanvasRenderingContext2D,
  {palette, camera, size}: Pen,
  trail: Trail,
  now: number,
): void {
  ctx.setTransform(size.ratio, 0, 0, size.ratio, 0, 0)
  ctx.font = `500 12px ${palette.font}`
  ctx.textAlign = "left"
  ctx.textBaseline = "middle"
  ctx.lineJoin = "round"
  for (const p of timeMarks(trail, now, 26 / camera.scale)) {
    const at = toScreen(camera, p.x, p.y)
    ctx.beginPath()
    ctx.arc(at.x, at.y, 4, 0, 2 * Math.PI)
    ctx.fillStyle = palette.floor
    ctx.fill()
    ctx.lineWidth = 1.75
    ctx.strokeStyle = palette.ink
    ctx.stroke()
    ctx.lineWidth = 3.5
    ctx.strokeStyle = palette.floor
    const text = `${p.time} s`
    ctx.strokeText(text, at.x + 6, at.y - 10)
    ctx.fillStyle = palette.ink
    ctx.fillText(text, at.x + 6, at.y - 10)
  }
}

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
