/// Draws the Kobuki from above: x forwards, y to its left. Metres.
///
/// LEDs differ by shape and letter as well as by colour; a pressed bumper is thicker as well as brighter.

import type {Frame} from "../state/messages.ts"
import type {Palette} from "./palette.ts"

/// Kobuki's diameter is 351.5 mm (factory drawing, 2012-11-30).
const radius = 0.17575
/// Half the wheelbase of 0.230 m (kobuki_core, diff_drive: `bias`); wheel radius and width beside it.
const wheelOffset = 0.115
const wheelRadius = 0.035
const wheelWidth = 0.021
/// Bumper zones of 60° each (kobuki_gazebo plugin), as [bit, from, to]; a small gap lies between them.
const bumperZones: readonly (readonly [number, number, number])[] = [
  [1, -90, -30],
  [2, -30, 30],
  [4, 30, 90],
]
/// Cliff sensors in the base's frame, as [bit, x, y] (kobuki_description).
const cliffSensors: readonly (readonly [number, number, number])[] = [
  [1, 0.085, -0.13601],
  [2, 0.156, 0],
  [4, 0.08734, 0.13601],
]
/// Buttons 0 to 2, as x, y: to the right on the rear panel; the LEDs are to its left (Kobuki user guide, "Control panel").
const buttons: readonly (readonly [number, number])[] = [
  [-0.126, -0.018],
  [-0.117, -0.056],
  [-0.096, -0.089],
]
const leds: readonly (readonly [number, number])[] = [
  [-0.098, 0.082],
  [-0.118, 0.034],
]
/// Letters for the LEDs' colours; black has none.
const ledLetters = ["", "G", "O", "R"]

export function drawRobot(
  ctx: CanvasRenderingContext2D,
  frame: Pick<Frame, "bumpers" | "cliffs" | "wheels" | "buttons" | "led1" | "led2">,
  palette: Palette,
  scale: number,
): void {
  drawBody(ctx, palette)
  drawWheels(ctx, frame.wheels, palette)
  drawBumpers(ctx, frame.bumpers, palette)
  drawCliffs(ctx, frame.cliffs, palette)
  drawHeading(ctx, palette)
  drawButtons(ctx, frame.buttons, palette)
  leds.forEach(([x, y], i) => {
    drawLed(ctx, x, y, i === 0 ? frame.led1 : frame.led2, palette, scale)
  })
}

/// Where the robot believes it is: an outline with its heading.
export function drawGhost(ctx: CanvasRenderingContext2D, palette: Palette, scale: number): void {
  ctx.strokeStyle = palette.wall
  ctx.lineWidth = 1.5 / scale
  ctx.setLineDash([5 / scale, 4 / scale])
  ctx.beginPath()
  ctx.arc(0, 0, radius, 0, 2 * Math.PI)
  ctx.moveTo(radius * 0.3, 0)
  ctx.lineTo(radius, 0)
  ctx.stroke()
  ctx.setLineDash([])
}

function drawBody(ctx: CanvasRenderingContext2D, palette: Palette): void {
  ctx.beginPath()
  ctx.arc(0, 0, radius - 0.012, 0, 2 * Math.PI)
  ctx.fillStyle = palette.body
  ctx.fill()
}

function drawWheels(ctx: CanvasRenderingContext2D, bits: number, palette: Palette): void {
  for (const [bit, side] of [
    [2, 1],
    [1, -1],
  ] as const) {
    ctx.beginPath()
    // A wheel in the air hangs out: larger as well as brighter.
    const hangs = (bits & bit) !== 0
    const grown = hangs ? 0.012 : 0
    const [length, width] = [2 * wheelRadius + 2 * grown, wheelWidth + grown]
    ctx.roundRect(-length / 2, side * wheelOffset - width / 2, length, width, 0.006)
    ctx.fillStyle = hangs ? palette.hit : palette.hole
    ctx.fill()
  }
}

function drawCliffs(ctx: CanvasRenderingContext2D, bits: number, palette: Palette): void {
  for (const [bit, x, y] of cliffSensors) {
    const over = (bits & bit) !== 0
    ctx.beginPath()
    ctx.arc(x, y, over ? 0.021 : 0.01, 0, 2 * Math.PI)
    ctx.fillStyle = over ? palette.hit : palette.mark
    ctx.fill()
    ctx.lineWidth = 0.005
    ctx.strokeStyle = palette.body
    ctx.stroke()
  }
}

function drawBumpers(ctx: CanvasRenderingContext2D, bits: number, palette: Palette): void {
  ctx.lineCap = "butt"
  ctx.lineWidth = 0.012
  ctx.strokeStyle = palette.ring
  ctx.globalAlpha = 0.45
  ctx.beginPath()
  ctx.arc(0, 0, radius - 0.006, Math.PI / 2, (3 * Math.PI) / 2)
  ctx.stroke()
  ctx.globalAlpha = 1
  for (const [bit, from, to] of bumperZones) {
    const hit = (bits & bit) !== 0
    const gap = 1.5
    ctx.beginPath()
    ctx.lineWidth = hit ? 0.034 : 0.018
    ctx.strokeStyle = hit ? palette.hit : palette.ring
    ctx.arc(
      0,
      0,
      radius - (hit ? 0.013 : 0.009),
      ((from + gap) * Math.PI) / 180,
      ((to - gap) * Math.PI) / 180,
    )
    ctx.stroke()
  }
}

/// A pressed button is filled and larger.
function drawButtons(ctx: CanvasRenderingContext2D, bits: number, palette: Palette): void {
  buttons.forEach(([x, y], i) => {
    const pressed = (bits & (1 << i)) !== 0
    ctx.beginPath()
    ctx.arc(x, y, pressed ? 0.02 : 0.013, 0, 2 * Math.PI)
    ctx.lineWidth = 0.004
    ctx.strokeStyle = palette.ring
    ctx.fillStyle = pressed ? palette.hit : palette.body
    ctx.fill()
    ctx.stroke()
  })
}

function drawHeading(ctx: CanvasRenderingContext2D, palette: Palette): void {
  ctx.beginPath()
  ctx.moveTo(0.098, 0)
  ctx.lineTo(0.034, 0.037)
  ctx.lineTo(0.05, 0)
  ctx.lineTo(0.034, -0.037)
  ctx.closePath()
  ctx.fillStyle = palette.mark
  ctx.fill()
}

function drawLed(
  ctx: CanvasRenderingContext2D,
  x: number,
  y: number,
  value: number,
  palette: Palette,
  scale: number,
): void {
  const size = 0.023
  ctx.beginPath()
  // Green is round, orange a diamond, red a square; dark is a small ring.
  if (value === 2) {
    ctx.moveTo(x + size * 1.2, y)
    ctx.lineTo(x, y + size * 1.2)
    ctx.lineTo(x - size * 1.2, y)
    ctx.lineTo(x, y - size * 1.2)
    ctx.closePath()
  } else if (value === 3) {
    ctx.roundRect(x - size * 0.92, y - size * 0.92, size * 1.84, size * 1.84, 0.005)
  } else {
    ctx.arc(x, y, value === 0 ? size * 0.7 : size, 0, 2 * Math.PI)
  }
  ctx.fillStyle = palette.leds[value as 0 | 1 | 2 | 3] ?? palette.leds[0]
  ctx.fill()
  const letter = ledLetters[value] ?? ""
  // Letters smaller than some 9 px cannot be read; the shape still tells.
  if (letter === "" || scale * size * 1.5 < 6) return
  ctx.save()
  ctx.translate(x, y)
  ctx.rotate(-Math.PI / 2)
  ctx.scale(1, -1)
  ctx.font = `700 ${size * 1.5}px ${palette.font}`
  ctx.textAlign = "center"
  ctx.textBaseline = "middle"
  ctx.fillStyle = "#11151b"
  ctx.fillText(letter, 0, size * 0.08)
  ctx.restore()
}
