/// Handles of the selected part: where they are, and the world after one was pulled. Pure; every result is inside the room and the limits of the schema.

import {clamp, distance, gridStep, gridTurn, onGrid, plus, tidy, turnedBy, wrapped} from "./geometry.ts"
import {limits, type Spot, type World} from "./world.ts"
import {inRoom, type Part, put, putGoal} from "./world_parts.ts"

/// A place to pull at: an end of a wall, a corner, an edge of a circle, a point of a shape, or what turns a thing.
export interface Handle {
  readonly name: "from" | "to" | "corner" | "rim" | "point" | "turn"
  /// Which corner (counter-clockwise from the lower left) or which point.
  readonly index: number
  readonly at: Spot
}

/// The smallest side or radius that a pointer can make, m: a mouse can still select it.
export const smallest = 0.05
/// From the rim of a thing to the handle that turns it, m.
const turnReach = 0.18
/// Where the handle that turns the robot is, from its middle, m.
const startReach = 0.32

export function handlesOf(world: World, part: Part): readonly Handle[] {
  const handle = (name: Handle["name"], at: Spot, index = 0): Handle => ({name, at, index})
  const rim = ({x, y, r}: {x: number; y: number; r: number}) => [handle("rim", [x + r, y])]
  switch (part.kind) {
    case "start": {
      const {x, y, theta} = world.start
      return [handle("turn", plus([x, y], startReach * Math.cos(theta), startReach * Math.sin(theta)))]
    }
    case "wall": {
      const wall = world.walls[part.index]
      return wall === undefined ? [] : [handle("from", wall.from), handle("to", wall.to)]
    }
    case "box": {
      const box = world.boxes[part.index]
      if (box === undefined) return []
      const at = (u: number, v: number): Spot => {
        const [x, y] = turnedBy([u, v], box.theta)
        return [box.x + x, box.y + y]
      }
      const corners = cornerSigns.map(([i, j], n) =>
        handle("corner", at((i * box.w) / 2, (j * box.h) / 2), n),
      )
      return [...corners, handle("turn", at(box.w / 2 + turnReach, 0))]
    }
    case "round": {
      const round = world.rounds[part.index]
      return round === undefined ? [] : rim(round)
    }
    case "line":
      return world.lines[part.index]?.points.map((p, i) => handle("point", p, i)) ?? []
    case "goal": {
      const goal = world.goals[part.index]
      switch (goal?.kind) {
        case "lap":
          return [handle("from", goal.from), handle("to", goal.to)]
        case "visit":
        case "draw":
          return goal.points.map((p, i) => handle("point", p, i))
        case "avoid":
          return goal.what === "place" ? rim(goal) : []
        case "reach":
        case "touch":
          return rim(goal)
        default:
          return []
      }
    }
  }
}

const cornerSigns = [
  [-1, -1],
  [1, -1],
  [1, 1],
  [-1, 1],
] as const

/// The world with a handle of a part pulled to a place.
export function moveHandle(world: World, part: Part, handle: Handle, at: Spot, snap: boolean): World {
  const to = inRoom(world, snap ? [onGrid(at[0]), onGrid(at[1])] : at)
  const angleFrom = (x: number, y: number) => {
    const angle = Math.atan2(at[1] - y, at[0] - x)
    return tidy(wrapped(snap ? Math.round(angle / gridTurn) * gridTurn : angle))
  }
  const radius = ({x, y}: {x: number; y: number}) => {
    const wanted = distance([x, y], at)
    return tidy(clamp(snap ? onGrid(wanted, gridStep / 2) : wanted, smallest, limits.length[1]))
  }
  switch (part.kind) {
    case "start":
      return {...world, start: {...world.start, theta: angleFrom(world.start.x, world.start.y)}}
    case "wall": {
      const wall = world.walls[part.index]
      if (wall === undefined) return world
      return {...world, walls: put(world.walls, part.index, {...wall, [handle.name]: to})}
    }
    case "box": {
      const box = world.boxes[part.index]
      if (box === undefined) return world
      if (handle.name === "turn")
        return {...world, boxes: put(world.boxes, part.index, {...box, theta: angleFrom(box.x, box.y)})}
      const [i, j] = cornerSigns[handle.index] ?? [1, 1]
      // The opposite corner stays where it is.
      const [ox, oy] = turnedBy([(-i * box.w) / 2, (-j * box.h) / 2], box.theta)
      const fixed: Spot = [box.x + ox, box.y + oy]
      const [u, v] = turnedBy([to[0] - fixed[0], to[1] - fixed[1]], -box.theta)
      const w = tidy(clamp(u * i, smallest, limits.length[1]))
      const h = tidy(clamp(v * j, smallest, limits.length[1]))
      const [cx, cy] = turnedBy([(i * w) / 2, (j * h) / 2], box.theta)
      const [x, y] = inRoom(world, plus(fixed, cx, cy))
      return {...world, boxes: put(world.boxes, part.index, {...box, x, y, w, h})}
    }
    case "round": {
      const round = world.rounds[part.index]
      if (round === undefined) return world
      return {...world, rounds: put(world.rounds, part.index, {...round, r: radius(round)})}
    }
    case "line": {
      const line = world.lines[part.index]
      if (line === undefined) return world
      const points = put(line.points, handle.index, to)
      return {...world, lines: put(world.lines, part.index, {...line, points})}
    }
    case "goal": {
      const goal = world.goals[part.index]
      switch (goal?.kind) {
        case "lap":
          return putGoal(world, part.index, {...goal, [handle.name]: to})
        case "visit":
        case "draw":
          return putGoal(world, part.index, {...goal, points: put(goal.points, handle.index, to)})
        case "avoid":
          return goal.what === "place" ? putGoal(world, part.index, {...goal, r: radius(goal)}) : world
        case "reach":
        case "touch":
          return putGoal(world, part.index, {...goal, r: radius(goal)})
        default:
          return world
      }
    }
  }
}
