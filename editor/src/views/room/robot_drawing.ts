/// Drawing of the robot from above (x forwards, y to its left, metres) and of its speech bubble.
///
/// LEDs differ by shape and letter as well as by colour; a pressed bumper is thicker as well as brighter.

import {robot} from "@rosy/codegen/robot"
import {isOn, numberAt, type Sensed} from "../../state/runs/channels.ts"
import {aboutRobot, type SimulatedRobot, usualRobot} from "../../worlds/world.ts"
import type {Palette} from "./palette.ts"
import {drawBurger} from "./robots/burger_drawing.ts"

/// Numbers of the description of the usual robot; metres in the base's frame.
const {body} = robot.simulated[robot.usual]
const {radius, wheelRadius, wheelWidth, buttons, leds} = body
const wheelOffset = body.wheelbase / 2
/// Bumper zones in degrees, as [place, from, to]; a small gap lies between them.
const bumperZones = body.bumperBearings.map(
  (bearing, place) => [place, bearing - body.bumperHalfWidth, bearing + body.bumperHalfWidth] as const,
)
/// Cliff sensors, as [place, x, y].
const cliffSensors = body.cliffPoints.map(([x, y], place) => [place, x, y] as const)
/// Letters for the LEDs' colours; black has none.
const ledLetters = ["", "G", "O", "R"]

/// Of the usual robot, m.
export const usualRadius = radius

export function drawRobot(
  ctx: CanvasRenderingContext2D,
  frame: Sensed,
  palette: Palette,
  scale: number,
  robot: SimulatedRobot = usualRobot,
): void {
  if (robot === "turtlebot3") {
    drawBurger(ctx, frame, palette)
    return
  }
  const lights = ledPlaces(scale).map(
    ([x, y], i) => ({x, y, value: numberAt(frame, i === 0 ? "Led1" : "Led2")}) as const,
  )
  for (const light of lights) drawGlow(ctx, light, palette, scale)
  drawBody(ctx, palette)
  drawWheels(ctx, frame, palette)
  drawBumpers(ctx, frame, palette)
  drawCliffs(ctx, frame, palette)
  drawHeading(ctx, palette)
  drawButtons(ctx, frame, palette)
  for (const {x, y, value} of lights) drawLed(ctx, x, y, value, palette, scale)
}

/// Radius of an LED, m: it is seen from an arm's length in a whole room, where the real one would be a point.
export const ledSize = (scale: number): number => Math.min(0.036, Math.max(0.023, 5 / scale))

/// Where the LEDs are drawn, m: as far apart as on the robot, and as far as their size needs.
export function ledPlaces(scale: number): readonly (readonly [number, number])[] {
  const [mx, my] = [0, 1].map(axis => leds.reduce((sum, led) => sum + (led[axis] ?? 0), 0) / leds.length)
  return leds.map(([x, y]) => {
    const [dx, dy] = [x - (mx ?? 0), y - (my ?? 0)]
    const factor = Math.max(1, (1.1 * ledSize(scale)) / Math.hypot(dx, dy))
    return [(mx ?? 0) + factor * dx, (my ?? 0) + factor * dy] as const
  })
}

/// What the laser scanner has measured: the free way ahead, and the points of a scan. Nothing while the program does not listen.
export function drawBeams(
  ctx: CanvasRenderingContext2D,
  frame: Sensed,
  palette: Palette,
  scale: number,
  robot: SimulatedRobot,
): void {
  const {body} = aboutRobot(robot)
  ctx.save()
  ctx.translate("scannerForwards" in body ? body.scannerForwards : 0, 0)
  // Beams that count as ahead, rad to either side.
  const halfAhead = (body.aheadHalfWidth * Math.PI) / 180
  const ahead = frame.channels["Ahead"]?.[0]
  if (typeof ahead === "number") {
    ctx.beginPath()
    ctx.moveTo(0, 0)
    ctx.arc(0, 0, ahead, -halfAhead, halfAhead)
    ctx.closePath()
    ctx.globalAlpha = 0.14
    ctx.fillStyle = palette.preview
    ctx.fill()
    ctx.globalAlpha = 1
    // What was met; the end of the sensor's range is open.
    if (ahead < body.scannerFarthest) {
      ctx.beginPath()
      ctx.arc(0, 0, ahead, -halfAhead, halfAhead)
      ctx.lineWidth = 2 / scale
      ctx.strokeStyle = palette.preview
      ctx.stroke()
    }
  }
  const points = scanPoints(frame)
  // The rays are faint, so that the room stays in sight.
  ctx.strokeStyle = palette.preview
  ctx.globalAlpha = 0.12
  ctx.lineWidth = 1 / scale
  ctx.beginPath()
  for (const [x, y] of points) {
    ctx.moveTo(0, 0)
    ctx.lineTo(x, y)
  }
  ctx.stroke()
  ctx.fillStyle = palette.preview
  ctx.globalAlpha = 0.8
  for (const [x, y] of points) {
    ctx.beginPath()
    ctx.arc(x, y, 1.5 / scale, 0, 2 * Math.PI)
    ctx.fill()
  }
  ctx.restore()
}

/// Where the beams of the last scan met something, in the robot's frame.
export function scanPoints(frame: Sensed): readonly (readonly [number, number])[] {
  const [first, step, , farthest, ...distances] = (frame.channels["Scan"] ?? []).map(Number)
  if (first === undefined || step === undefined || farthest === undefined) return []
  return distances.flatMap((distance, i) =>
    distance < farthest
      ? [[distance * Math.cos(first + i * step), distance * Math.sin(first + i * step)] as const]
      : [],
  )
}

/// Where the robot believes it is: an outline with its heading.
export function drawGhost(
  ctx: CanvasRenderingContext2D,
  palette: Palette,
  scale: number,
  radius: number,
): void {
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

function drawWheels(ctx: CanvasRenderingContext2D, frame: Sensed, palette: Palette): void {
  for (const [place, side] of [
    [0, 1],
    [1, -1],
  ] as const) {
    ctx.beginPath()
    // A wheel in the air hangs out: larger as well as brighter.
    const hangs = isOn(frame, "Wheel", place)
    const grown = hangs ? 0.012 : 0
    const [length, width] = [2 * wheelRadius + 2 * grown, wheelWidth + grown]
    ctx.roundRect(-length / 2, side * wheelOffset - width / 2, length, width, 0.006)
    ctx.fillStyle = hangs ? palette.hit : palette.hole
    ctx.fill()
  }
}

function drawCliffs(ctx: CanvasRenderingContext2D, frame: Sensed, palette: Palette): void {
  for (const [place, x, y] of cliffSensors) {
    const over = isOn(frame, "Cliff", place)
    ctx.beginPath()
    ctx.arc(x, y, over ? 0.021 : 0.01, 0, 2 * Math.PI)
    ctx.fillStyle = over ? palette.hit : palette.mark
    ctx.fill()
    ctx.lineWidth = 0.005
    ctx.strokeStyle = palette.body
    ctx.stroke()
  }
}

function drawBumpers(ctx: CanvasRenderingContext2D, frame: Sensed, palette: Palette): void {
  ctx.lineCap = "butt"
  ctx.lineWidth = 0.012
  ctx.strokeStyle = palette.ring
  ctx.globalAlpha = 0.45
  ctx.beginPath()
  ctx.arc(0, 0, radius - 0.006, Math.PI / 2, (3 * Math.PI) / 2)
  ctx.stroke()
  ctx.globalAlpha = 1
  for (const [place, from, to] of bumperZones) {
    const hit = isOn(frame, "Bumper", place)
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
function drawButtons(ctx: CanvasRenderingContext2D, frame: Sensed, palette: Palette): void {
  buttons.forEach(([x, y], i) => {
    const pressed = isOn(frame, "Button", i)
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

/// Light of an LED on the floor below the robot: in a whole room it shows the colour where the LED itself is a few pixels.
function drawGlow(
  ctx: CanvasRenderingContext2D,
  {x, y, value}: {readonly x: number; readonly y: number; readonly value: number},
  palette: Palette,
  scale: number,
): void {
  if (value === 0) return
  ctx.beginPath()
  ctx.arc(x, y, 12 / scale, 0, 2 * Math.PI)
  ctx.globalAlpha = 0.6
  ctx.fillStyle = palette.leds[value as 1 | 2 | 3] ?? palette.leds[0]
  ctx.fill()
  ctx.globalAlpha = 1
}

function drawLed(
  ctx: CanvasRenderingContext2D,
  x: number,
  y: number,
  value: number,
  palette: Palette,
  scale: number,
): void {
  const size = ledSize(scale)
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

/// Characters shown; the console has the rest.
const longest = 40

/// `lift` is how far from the robot's middle the bubble stands. The result is where it is, in pixels.
export function drawBubble(
  ctx: CanvasRenderingContext2D,
  text: string,
  at: {readonly x: number; readonly y: number},
  lift: number,
  size: {readonly w: number; readonly h: number},
  palette: Palette,
): {readonly left: number; readonly top: number; readonly width: number; readonly height: number} {
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
  return {left, top, width, height: 30}
}
