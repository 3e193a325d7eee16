/// The picture of the room on its canvas: what is drawn of a state, on which layers, and where things are in it. Static parts and finished pieces of the trail are cached on layers.

import type {Frame} from "../../state/messages/messages.ts"
import {shownPreview} from "../../state/messages/preview.ts"
import {
  type RoomState,
  shownFrame,
  speech,
  type Trail,
  type TrailStyle,
  type Words,
} from "../../state/runs/room_state.ts"
import {robotRadius, type World} from "../../worlds/world.ts"
import {type Layer, openLayer} from "./cached_layer.ts"
import {toScreen, Viewport} from "./camera.ts"
import {handleOf} from "./gestures.ts"
import type {Overlay} from "./overlay.ts"
import {drawOverlay, drawRunNames} from "./overlay_drawing.ts"
import {type Palette, readPalette} from "./palette.ts"
import {type MovableObject, movableObjectsOf, type Pose, RobotMotion} from "./poses.ts"
import {drawPreview} from "./preview_drawing.ts"
import {type QuestionTarget, type Spot, targetAt} from "./question_targets.ts"
import {drawBeams, drawBubble, drawGhost, drawRobot} from "./robot_drawing.ts"
import {CompanionMotions, drawCompanions} from "./robots/companion_drawing.ts"
import {type InkView, openInk, openPath, type PathView} from "./trail_drawing.ts"
import {trailUntil} from "./trail_segments.ts"
import {drawObjects, drawWorld} from "./world_drawing.ts"

/// How the learner wants to see the room.
export interface RoomViewOptions {
  readonly trail: TrailStyle
  /// The picture goes with the robot.
  readonly follows: boolean
  /// Hands can take hold of things: a program runs, and the learner looks at it as it is now.
  readonly hands: boolean
  /// The thing that the keyboard holds.
  readonly held: number | null
  /// Where other robots start before a run.
  readonly companions?: readonly Pose[]
  /// A run to compare with the shown one, and the names of both.
  readonly overlay: (Overlay & {readonly names: {readonly shown: string; readonly compared: string}}) | null
}

const parked = {channels: {}}

export class RoomPicture {
  readonly viewport = new Viewport()
  follows = false
  hands: {readonly able: boolean; readonly held: number | null; readonly handle: boolean} = {
    able: false,
    held: null,
    handle: false,
  }
  /// Where the robot is drawn, and what can be pushed.
  robot: Pose | null = null
  things: readonly MovableObject[] = []
  /// The other robots where a hand can take hold of them: before a run.
  companions: readonly Pose[] = []
  private readonly canvas: HTMLCanvasElement
  private readonly ctx: CanvasRenderingContext2D
  private readonly motion = new RobotMotion()
  private readonly otherMotions = new CompanionMotions()
  private readonly ground: Layer
  private readonly path: PathView
  private readonly ink: InkView
  private palette: Palette
  private trail: Trail = []
  /// The speech bubble where it is drawn, in pixels.
  private bubble: {readonly words: Words; readonly box: ReturnType<typeof drawBubble>} | null = null
  // Without a run there is nothing to ask about.
  private canAsk = false
  /// The state of the last drawing; `null` forces a new one.
  private drawn: {readonly room: RoomState; readonly sight: RoomViewOptions} | null = null

  constructor(canvas: HTMLCanvasElement) {
    const ctx = canvas.getContext("2d", {alpha: false})
    if (ctx === null) throw new Error("expected a canvas with a 2d context, found none")
    this.canvas = canvas
    this.ctx = ctx
    this.palette = readPalette(canvas)
    const margin = () => this.viewport.margin()
    this.ground = openLayer(margin)
    this.path = openPath(this.palette, margin)
    this.ink = openInk(this.palette, margin)
  }

  invalidate(): void {
    this.drawn = null
  }

  recolour(): void {
    this.palette = readPalette(this.canvas)
    this.path.recolour(this.palette)
    this.ink.recolour(this.palette)
    this.ground.forget()
  }

  targetAt(at: Spot, reach: number): QuestionTarget | null {
    if (!this.canAsk) return null
    if (this.bubble !== null && isWithin(this.bubble.box, toScreen(this.viewport.camera, at.x, at.y)))
      return {kind: "speech", ...this.bubble.words}
    return targetAt(this.robot, this.trail, at, reach, this.viewport.world?.robot)
  }

  /// As `RoomView.draw`.
  draw(room: RoomState, sight: RoomViewOptions, now: number): boolean {
    const {ctx, drawn} = this
    if (drawn !== null && looksSame(drawn.room, room) && isSameSight(drawn.sight, sight)) return false
    this.follows = sight.follows
    this.hands = {...this.hands, able: sight.hands, held: sight.held}
    ctx.setTransform(1, 0, 0, 1, 0, 0)
    ctx.fillStyle = this.palette.around
    ctx.fillRect(0, 0, this.canvas.width, this.canvas.height)
    this.drawn = {room, sight}
    if (room.world === null) {
      this.robot = null
      this.things = []
      this.companions = []
      this.bubble = null
      return false
    }
    this.drawRoom(room, room.world, sight, now)
    const moves = this.motion.isMoving(now)
    if (moves) this.drawn = null
    return moves
  }

  private drawRoom(room: RoomState, world: World, sight: RoomViewOptions, now: number): void {
    const {ctx, viewport, palette} = this
    const {overlay} = sight
    const frame = shownFrame(room)
    const pose = this.motion.poseAt(frame, room.lookedAt === null, now) ?? world.start
    this.robot = pose
    this.canAsk = room.run !== null
    this.trail = room.lookedAt === null ? room.trail : trailUntil(room.trail, room.lookedAt)
    this.drawGround(world, pose)
    const {scale} = viewport.camera
    const preview = shownPreview(room.preview)
    viewport.inMetres(ctx)
    if (preview !== null)
      drawPreview(ctx, preview.preview, preview.current, palette, scale, robotRadius(world))
    if (overlay !== null) drawOverlay(ctx, overlay, palette, scale, robotRadius(world))
    this.path.draw(ctx, room, sight.trail, pose)
    // Over the trail, which would hide a line as thin as itself.
    this.ink.draw(ctx, room.ink, room.lookedAt)
    viewport.inMetres(ctx)
    this.things = movableObjectsOf(world, frame?.boxes ?? [])
    drawObjects(ctx, world, frame?.boxes ?? [], palette, scale)
    const moved = room.run === null ? null : this.otherMotions.posesAt(frame, room.lookedAt === null, now)
    const starts = sight.companions ?? []
    this.companions = room.run === null ? starts : []
    drawCompanions(ctx, moved ?? starts, palette, scale, world)
    this.drawRobots(frame, pose, world)
    if (this.hands.able) drawHands(ctx, this.hands, pose, this.things, palette, scale)
    viewport.inPixels(ctx)
    if (overlay !== null)
      drawRunNames(ctx, overlay.names, {shown: pose, compared: overlay.pose}, viewport.camera, palette)
    this.drawSpeech(speech(room), pose)
  }

  private drawGround(world: World, robot: Pose): void {
    const {viewport, ground} = this
    if (world !== viewport.world) ground.forget()
    viewport.show(world, robot, this.follows)
    const {camera, size} = viewport
    this.path.place(camera, size)
    this.ink.place(camera, size)
    if (!ground.covers(camera, size)) drawWorld(ground.ctx, world, this.palette, camera.scale)
    ground.show(this.ctx, camera)
  }

  /// The robot with what its scanner measured, and where it believes it is.
  private drawRobots(frame: Frame | null, {x, y, theta}: Pose, world: World): void {
    const {ctx, palette} = this
    const {scale} = this.viewport.camera
    if (frame !== null && frame.ghost !== null)
      drawAt(ctx, ...frame.ghost, () => drawGhost(ctx, palette, scale, robotRadius(world)))
    if (frame !== null) drawAt(ctx, x, y, theta, () => drawBeams(ctx, frame, palette, scale, world.robot))
    drawAt(ctx, x, y, theta, () => drawRobot(ctx, frame ?? parked, palette, scale, world.robot))
  }

  private drawSpeech(words: Words | null, robot: Pose): void {
    this.bubble = null
    if (words === null) return
    const {camera, size} = this.viewport
    const at = toScreen(camera, robot.x, robot.y)
    const box = drawBubble(this.ctx, words.text, at, 0.2 * camera.scale + 14, size, this.palette)
    this.bubble = {words, box}
  }
}

function drawAt(ctx: CanvasRenderingContext2D, x: number, y: number, theta: number, draw: () => void): void {
  ctx.save()
  ctx.translate(x, y)
  ctx.rotate(theta)
  draw()
  ctx.restore()
}

/// Whether a room looks as another does: a question for a preview is not seen.
function looksSame(one: RoomState, other: RoomState): boolean {
  if (one === other) return true
  const keys = Object.keys(one) as (keyof RoomState)[]
  const [mine, others] = [shownPreview(one.preview), shownPreview(other.preview)]
  return (
    keys.every(key => key === "preview" || one[key] === other[key]) &&
    mine?.preview === others?.preview &&
    mine?.current === others?.current
  )
}

/// Two runs that are compared are always drawn.
function isSameSight(one: RoomViewOptions, other: RoomViewOptions): boolean {
  const keys = Object.keys(one) as (keyof RoomViewOptions)[]
  return keys.every(key => one[key] === other[key])
}

function isWithin(
  {left, top, width, height}: ReturnType<typeof drawBubble>,
  {x, y}: {readonly x: number; readonly y: number},
): boolean {
  return left <= x && x <= left + width && top <= y && y <= top + height
}

/// The handle that turns the robot, and a ring around the thing that the keyboard holds.
function drawHands(
  ctx: CanvasRenderingContext2D,
  hands: {readonly held: number | null; readonly handle: boolean},
  robot: Pose,
  things: readonly MovableObject[],
  palette: Palette,
  scale: number,
): void {
  ctx.strokeStyle = palette.trail
  ctx.fillStyle = palette.trail
  ctx.lineWidth = 2 / scale
  const thing = hands.held === null ? undefined : things[hands.held]
  if (thing !== undefined) {
    ctx.beginPath()
    ctx.arc(thing.x, thing.y, Math.max(0.12, 12 / scale), 0, 2 * Math.PI)
    ctx.stroke()
  }
  if (!hands.handle) return
  const {x, y} = handleOf(robot)
  ctx.beginPath()
  ctx.arc(x, y, 6.5 / scale, 0, 2 * Math.PI)
  ctx.fill()
}
