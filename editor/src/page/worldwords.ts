/// The words of the world editor and of the gallery of rooms; a part of `words.ts` that stands by itself.

import type {Tool} from "../worlds/editor.ts"
import type {Part} from "../worlds/parts.ts"
import type {Spot, World, WorldGoal} from "../worlds/world.ts"

export const worldWords = {
  rooms: "Rooms",
  roomsLead: "Choose where the robot drives. Your program stays as it is.",
  roomsLoading: "Looking for the rooms…",
  choose: (name: string) => `Room to drive in: ${name}`,
  change: "Change this room",
  title: "Change this room",
  done: "Done",
  leave: "Leave it as it was",
  tools: "What to draw",
  toolNames: {
    choose: "Choose",
    wall: "Wall",
    box: "Block",
    crate: "Box to push",
    round: "Post",
    drum: "Drum to push",
    solid: "Wall tiles",
    hole: "Holes",
    floor: "Floor",
    reach: "Come here",
    touch: "Touch here",
    avoid: "Stay away",
    visit: "Visit all",
    lap: "Lap line",
    draw: "Draw this",
  } as Readonly<Record<Tool, string>>,
  toolHints: {
    choose: "Drag things to move them. Drag a handle to change or turn them.",
    wall: "Drag from one end of the wall to the other.",
    box: "Drag from corner to corner. A block stays where it is.",
    crate: "Drag from corner to corner. The robot can push this box.",
    round: "Drag from the middle to the rim. A post stays where it is.",
    drum: "Drag from the middle to the rim. The robot can push this drum.",
    solid: "Drag over the floor to fill tiles with wall.",
    hole: "Drag over the floor to make holes. The robot's wheels drop into them.",
    floor: "Drag over walls or holes to make them floor again.",
    reach: "Drag a circle. The robot should come into it.",
    touch: "Drag a circle. The robot should bump into something there.",
    avoid: "Drag a circle. The robot should stay out of it.",
    visit: "Click each place that the robot should visit.",
    lap: "Drag the line that each lap crosses.",
    draw: "Draw the path that the robot should follow, or click its corners.",
  } as Readonly<Record<Tool, string>>,
  sheetLabel:
    "The room from above. Arrow keys move what is chosen, or a cross-hair; Enter begins and ends a drawing; comma and full stop turn; Delete takes away.",
  aimAt: ([x, y]: Spot) => `At ${metres(x)}, ${metres(y)}`,
  startFault: (why: string) => `${why.charAt(0).toUpperCase()}${why.slice(1)} Move it before you go on.`,
  snap: "Snap to the grid",
  room: "This room",
  name: "Name",
  width: "Width",
  height: "Height",
  x: "x",
  y: "y",
  angle: "Angle",
  radius: "Radius",
  length: "Length",
  movable: "Can be pushed",
  mass: "Weight",
  delete: "Take away",
  duplicate: "One more",
  things: "In this room",
  goalTitle: "What to do",
  tolerance: "How near",
  laps: "Laps",
  timed: "In a given time",
  within: "Time",
  avoids: {bumps: "The robot should bump into nothing", holes: "No wheel should drop"},
  realistic: "Wheels slip, as on a real floor",
  openFile: "Open a room…",
  saveFile: "Save this room",
  start: "Start of the robot",
  wall: (n: number) => `Wall ${n}`,
  box: (n: number, movable: boolean) => `${movable ? "Box" : "Block"} ${n}`,
  round: (n: number, movable: boolean) => `${movable ? "Drum" : "Post"} ${n}`,
} as const

/// What a goal without a title of its own is called; the service says the same (`world/goals.py`).
const goalTitles: Readonly<Record<string, string>> = {
  reach: "Come to the place",
  touch: "Touch the thing",
  avoid: "Stay away",
  visit: "Visit all the places",
  lap: "Drive a lap",
  draw: "Draw the shape",
}

export const goalTitle = (kind: string): string => goalTitles[kind] ?? kind

/// The goals without a place say what is to be avoided.
const nameOfGoal = (goal: WorldGoal): string =>
  goal.title !== ""
    ? goal.title
    : goal.kind === "avoid" && goal.what !== "place"
      ? worldWords.avoids[goal.what]
      : goalTitle(goal.kind)

const metres = (value: number) => `${+value.toFixed(2)} m`
const degrees = (angle: number) => `${Math.round((angle * 180) / Math.PI)}°`

/// The short name of a part.
export function nameOfPart(world: World, part: Part): string {
  switch (part.kind) {
    case "start":
      return worldWords.start
    case "wall":
      return worldWords.wall(part.index + 1)
    case "box":
      return worldWords.box(part.index + 1, world.boxes[part.index]?.movable ?? false)
    case "round":
      return worldWords.round(part.index + 1, world.rounds[part.index]?.movable ?? false)
    case "goal": {
      const goal = world.goals[part.index]
      return goal === undefined ? "" : nameOfGoal(goal)
    }
  }
}

/// A part in words: what it is and where, for a screen reader.
export function describePart(world: World, part: Part): string {
  const name = nameOfPart(world, part)
  const place = (x: number, y: number) => `${metres(x)}, ${metres(y)}`
  switch (part.kind) {
    case "start":
      return `${name} at ${place(world.start.x, world.start.y)}, looking ${degrees(world.start.theta)}`
    case "wall": {
      const wall = world.walls[part.index]
      return wall === undefined ? "" : `${name} from ${place(...wall.from)} to ${place(...wall.to)}`
    }
    case "box": {
      const box = world.boxes[part.index]
      if (box === undefined) return ""
      const turn = box.theta === 0 ? "" : `, turned ${degrees(box.theta)}`
      return `${name} at ${place(box.x, box.y)}, ${metres(box.w)} by ${metres(box.h)}${turn}`
    }
    case "round": {
      const round = world.rounds[part.index]
      return round === undefined ? "" : `${name} at ${place(round.x, round.y)}, radius ${metres(round.r)}`
    }
    case "goal": {
      const goal = world.goals[part.index]
      if (goal === undefined) return ""
      switch (goal.kind) {
        case "lap":
          return `${name} from ${place(...goal.from)} to ${place(...goal.to)}`
        case "visit":
        case "draw":
          return `${name}, ${goal.points.length} points`
        case "avoid":
          return goal.what === "place" ? `${name} at ${place(goal.x, goal.y)}` : name
        default:
          return `${name} at ${place(goal.x, goal.y)}, radius ${metres(goal.r)}`
      }
    }
  }
}
