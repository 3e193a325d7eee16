/// Hit testing of the parts of a world: distances from a point, and the part under a pointer. Pure.

import {distance, nearestOn, turnedBy} from "./geometry.ts"
import {robotRadius, type Spot, type World, type WorldGoal, wallThickness} from "./world.ts"
import {type Part, partsOf} from "./world_parts.ts"

/// Distance from a point to a part, m; 0 on the part, `null` for a part without a position.
function distanceToPart(world: World, part: Part, at: Spot): number | null {
  switch (part.kind) {
    case "start":
      return Math.max(0, distance([world.start.x, world.start.y], at) - robotRadius(world))
    case "wall": {
      const wall = world.walls[part.index]
      if (wall === undefined) return null
      return Math.max(0, distance(nearestOn(wall.from, wall.to, at), at) - wallThickness / 2)
    }
    case "box": {
      const box = world.boxes[part.index]
      if (box === undefined) return null
      const [u, v] = turnedBy([at[0] - box.x, at[1] - box.y], -box.theta)
      return Math.hypot(Math.max(0, Math.abs(u) - box.w / 2), Math.max(0, Math.abs(v) - box.h / 2))
    }
    case "round": {
      const round = world.rounds[part.index]
      return round === undefined ? null : Math.max(0, distance([round.x, round.y], at) - round.r)
    }
    case "line": {
      const line = world.lines[part.index]
      return line === undefined ? null : Math.max(0, gapToPath(line.points, at) - line.width / 2)
    }
    case "goal": {
      const goal = world.goals[part.index]
      return goal === undefined ? null : gapToGoal(goal, at)
    }
  }
}

function gapToGoal(goal: WorldGoal, at: Spot): number | null {
  switch (goal.kind) {
    case "lap":
      return distance(nearestOn(goal.from, goal.to, at), at)
    case "draw":
      return gapToPath(goal.points, at)
    case "visit":
      return Math.min(...goal.points.map(p => Math.max(0, distance(p, at) - goal.r)))
    case "avoid":
      return goal.what === "place" ? Math.max(0, distance([goal.x, goal.y], at) - goal.r) : null
    default:
      return Math.max(0, distance([goal.x, goal.y], at) - goal.r)
  }
}

const gapToPath = (points: readonly Spot[], at: Spot): number =>
  Math.min(...points.slice(1).map((b, i) => distance(nearestOn(points[i] ?? b, b, at), at)))

/// The part that a pointer at `at` with this reach (m) selects: the robot before things, things before lines on the floor, those before goals, and of things
/// that lie on each other the one that was put there last.
export function partAt(world: World, at: Spot, reach: number): Part | null {
  const rank = {start: 0, wall: 1, box: 1, round: 1, line: 2, goal: 3}
  let best: {part: Part; rank: number; gap: number} | null = null
  for (const part of partsOf(world)) {
    const gap = distanceToPart(world, part, at)
    if (gap === null || gap > reach) continue
    const here = {part, rank: rank[part.kind], gap}
    if (best === null || here.rank < best.rank || (here.rank === best.rank && here.gap <= best.gap))
      best = here
  }
  return best?.part ?? null
}
