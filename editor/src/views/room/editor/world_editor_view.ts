/// Canvas of the world editor: the edited room, the selection with its handles, and pointer input. Draws the state and reports edits.

import type {WorldEdit, WorldEditor} from "../../../worlds/editor_value.ts"
import {handlesOf} from "../../../worlds/part_handles.ts"
import {type Box, placesOf, type Spot, type World, wallThickness} from "../../../worlds/world.ts"
import type {Part} from "../../../worlds/world_parts.ts"
import {type Camera, type CameraView, lookAt, pan, toRoom, zoom} from "../camera.ts"
import {type Palette, readPalette} from "../palette.ts"
import {drawRobot} from "../robot_drawing.ts"
import {drawObjects, drawWorld} from "../world_drawing.ts"
import {worldKey} from "./world_editor_shortcuts.ts"

export interface WorldEditorView {
  draw(editor: WorldEditor): void
  recolour(): void
  dispose(): void
}

export interface WorldEditorListener {
  /// The picture must be drawn again.
  changed(): void
  edited(edit: WorldEdit): void
}

const parked = {channels: {}}
/// How far around a mouse and a finger are meant, in pixels.
const mouseReach = 8
const fingerReach = 20

export function openWorldEditor(canvas: HTMLCanvasElement, listener: WorldEditorListener): WorldEditorView {
  const ctx = canvas.getContext("2d")
  if (ctx === null) throw new Error("expected a canvas with a 2d context, found none")
  let palette = readPalette(canvas)
  let size = {w: 0, h: 0, ratio: 1}
  let look: CameraView = null
  let camera: Camera = {scale: 1, left: 0, bottom: 0}
  let drawn: WorldEditor | null = null

  const watcher = new ResizeObserver(() => {
    const box = canvas.getBoundingClientRect()
    size = {w: box.width, h: box.height, ratio: window.devicePixelRatio || 1}
    canvas.width = Math.max(1, Math.round(size.w * size.ratio))
    canvas.height = Math.max(1, Math.round(size.h * size.ratio))
    listener.changed()
  })
  watcher.observe(canvas)
  const looked = (to: CameraView) => {
    look = to
    listener.changed()
  }
  watchHands(canvas, {
    editor: () => drawn,
    edited: edit => listener.edited(edit),
    roomAt: (x, y) => {
      const p = toRoom(camera, x, y)
      return [p.x, p.y]
    },
    metres: pixels => pixels / camera.scale,
    panned: (dx, dy) => looked(pan(look, camera, size.w, size.h, dx, dy)),
    zoomed: (factor, x, y) => looked(zoom(look, camera, size, factor, x, y)),
    fitted: () => looked(null),
  })

  return {
    draw(editor) {
      drawn = editor
      const {world} = editor
      camera = lookAt(look, world.size[0], world.size[1], size.w, size.h)
      ctx.setTransform(1, 0, 0, 1, 0, 0)
      ctx.clearRect(0, 0, canvas.width, canvas.height)
      const k = size.ratio * camera.scale
      ctx.setTransform(k, 0, 0, -k, camera.left * size.ratio, camera.bottom * size.ratio)
      drawWorld(ctx, world, palette, camera.scale)
      drawObjects(ctx, world, [], palette, camera.scale)
      ctx.save()
      ctx.translate(world.start.x, world.start.y)
      ctx.rotate(world.start.theta)
      drawRobot(ctx, parked, palette, camera.scale, world.robot)
      ctx.restore()
      if (editor.chosen !== null) drawChosen(ctx, world, editor.chosen, palette, camera.scale)
      if (editor.aim !== null) drawAim(ctx, editor.aim, palette, camera.scale)
    },
    recolour() {
      palette = readPalette(canvas)
      listener.changed()
    },
    dispose() {
      watcher.disconnect()
    },
  }
}

// What is chosen

function drawChosen(
  ctx: CanvasRenderingContext2D,
  world: World,
  part: Part,
  palette: Palette,
  scale: number,
): void {
  ctx.save()
  ctx.strokeStyle = palette.trail
  ctx.lineWidth = 2.5 / scale
  ctx.lineCap = "round"
  ctx.beginPath()
  outline(ctx, world, part)
  ctx.stroke()
  for (const handle of handlesOf(world, part)) {
    const [x, y] = handle.at
    const r = 6.5 / scale
    ctx.beginPath()
    if (handle.name === "corner") ctx.rect(x - r * 0.85, y - r * 0.85, r * 1.7, r * 1.7)
    else ctx.arc(x, y, r, 0, 2 * Math.PI)
    ctx.fillStyle = handle.name === "turn" ? palette.trail : palette.floor
    ctx.fill()
    ctx.stroke()
  }
  ctx.restore()
}

function outline(ctx: CanvasRenderingContext2D, world: World, part: Part): void {
  const circle = (x: number, y: number, r: number) => {
    ctx.moveTo(x + r, y)
    ctx.arc(x, y, r, 0, 2 * Math.PI)
  }
  const line = (from: Spot, to: Spot) => {
    ctx.moveTo(...from)
    ctx.lineTo(...to)
  }
  switch (part.kind) {
    case "start":
      circle(world.start.x, world.start.y, 0.2)
      break
    case "wall": {
      const wall = world.walls[part.index]
      if (wall !== undefined) line(wall.from, wall.to)
      break
    }
    case "box": {
      const box = world.boxes[part.index]
      if (box !== undefined) rectangle(ctx, box)
      break
    }
    case "round": {
      const round = world.rounds[part.index]
      if (round !== undefined) circle(round.x, round.y, round.r)
      break
    }
    case "line":
      for (const [i, p] of (world.lines[part.index]?.points ?? []).entries())
        if (i > 0) line(world.lines[part.index]?.points[i - 1] ?? p, p)
      break
    case "goal": {
      const goal = world.goals[part.index]
      if (goal === undefined) break
      const {points, r} = placesOf(goal)
      for (const [i, p] of points.entries()) {
        if (r > 0) circle(p[0], p[1], r)
        else if (i > 0) line(points[i - 1] ?? p, p)
      }
    }
  }
}

function rectangle(ctx: CanvasRenderingContext2D, box: Box): void {
  const [c, s] = [Math.cos(box.theta), Math.sin(box.theta)]
  const corner = (u: number, v: number): Spot => [box.x + c * u - s * v, box.y + s * u + c * v]
  const [w, h] = [box.w / 2, box.h / 2]
  ctx.moveTo(...corner(-w, -h))
  for (const p of [corner(w, -h), corner(w, h), corner(-w, h)]) ctx.lineTo(...p)
  ctx.closePath()
}

/// The keyboard's cross-hair.
function drawAim(ctx: CanvasRenderingContext2D, [x, y]: Spot, palette: Palette, scale: number): void {
  const arm = Math.max(wallThickness * 3, 12 / scale)
  ctx.strokeStyle = palette.trail
  ctx.lineWidth = 2 / scale
  ctx.beginPath()
  ctx.moveTo(x - arm, y)
  ctx.lineTo(x + arm, y)
  ctx.moveTo(x, y - arm)
  ctx.lineTo(x, y + arm)
  ctx.stroke()
}

// Hands

interface HandsHost {
  editor(): WorldEditor | null
  edited(edit: WorldEdit): void
  roomAt(x: number, y: number): Spot
  /// So many pixels, in metres.
  metres(pixels: number): number
  panned(dx: number, dy: number): void
  zoomed(factor: number, x: number, y: number): void
  fitted(): void
}

function watchHands(canvas: HTMLCanvasElement, host: HandsHost): void {
  const at = (event: PointerEvent | WheelEvent) => {
    const box = canvas.getBoundingClientRect()
    return {x: event.clientX - box.left, y: event.clientY - box.top}
  }
  // With two fingers the view moves and zooms; what one of them had begun is taken back.
  const fingers = new Map<number, {x: number; y: number}>()
  let drawing: number | null = null
  let panning = false

  canvas.addEventListener("pointerdown", event => {
    canvas.setPointerCapture(event.pointerId)
    const p = at(event)
    fingers.set(event.pointerId, p)
    if (fingers.size > 1) {
      if (drawing !== null) host.edited({kind: "cancel"})
      drawing = null
      panning = false
      return
    }
    if (event.button === 1 || event.shiftKey) {
      panning = true
      return
    }
    if (event.button !== 0) return
    drawing = event.pointerId
    const reach = host.metres(event.pointerType === "touch" ? fingerReach : mouseReach)
    host.edited({kind: "down", at: host.roomAt(p.x, p.y), reach})
  })
  canvas.addEventListener("pointermove", event => {
    const p = at(event)
    const before = fingers.get(event.pointerId)
    if (before === undefined) return
    if (fingers.size === 2) {
      const other = [...fingers].find(([id]) => id !== event.pointerId)?.[1]
      if (other !== undefined) {
        const spread = Math.hypot(p.x - other.x, p.y - other.y)
        const old = Math.hypot(before.x - other.x, before.y - other.y)
        if (old > 0 && spread > 0) host.zoomed(spread / old, (p.x + other.x) / 2, (p.y + other.y) / 2)
        host.panned((p.x - before.x) / 2, (p.y - before.y) / 2)
      }
    } else if (panning) host.panned(p.x - before.x, p.y - before.y)
    else if (event.pointerId === drawing) host.edited({kind: "move", at: host.roomAt(p.x, p.y)})
    fingers.set(event.pointerId, p)
  })
  const release = (event: PointerEvent, edit: WorldEdit) => {
    fingers.delete(event.pointerId)
    if (fingers.size === 0) panning = false
    if (event.pointerId !== drawing) return
    drawing = null
    host.edited(edit)
  }
  canvas.addEventListener("pointerup", event => release(event, {kind: "up"}))
  canvas.addEventListener("pointercancel", event => release(event, {kind: "cancel"}))
  canvas.addEventListener(
    "wheel",
    event => {
      event.preventDefault()
      const p = at(event)
      host.zoomed(1.0015 ** -event.deltaY, p.x, p.y)
    },
    {passive: false},
  )

  canvas.addEventListener("keydown", event => {
    const wanted = worldKey(event)
    if (wanted === null) return
    event.preventDefault()
    event.stopPropagation()
    const {clientWidth: w, clientHeight: h} = canvas
    if (wanted.kind === "closer") host.zoomed(1.25, w / 2, h / 2)
    else if (wanted.kind === "further") host.zoomed(0.8, w / 2, h / 2)
    else if (wanted.kind === "whole") host.fitted()
    else host.edited(wanted)
  })
}
