/// The parts of a room in words: their short names, and what they are and where for a screen reader.

import {words} from "../words/index.ts"
import type {Part} from "../worlds/parts.ts"
import type {World, WorldGoal} from "../worlds/world.ts"

/// What a goal without a title of its own is called; a kind that this page does not know is its own name.
export function goalTitle(kind: string): string {
  const titles: Readonly<Record<string, string>> = words.world.goals
  return titles[kind] ?? kind
}

/// The goals without a place say what is to be avoided.
const nameOfGoal = (goal: WorldGoal): string =>
  goal.title !== ""
    ? goal.title
    : goal.kind === "avoid" && goal.what !== "place"
      ? words.world.avoids[goal.what]
      : goalTitle(goal.kind)

/// The short name of a part.
export function nameOfPart(world: World, part: Part): string {
  const w = words.world
  switch (part.kind) {
    case "start":
      return w.start
    case "wall":
      return w.wall(part.index + 1)
    case "box":
      return w.box(part.index + 1, world.boxes[part.index]?.movable ?? false)
    case "round":
      return w.round(part.index + 1, world.rounds[part.index]?.movable ?? false)
    case "goal": {
      const goal = world.goals[part.index]
      return goal === undefined ? "" : nameOfGoal(goal)
    }
  }
}

/// A part in words: what it is and where, for a screen reader.
export function describePart(world: World, part: Part): string {
  const name = nameOfPart(world, part)
  const w = words.world.described
  switch (part.kind) {
    case "start":
      return w.start(name, [world.start.x, world.start.y], world.start.theta)
    case "wall": {
      const wall = world.walls[part.index]
      return wall === undefined ? "" : w.line(name, wall.from, wall.to)
    }
    case "box": {
      const box = world.boxes[part.index]
      return box === undefined ? "" : w.box(name, [box.x, box.y], [box.w, box.h], box.theta)
    }
    case "round": {
      const round = world.rounds[part.index]
      return round === undefined ? "" : w.circle(name, [round.x, round.y], round.r)
    }
    case "goal": {
      const goal = world.goals[part.index]
      return goal === undefined ? "" : describeGoal(name, goal)
    }
  }
}

function describeGoal(name: string, goal: WorldGoal): string {
  const w = words.world.described
  switch (goal.kind) {
    case "lap":
      return w.line(name, goal.from, goal.to)
    case "visit":
    case "draw":
      return w.points(name, goal.points.length)
    case "avoid":
      return goal.what === "place" ? w.at(name, [goal.x, goal.y]) : name
    default:
      return w.circle(name, [goal.x, goal.y], goal.r)
  }
}
