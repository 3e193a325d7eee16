/// Validation of the robot's start pose in a room. Pure.

import {distance, nearestOn, turnedBy} from "./geometry.ts"
import {robotRadius, type Spot, tileAt, type World, wallThickness, wheelOffset} from "./world.ts"

/// What the robot's start is wrong about.
export type StartFault = "outside" | "wall" | "hole"

/// As `World._check_start` in the service says it, to the author of the file.
const sentence = (world: World): Readonly<Record<StartFault, string>> => ({
  outside: "the robot would start outside the room.",
  wall: `the robot would start inside a wall; it needs ${Number((2 * robotRadius(world)).toFixed(2))} metres of free floor.`,
  hole: "the robot would start over a hole; it needs floor under it.",
})

/// Where the robot cannot start, and why; `null` when it can.
export function startFault(world: World): {readonly path: "start"; readonly why: string} | null {
  const trouble = startFaultKind(world)
  return trouble === null ? null : {path: "start", why: sentence(world)[trouble]}
}

export function startFaultKind(world: World): StartFault | null {
  const {x, y, theta} = world.start
  const [width, height] = world.size
  if (!(x >= 0 && x < width && y >= 0 && y < height)) return "outside"
  const tile = tileAt(world, x, y)
  if (tile === "#" || clearance(world, [x, y]) < -0.001) return "wall"
  const wheel = (side: number) =>
    world.tiles.length > 0 && tileAt(world, x - side * Math.sin(theta), y + side * Math.cos(theta)) === "O"
  const offset = wheelOffset(world)
  if (tile === "O" || wheel(offset) || wheel(-offset)) return "hole"
  return null
}

/// From the robot's body at a place to the nearest thing, m; less than 0 inside one.
function clearance(world: World, at: Spot): number {
  const [width, height] = world.size
  let gap = Math.min(at[0], at[1], width - at[0], height - at[1])
  for (const wall of world.walls)
    gap = Math.min(gap, distance(nearestOn(wall.from, wall.to, at), at) - wallThickness / 2)
  for (const box of world.boxes) {
    const [u, v] = turnedBy([at[0] - box.x, at[1] - box.y], -box.theta)
    gap = Math.min(gap, outside(u, v, box.w, box.h))
  }
  for (const round of world.rounds) gap = Math.min(gap, distance([round.x, round.y], at) - round.r)
  world.tiles.forEach((row, r) => {
    const y = (world.tiles.length - r - 0.5) * world.tile
    if (Math.abs(y - at[1]) > world.tile + 0.5) return
    ;[...row].forEach((tile, c) => {
      const x = (c + 0.5) * world.tile
      if (tile === "#") gap = Math.min(gap, outside(at[0] - x, at[1] - y, world.tile, world.tile))
    })
  })
  return gap - robotRadius(world)
}

/// How far a point is outside a rectangle around the origin, m; less than 0 inside.
function outside(u: number, v: number, w: number, h: number): number {
  const [dx, dy] = [Math.abs(u) - w / 2, Math.abs(v) - h / 2]
  return Math.hypot(Math.max(0, dx), Math.max(0, dy)) + Math.min(0, Math.max(dx, dy))
}
