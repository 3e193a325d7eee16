/// Drawing tools of the world editor: the object that a drag from one place to another creates. Pure.

import {clamp, distance, nearestOn, onGrid, tidy} from "./geometry.ts"
import {smallest} from "./part_handles.ts"
import {paintTile} from "./room_size.ts"
import {defaultLineWidth, defaultMass, limits, type Spot, type World, type WorldGoal} from "./world.ts"
import {type Part, put} from "./world_parts.ts"

export const tools = [
  "choose",
  "wall",
  "box",
  "crate",
  "round",
  "drum",
  "solid",
  "hole",
  "floor",
  "line",
  "reach",
  "touch",
  "avoid",
  "visit",
  "lap",
  "draw",
] as const
export type Tool = (typeof tools)[number]

/// Input of a tool: the world now and before the pointer went down, and whether things snap to the grid.
interface Drawing {
  readonly world: World
  readonly base: World
  readonly tool: Tool
  readonly snap: boolean
}

export const tileOf = {solid: "#", hole: "O", floor: "."} as const
export const isMovableTool = (tool: Tool) => tool === "crate" || tool === "drum"
export const isGoal = (tool: Tool) => ["reach", "touch", "avoid", "lap"].includes(tool)

export const point = (drawing: Drawing, at: Spot): Spot => {
  const [width, height] = drawing.world.size
  const [x, y] = drawing.snap ? [onGrid(at[0]), onGrid(at[1])] : [tidy(at[0]), tidy(at[1])]
  return [clamp(x, 0, width), clamp(y, 0, height)]
}

interface DrawnPart {
  readonly world: World
  readonly part: Part
}

/// The base with a new thing from one place to another.
export function drawnPart(drawing: Drawing, from: Spot, to: Spot): DrawnPart {
  const {base, tool} = drawing
  const [a, b] = [point(drawing, from), point(drawing, to)]
  const reach = tidy(Math.max(smallest, Math.hypot(b[0] - a[0], b[1] - a[1])))
  const movable = isMovableTool(tool)
  const about = {title: "", within: null}
  switch (tool) {
    case "wall":
      return addWall(base, a, b)
    case "box":
    case "crate": {
      const [w, h] = [Math.max(smallest, Math.abs(b[0] - a[0])), Math.max(smallest, Math.abs(b[1] - a[1]))]
      const [x, y] = [tidy((a[0] + b[0]) / 2), tidy((a[1] + b[1]) / 2)]
      const box = {x, y, w: tidy(w), h: tidy(h), theta: 0, movable, mass: defaultMass}
      return {world: {...base, boxes: [...base.boxes, box]}, part: {kind: "box", index: base.boxes.length}}
    }
    case "lap":
      return addGoal(base, {...about, kind: "lap", from: a, to: b, laps: 1})
    case "reach":
    case "touch":
      return addGoal(base, {...about, kind: tool, x: a[0], y: a[1], r: reach})
    case "avoid":
      return addGoal(base, {...about, kind: "avoid", what: "place", x: a[0], y: a[1], r: reach})
    default: {
      const round = {x: a[0], y: a[1], r: reach, movable, mass: defaultMass}
      return {
        world: {...base, rounds: [...base.rounds, round]},
        part: {kind: "round", index: base.rounds.length},
      }
    }
  }
}

function addWall(world: World, from: Spot, to: Spot): DrawnPart {
  return {
    world: {...world, walls: [...world.walls, {from, to}]},
    part: {kind: "wall", index: world.walls.length},
  }
}

function addGoal(world: World, goal: WorldGoal): DrawnPart {
  return {world: {...world, goals: [...world.goals, goal]}, part: {kind: "goal", index: world.goals.length}}
}

/// A thing of the usual size around a place: half a metre of wall to each side, a box of 40 cm, a post of 15 cm.
export function defaultPart(drawing: Drawing, at: Spot): DrawnPart {
  const [x, y] = point(drawing, at)
  switch (drawing.tool) {
    case "wall":
    case "lap":
      return drawnPart(drawing, [x - 0.5, y], [x + 0.5, y])
    case "box":
    case "crate":
      return drawnPart(drawing, [x - 0.2, y - 0.2], [x + 0.2, y + 0.2])
    case "reach":
    case "touch":
    case "avoid":
      return drawnPart(drawing, at, [x + 0.3, y])
    default:
      return drawnPart(drawing, at, [x + 0.2, y])
  }
}

/// Tools that add one point after the other.
export type PointTool = "line" | "visit" | "draw"

/// The world with a new part of one point.
export function firstPoint(world: World, tool: PointTool, at: Spot): DrawnPart {
  const about = {title: "", within: null}
  switch (tool) {
    case "line":
      return {
        world: {...world, lines: [...world.lines, {points: [at], width: defaultLineWidth}]},
        part: {kind: "line", index: world.lines.length},
      }
    case "visit":
      return addGoal(world, {...about, kind: "visit", points: [at], r: 0.3})
    case "draw":
      return addGoal(world, {...about, kind: "draw", points: [at], tolerance: 0.15})
  }
}

/// A part of several points with one more; `null` when the part is none of the tool or is full.
export function withPoint(world: World, part: Part, tool: PointTool, at: Spot): World | null {
  if (part.kind === "line") {
    const line = world.lines[part.index]
    if (tool !== "line" || line === undefined || line.points.length >= limits.points) return null
    return {...world, lines: put(world.lines, part.index, {...line, points: [...line.points, at]})}
  }
  const goal = part.kind === "goal" ? world.goals[part.index] : undefined
  if (part.kind !== "goal" || goal === undefined || goal.kind !== tool || goal.points.length >= limits.points)
    return null
  return {...world, goals: put(world.goals, part.index, {...goal, points: [...goal.points, at]})}
}

/// A shape or a line of one point is none yet; it gets a second one beside it.
export function finished(world: World): World {
  const whole = (points: readonly Spot[]): readonly Spot[] => {
    const [first] = points
    if (first === undefined || points.length > 1) return points
    const beside = first[0] + 0.5 <= world.size[0] ? first[0] + 0.5 : Math.max(0, first[0] - 0.5)
    return [first, [tidy(beside), first[1]]]
  }
  const goals = world.goals.map(goal => (goal.kind === "draw" ? {...goal, points: whole(goal.points)} : goal))
  return {...world, goals, lines: world.lines.map(line => ({...line, points: whole(line.points)}))}
}

/// How far a line may lie beside the way of the hand that drew it, m.
const thinningTolerance = 0.01

/// A world whose line keeps only the points that its shape needs (Ramer, Douglas, Peucker).
export function withThinnedLine(world: World, part: Part): World {
  const line = part.kind === "line" ? world.lines[part.index] : undefined
  if (part.kind !== "line" || line === undefined) return world
  return {...world, lines: put(world.lines, part.index, {...line, points: thinned(line.points)})}
}

function thinned(points: readonly Spot[]): readonly Spot[] {
  const [first, last] = [points[0], points.at(-1)]
  if (first === undefined || last === undefined || points.length < 3) return points
  let farthest = {index: 0, gap: thinningTolerance}
  for (const [index, at] of points.entries()) {
    const gap = distance(nearestOn(first, last, at), at)
    if (gap > farthest.gap) farthest = {index, gap}
  }
  if (farthest.index === 0) return [first, last]
  return [
    ...thinned(points.slice(0, farthest.index + 1)).slice(0, -1),
    ...thinned(points.slice(farthest.index)),
  ]
}

export function paintLine(world: World, from: Spot, to: Spot, tile: "#" | "." | "O"): World {
  const pieces = Math.max(1, Math.ceil(Math.hypot(to[0] - from[0], to[1] - from[1]) / (world.tile / 3)))
  let now = world
  for (let i = 0; i <= pieces; i += 1)
    now = paintTile(
      now,
      [from[0] + ((to[0] - from[0]) * i) / pieces, from[1] + ((to[1] - from[1]) * i) / pieces],
      tile,
    )
  return now
}
