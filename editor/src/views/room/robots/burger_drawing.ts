/// Drawing of TurtleBot 3 Burger from above (x forwards, y to its left, metres): wheels, deck, laser scanner, buttons.

import {robot} from "@rosy/codegen/robot"
import {isOn, type Sensed} from "../../../state/runs/channels.ts"

const {body} = robot.simulated.turtlebot3
const [deckX, deckY, deckLength, deckWidth] = body.deck

/// The colours of its parts.
export type Colours = Readonly<Record<"body" | "ring" | "hole" | "mark" | "hit", string>>

export function drawBurger(ctx: CanvasRenderingContext2D, frame: Sensed, palette: Colours): void {
  ctx.fillStyle = palette.hole
  for (const side of [1, -1]) {
    ctx.beginPath()
    const y = (side * body.wheelbase) / 2 - body.wheelWidth / 2
    ctx.roundRect(-body.wheelRadius, y, 2 * body.wheelRadius, body.wheelWidth, 0.005)
    ctx.fill()
  }
  ctx.beginPath()
  ctx.roundRect(deckX, deckY, deckLength, deckWidth, 0.025)
  ctx.fillStyle = palette.body
  ctx.fill()
  ctx.lineWidth = 0.006
  ctx.strokeStyle = palette.ring
  ctx.stroke()
  ctx.beginPath()
  ctx.arc(body.scannerForwards, 0, body.scannerRadius * 0.7, 0, 2 * Math.PI)
  ctx.fillStyle = palette.ring
  ctx.fill()
  // The heading.
  ctx.beginPath()
  ctx.moveTo(0.034, 0)
  ctx.lineTo(0.014, 0.02)
  ctx.lineTo(0.014, -0.02)
  ctx.closePath()
  ctx.fillStyle = palette.mark
  ctx.fill()
  body.buttons.forEach(([x, y], i) => {
    const isPressed = isOn(frame, "Button", i)
    ctx.beginPath()
    ctx.arc(x, y, isPressed ? 0.014 : 0.009, 0, 2 * Math.PI)
    ctx.fillStyle = isPressed ? palette.hit : palette.mark
    ctx.fill()
  })
}
