/// Draws what does not move: floor, grid, holes, walls and boxes. In metres; the context is already scaled.

import type {World} from "../state/messages.ts"
import type {Palette} from "./palette.ts"

/// protocol §6: walls are 5 cm thick.
const wallThickness = 0.05

export function drawWorld(
  ctx: CanvasRenderingContext2D,
  world: World,
  palette: Palette,
  scale: number,
): void {
  const [width, height] = world.size
  ctx.fillStyle = palette.floor
  ctx.fillRect(0, 0, width, height)
  drawGrid(ctx, width, height, palette, scale)
  drawTiles(ctx, world, palette)
  ctx.lineCap = "round"
  ctx.strokeStyle = palette.wall
  ctx.lineWidth = wallThickness
  for (const {from, to} of world.walls) {
    ctx.beginPath()
    ctx.moveTo(from[0], from[1])
    ctx.lineTo(to[0], to[1])
    ctx.stroke()
  }
  for (const box of world.boxes) {
    ctx.save()
    ctx.translate(box.x, box.y)
    ctx.rotate(box.theta)
    roundBox(ctx, -box.w / 2, -box.h / 2, box.w, box.h, Math.min(0.03, box.w / 4, box.h / 4))
    ctx.fillStyle = box.movable ? palette.box : palette.wall
    ctx.fill()
    if (box.movable) {
      ctx.lineWidth = 1.5 / scale
      ctx.strokeStyle = palette.wall
      ctx.stroke()
    }
    ctx.restore()
  }
  // The outer border of `size` is always a wall; it is drawn outside, so that the whole floor shows.
  const border = Math.max(wallThickness, 5 / scale)
  ctx.lineJoin = "round"
  ctx.lineWidth = border
  ctx.strokeStyle = palette.wall
  ctx.strokeRect(-border / 2, -border / 2, width + border, height + border)
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

function drawTiles(ctx: CanvasRenderingContext2D, world: World, palette: Palette): void {
  const {tile, tiles} = world
  tiles.forEach((row, r) => {
    // The first row is the top.
    const y = world.size[1] - (r + 1) * tile
    ;[...row].forEach((cell, c) => {
      if (cell === ".") return
      ctx.fillStyle = cell === "O" ? palette.hole : palette.wall
      // Half a centimetre of overlap hides the seams between neighbours.
      ctx.fillRect(c * tile - 0.005, y - 0.005, tile + 0.01, tile + 0.01)
    })
  })
}

function roundBox(
  ctx: CanvasRenderingContext2D,
  x: number,
  y: number,
  w: number,
  h: number,
  r: number,
): void {
  ctx.beginPath()
  ctx.roundRect(x, y, w, h, r)
}
