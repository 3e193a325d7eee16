/// Drawing of the static world: floor, grid, holes, walls, objects, goals; and thumbnails of a room. In metres; the context is already scaled.

import type {Ink} from "../../state/runs/ink.ts"
import {type Pose, placesOf, type World, wallThickness} from "../../worlds/world.ts"
import {cornerOf, lookAt, viewOfPath} from "./camera.ts"
import {type Palette, readPalette} from "./palette.ts"
import {drawMark} from "./preview_drawing.ts"
import {drawRobot, usualRadius} from "./robot_drawing.ts"
import {drawInk} from "./trail_drawing.ts"

export function drawWorld(
  ctx: CanvasRenderingContext2D,
  world: World,
  palette: Palette,
  scale: number,
): void {
  const [width, height] = world.size
  ctx.fillStyle = palette.floor
  if (world.open) {
    const [left, bottom] = cornerOf(world)
    ctx.save()
    ctx.translate(left, bottom)
    ctx.fillRect(0, 0, width, height)
    drawGrid(ctx, width, height, palette, scale)
    ctx.restore()
    drawStart(ctx, palette, scale)
    return
  }
  ctx.fillRect(0, 0, width, height)
  drawGrid(ctx, width, height, palette, scale)
  drawTiles(ctx, world, palette, scale)
  drawUnknown(ctx, world, palette, scale)
  drawLines(ctx, world, palette)
  ctx.lineCap = "round"
  ctx.strokeStyle = palette.wall
  ctx.lineWidth = wallThickness
  for (const {from, to} of world.walls) {
    ctx.beginPath()
    ctx.moveTo(from[0], from[1])
    ctx.lineTo(to[0], to[1])
    ctx.stroke()
  }
  if (world.dock !== null) drawDock(ctx, world.dock, palette, scale)
  drawGoals(ctx, world, palette, scale)
  drawObjects(ctx, world, null, palette, scale)
  // The outer border of `size` is always a wall; it is drawn outside, so that the whole floor shows.
  const border = Math.max(wallThickness, 5 / scale)
  ctx.lineJoin = "round"
  ctx.lineWidth = border
  ctx.strokeStyle = palette.wall
  ctx.strokeRect(-border / 2, -border / 2, width + border, height + border)
}

/// The lines that the line sensor sees, as dark as the words of the page.
function drawLines(ctx: CanvasRenderingContext2D, {lines}: World, palette: Palette): void {
  ctx.lineCap = "round"
  ctx.lineJoin = "round"
  ctx.strokeStyle = palette.ink
  for (const {points, width} of lines) {
    ctx.lineWidth = width
    ctx.beginPath()
    for (const [x, y] of points) ctx.lineTo(x, y)
    ctx.stroke()
  }
}

/// Distance of the lines that hatch what no scan has seen, in CSS pixels.
const hatching = 8

/// What no scan has seen: hatched as one area, below the walls.
function drawUnknown(ctx: CanvasRenderingContext2D, world: World, palette: Palette, scale: number): void {
  const unknown = world.boxes.filter(box => box.unknown)
  if (unknown.length === 0) return
  const [width, height] = world.size
  ctx.save()
  ctx.beginPath()
  for (const {x, y, w, h, theta} of unknown) {
    const [c, s] = [Math.cos(theta) / 2, Math.sin(theta) / 2]
    ctx.moveTo(x - c * w + s * h, y - s * w - c * h)
    ctx.lineTo(x + c * w + s * h, y + s * w - c * h)
    ctx.lineTo(x + c * w - s * h, y + s * w + c * h)
    ctx.lineTo(x - c * w - s * h, y - s * w + c * h)
    ctx.closePath()
  }
  ctx.fillStyle = palette.around
  ctx.fill()
  ctx.clip()
  ctx.beginPath()
  const gap = hatching / scale
  for (let left = -height; left < width; left += gap) {
    ctx.moveTo(left, 0)
    ctx.lineTo(left + height, height)
  }
  ctx.lineWidth = 1.5 / scale
  ctx.strokeStyle = palette.wall
  ctx.stroke()
  ctx.restore()
}

/// A cross where the robot started.
function drawStart(ctx: CanvasRenderingContext2D, palette: Palette, scale: number): void {
  ctx.strokeStyle = palette.wall
  ctx.lineWidth = 1.5 / scale
  ctx.beginPath()
  ctx.moveTo(-0.08, 0)
  ctx.lineTo(0.08, 0)
  ctx.moveTo(0, -0.08)
  ctx.lineTo(0, 0.08)
  ctx.stroke()
}

/// The dock: a plate with two contacts, ahead of where a docked robot stands.
function drawDock(ctx: CanvasRenderingContext2D, dock: Pose, palette: Palette, scale: number): void {
  ctx.save()
  ctx.translate(dock.x, dock.y)
  ctx.rotate(dock.theta)
  ctx.lineWidth = 1.5 / scale
  ctx.strokeStyle = palette.wall
  ctx.fillStyle = palette.solid
  ctx.beginPath()
  ctx.roundRect(usualRadius, -0.12, 0.08, 0.24, 0.02)
  ctx.fill()
  ctx.beginPath()
  for (const y of [-0.04, 0.04]) {
    ctx.moveTo(usualRadius, y)
    ctx.lineTo(usualRadius - 0.05, y)
  }
  ctx.arc(0, 0, usualRadius, -0.5, 0.5)
  ctx.stroke()
  ctx.restore()
}

/// A line every half metre, so that a learner can read distances.
function drawGrid(
  ctx: CanvasRenderingContext2D,
  width: number,
  height: number,
  palette: Palette,
  scale: number,
): void {
  ctx.strokeStyle = palette.grid
  ctx.lineWidth = 1 / scale
  ctx.beginPath()
  for (let x = 0.5; x < width; x += 0.5) {
    ctx.moveTo(x, 0)
    ctx.lineTo(x, height)
  }
  for (let y = 0.5; y < height; y += 0.5) {
    ctx.moveTo(0, y)
    ctx.lineTo(width, y)
  }
  ctx.stroke()
}

/// Boxes and rounds: those that stand fast, or (with `moved`) those that can be pushed, where they are now.
export function drawObjects(
  ctx: CanvasRenderingContext2D,
  world: World,
  moved: readonly (readonly [number, number, number])[] | null,
  palette: Palette,
  scale: number,
): void {
  const movable = moved !== null
  const boxes = world.boxes.filter(b => b.movable === movable && !b.unknown)
  const rounds = world.rounds.filter(r => r.movable === movable)
  boxes.forEach((box, i) => {
    const [x, y, theta] = moved?.[i] ?? [box.x, box.y, box.theta]
    ctx.save()
    ctx.translate(x, y)
    ctx.rotate(theta)
    ctx.beginPath()
    ctx.roundRect(-box.w / 2, -box.h / 2, box.w, box.h, Math.min(0.03, box.w / 4, box.h / 4))
    drawThing(ctx, movable, palette, scale)
    ctx.restore()
  })
  rounds.forEach((round, i) => {
    const [x, y] = moved?.[boxes.length + i] ?? [round.x, round.y]
    ctx.beginPath()
    ctx.arc(x, y, round.r, 0, 2 * Math.PI)
    drawThing(ctx, movable, palette, scale)
  })
}

/// Places of goals: rings to reach, a dashed line to cross or to follow, crossed rings to stay out of.
function drawGoals(ctx: CanvasRenderingContext2D, world: World, palette: Palette, scale: number): void {
  ctx.save()
  ctx.lineWidth = 2 / scale
  ctx.setLineDash([6 / scale, 5 / scale])
  for (const goal of world.goals) {
    const {points, r} = placesOf(goal)
    ctx.strokeStyle = goal.kind === "avoid" ? palette.avoid : palette.goal
    ctx.fillStyle = ctx.strokeStyle
    if (r > 0)
      for (const [x, y] of points) {
        ctx.beginPath()
        ctx.arc(x, y, r, 0, 2 * Math.PI)
        ctx.globalAlpha = 0.12
        ctx.fill()
        ctx.globalAlpha = 1
        if (goal.kind === "avoid") {
          ctx.moveTo(x - r * 0.7, y - r * 0.7)
          ctx.lineTo(x + r * 0.7, y + r * 0.7)
        }
        ctx.stroke()
      }
    else {
      ctx.beginPath()
      points.forEach(([x, y], i) => {
        if (i === 0) ctx.moveTo(x, y)
        else ctx.lineTo(x, y)
      })
      ctx.stroke()
    }
  }
  ctx.restore()
}

/// What can be pushed is light with an outline, what cannot is as dark as a wall.
function drawThing(ctx: CanvasRenderingContext2D, movable: boolean, palette: Palette, scale: number): void {
  ctx.fillStyle = movable ? palette.box : palette.wall
  ctx.fill()
  if (!movable) return
  ctx.lineWidth = 1.5 / scale
  ctx.strokeStyle = palette.wall
  ctx.stroke()
}

function drawTiles(ctx: CanvasRenderingContext2D, world: World, palette: Palette, scale: number): void {
  const {tile, tiles} = world
  const rows = tiles.map(row => [...row])
  const isWall = (r: number, c: number) => (rows[r]?.[c] ?? "#") === "#"
  const edges: (readonly [number, number, number, number])[] = []
  rows.forEach((row, r) => {
    // The first row is the top.
    const top = world.size[1] - r * tile
    row.forEach((cell, c) => {
      const left = c * tile
      if (cell === ".") return
      ctx.fillStyle = cell === "O" ? palette.hole : palette.solid
      // Half a centimetre of overlap hides the seams between neighbours.
      ctx.fillRect(left - 0.005, top - tile - 0.005, tile + 0.01, tile + 0.01)
      if (cell !== "#") return
      const edge = (open: boolean, x1: number, y1: number, x2: number, y2: number) => {
        if (open) edges.push([x1, y1, x2, y2])
      }
      edge(!isWall(r - 1, c), left, top, left + tile, top)
      edge(!isWall(r + 1, c), left, top - tile, left + tile, top - tile)
      edge(!isWall(r, c - 1), left, top, left, top - tile)
      edge(!isWall(r, c + 1), left + tile, top, left + tile, top - tile)
    })
  })
  // Only the faces that a robot can reach are dark: the rest of a thick wall stays quiet.
  ctx.lineCap = "round"
  ctx.lineWidth = Math.max(wallThickness, 3 / scale)
  ctx.strokeStyle = palette.wall
  ctx.beginPath()
  for (const [x1, y1, x2, y2] of edges) {
    ctx.moveTo(x1, y1)
    ctx.lineTo(x2, y2)
  }
  ctx.stroke()
}

/// In CSS pixels; the page may show it smaller.
const picture = {w: 224, h: 140}
/// A robot that would be a smaller dot than this is drawn larger, in CSS pixels: one sees where it starts.
const leastRobot = 5

const parked = {channels: {}}

/// Width of a path in a picture, in pixels.
const pathWidth = 2

export function drawThumbnail(
  canvas: HTMLCanvasElement,
  world: World,
  path: readonly (readonly [number, number])[] = [],
  bumps: readonly (readonly [number, number])[] = [],
  ink: Ink = [],
): void {
  const ctx = canvas.getContext("2d")
  if (ctx === null) return
  const ratio = window.devicePixelRatio || 1
  canvas.width = picture.w * ratio
  canvas.height = picture.h * ratio
  const palette = readPalette(canvas)
  const [width, height] = world.size
  const camera = lookAt(
    viewOfPath(path, width, height, picture.w, picture.h),
    width,
    height,
    picture.w,
    picture.h,
  )
  const k = ratio * camera.scale
  ctx.setTransform(k, 0, 0, -k, camera.left * ratio, camera.bottom * ratio)
  drawWorld(ctx, world, palette, camera.scale)
  drawObjects(ctx, world, [], palette, camera.scale)
  ctx.beginPath()
  for (const [x, y] of path) ctx.lineTo(x, y)
  ctx.lineWidth = pathWidth / camera.scale
  ctx.lineJoin = "round"
  ctx.lineCap = "round"
  ctx.strokeStyle = palette.trail
  ctx.stroke()
  drawInk(ctx, ink, palette, camera.scale)
  for (const [x, y] of bumps) drawMark(ctx, x, y, "cross", palette, camera.scale)
  ctx.translate(world.start.x, world.start.y)
  ctx.rotate(world.start.theta)
  const larger = Math.max(1, leastRobot / (usualRadius * camera.scale))
  ctx.scale(larger, larger)
  drawRobot(ctx, parked, palette, camera.scale * larger, world.robot)
}
