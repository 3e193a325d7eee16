/// The world after a part was moved, turned or duplicated. Pure; every result is inside the room; a copy may exceed the limits on the number of parts.

import {clamp, onGrid, plus, tidy, turnedBy, wrapped} from "./geometry.ts"
import type {Spot, World} from "./world.ts"
import {exists, inRoom, type Part, partLists, put, putGoal} from "./world_parts.ts"

/// The world with a part moved by so much; with `snap` what is moved ends on the grid.
export function movePart(world: World, part: Part, dx: number, dy: number, snap: boolean): World {
  /// The step that brings an anchor to the grid and keeps it in the room.
  const step = (anchor: Spot): Spot => {
    const to = plus(anchor, dx, dy)
    return snap ? [onGrid(to[0]), onGrid(to[1])] : to
  }
  const place = <T extends {readonly x: number; readonly y: number}>(thing: T): T => {
    const [x, y] = inRoom(world, step([thing.x, thing.y]))
    return {...thing, x, y}
  }
  /// Several points move together, and stop together at the border of the room.
  const together = (points: readonly Spot[]): readonly Spot[] => {
    const first = points[0]
    if (first === undefined) return points
    const to = step(first)
    const xs = points.map(p => p[0])
    const ys = points.map(p => p[1])
    const by = (wanted: number, all: readonly number[], most: number) =>
      clamp(wanted, -Math.min(...all), most - Math.max(...all))
    const [mx, my] = [by(to[0] - first[0], xs, world.size[0]), by(to[1] - first[1], ys, world.size[1])]
    return points.map(p => inRoom(world, plus(p, mx, my)))
  }
  switch (part.kind) {
    case "start":
      return {...world, start: place(world.start)}
    case "wall": {
      const wall = world.walls[part.index]
      if (wall === undefined) return world
      const [from = wall.from, to = wall.to] = together([wall.from, wall.to])
      return {...world, walls: put(world.walls, part.index, {from, to})}
    }
    case "box": {
      const box = world.boxes[part.index]
      if (box === undefined) return world
      // What stands straight has its lower left corner on the grid, so that edges meet.
      const straight = Math.abs(Math.sin(2 * box.theta)) < 1e-6
      const upright = Math.abs(Math.cos(box.theta)) > 0.5
      const half: Spot = straight ? [(upright ? box.w : box.h) / 2, (upright ? box.h : box.w) / 2] : [0, 0]
      const corner = step([box.x - half[0], box.y - half[1]])
      const [x, y] = inRoom(world, plus(corner, half[0], half[1]))
      return {...world, boxes: put(world.boxes, part.index, {...box, x, y})}
    }
    case "round": {
      const round = world.rounds[part.index]
      return round === undefined ? world : {...world, rounds: put(world.rounds, part.index, place(round))}
    }
    case "line": {
      const line = world.lines[part.index]
      if (line === undefined) return world
      return {...world, lines: put(world.lines, part.index, {...line, points: together(line.points)})}
    }
    case "goal": {
      const goal = world.goals[part.index]
      if (goal === undefined) return world
      switch (goal.kind) {
        case "lap": {
          const [from = goal.from, to = goal.to] = together([goal.from, goal.to])
          return putGoal(world, part.index, {...goal, from, to})
        }
        case "visit":
        case "draw":
          return putGoal(world, part.index, {...goal, points: together(goal.points)})
        case "avoid":
          return goal.what === "place" ? putGoal(world, part.index, place(goal)) : world
        default:
          return putGoal(world, part.index, place(goal))
      }
    }
  }
}

/// The world with a part turned by an angle; what is round stays.
export function turnPart(world: World, part: Part, by: number): World {
  switch (part.kind) {
    case "start":
      return {...world, start: {...world.start, theta: tidy(wrapped(world.start.theta + by))}}
    case "box": {
      const box = world.boxes[part.index]
      if (box === undefined) return world
      return {...world, boxes: put(world.boxes, part.index, {...box, theta: tidy(wrapped(box.theta + by))})}
    }
    case "wall": {
      const wall = world.walls[part.index]
      if (wall === undefined) return world
      const middle: Spot = [(wall.from[0] + wall.to[0]) / 2, (wall.from[1] + wall.to[1]) / 2]
      const about = (p: Spot): Spot => {
        const [x, y] = turnedBy([p[0] - middle[0], p[1] - middle[1]], by)
        return inRoom(world, plus(middle, x, y))
      }
      return {...world, walls: put(world.walls, part.index, {from: about(wall.from), to: about(wall.to)})}
    }
    default:
      return world
  }
}

/// The world with a copy beside a part, and which part the copy is; `null` for a part that cannot be copied. It may exceed the limits of the schema.
export function duplicate(world: World, part: Part): {readonly world: World; readonly part: Part} | null {
  const beside = (more: World, copy: Part) => ({world: movePart(more, copy, 0.2, 0.2, false), part: copy})
  if (part.kind === "start" || !exists(world, part)) return null
  const key = partLists[part.kind]
  const all = world[key] as readonly unknown[]
  const more: World = {...world, [key]: [...all, all[part.index]]}
  return beside(more, {kind: part.kind, index: all.length})
}
