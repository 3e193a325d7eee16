/// Drawing of the other robots in a room: each in its colour and with its number, which tells them apart without colours.

import {robotRadius, type World} from "../../../worlds/world.ts"
import type {Palette} from "../palette.ts"
import {type Pose, RobotMotion} from "../poses.ts"
import {drawRobot} from "../robot_drawing.ts"

type Places = readonly Pose[]

/// Where the other robots are between two frames.
export class CompanionMotions {
  private readonly motions: RobotMotion[] = []
  /// The last frame and the poses in it, of which each motion keeps one.
  private frame: CompanionFrame | null = null
  private places: readonly (Pose & {readonly run: number})[] = []

  /// As `RobotMotion.poseAt` of each robot; `null` without a frame.
  posesAt(frame: CompanionFrame | null, isLive: boolean, now: number): Places | null {
    if (frame !== this.frame) {
      this.frame = frame
      const {run, others} = {run: 0, others: [], ...frame}
      this.places = (others ?? []).map(([x, y, theta]) => ({x, y, theta, run}))
    }
    if (frame === null) return null
    return this.places.map((place, i) => {
      const motion = this.motions[i] ?? new RobotMotion()
      this.motions[i] = motion
      return motion.poseAt(place, isLive, now) ?? place
    })
  }
}

interface CompanionFrame {
  readonly run: number
  readonly others?: readonly (readonly [number, number, number])[] | null
}

/// They stand at rest in the picture: their lights and sensors are not shown.
const resting = {channels: {}}

/// The context is in metres.
export function drawCompanions(
  ctx: CanvasRenderingContext2D,
  places: Places,
  palette: Palette,
  scale: number,
  world: World,
): void {
  const radius = robotRadius(world)
  places.forEach(({x, y, theta}, i) => {
    const colour = palette.companions[i] ?? palette.ring
    ctx.save()
    ctx.translate(x, y)
    ctx.rotate(theta)
    drawRobot(ctx, resting, {...palette, body: colour}, scale, world.robot)
    ctx.beginPath()
    ctx.arc(0, 0, radius, 0, 2 * Math.PI)
    ctx.strokeStyle = colour
    ctx.lineWidth = 2 / scale
    ctx.stroke()
    // Behind the mark that says which way it looks.
    ctx.translate(-radius / 4, 0)
    ctx.rotate(-theta)
    ctx.scale(1, -1)
    ctx.font = `700 ${radius}px ${palette.font}`
    ctx.textAlign = "center"
    ctx.textBaseline = "middle"
    ctx.fillStyle = palette.mark
    ctx.strokeStyle = colour
    ctx.lineWidth = radius / 4
    ctx.lineJoin = "round"
    ctx.strokeText(`${i + 2}`, 0, radius * 0.05)
    ctx.fillText(`${i + 2}`, 0, radius * 0.05)
    ctx.restore()
  })
}
