/// What the robot says, in a bubble beside it. In pixels, within a view of `size`.

import type {Palette} from "./palette.ts"

/// Characters shown; the console has the rest.
const longest = 40

/// `lift` is how far from the robot's middle the bubble stands.
export function drawBubble(
  ctx: CanvasRenderingContext2D,
  text: string,
  at: {readonly x: number; readonly y: number},
  lift: number,
  size: {readonly w: number; readonly h: number},
  palette: Palette,
): void {
  ctx.font = `500 14px ${palette.font}`
  const short = text.length > longest ? `${text.slice(0, longest - 1)}…` : text
  const width = Math.min(ctx.measureText(short).width + 22, size.w - 8)
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
