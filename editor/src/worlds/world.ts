/// A world as `protocol/README.md` §6 describes it, with all defaults filled in: the robot's room, its objects, its goals. Metres, radians counter-clockwise, kilograms; the
/// lower left corner of the room is (0, 0), y up.
///
/// Pure; `world_decoder.ts` reads it from JSON, `world_encoder.ts` writes it.

import {robot} from "@rosy/codegen/robot"

export type Spot = readonly [number, number]

export interface Pose {
  readonly x: number
  readonly y: number
  readonly theta: number
}

export interface Wall {
  readonly from: Spot
  readonly to: Spot
}

/// A block, by its centre.
export interface Box extends Pose {
  readonly w: number
  readonly h: number
  readonly movable: boolean
  readonly mass: number
  /// An area that no scan has seen. It blocks like a block that stands fast.
  readonly unknown?: true
}

/// A post or a drum, by its centre.
export interface Round {
  readonly x: number
  readonly y: number
  readonly r: number
  readonly movable: boolean
  readonly mass: number
}

/// A black line on the floor from point to point, for the line sensor. It blocks nothing.
export interface FloorLine {
  readonly points: readonly Spot[]
  readonly width: number
}

/// What is to be done. `title` may be empty, `within` is a limit in seconds or `null`.
export type WorldGoal = {readonly title: string; readonly within: number | null} & (
  | {readonly kind: "reach" | "touch"; readonly x: number; readonly y: number; readonly r: number}
  | {
      readonly kind: "avoid"
      readonly what: "place"
      readonly x: number
      readonly y: number
      readonly r: number
    }
  | {readonly kind: "avoid"; readonly what: "bumps" | "holes"}
  | {readonly kind: "visit"; readonly points: readonly Spot[]; readonly r: number}
  | {readonly kind: "lap"; readonly from: Spot; readonly to: Spot; readonly laps: number}
  | {readonly kind: "draw"; readonly points: readonly Spot[]; readonly tolerance: number}
)

/// How the robot differs from an ideal one: see protocol §6.
export interface Realism {
  readonly slip: number
  readonly drift: number
  readonly noise: number
  readonly latency: number
  readonly travel: number
  readonly turning: number
  readonly veer: number
}

/// The values of what a file does not say.
export const ideal: Realism = {slip: 0, drift: 0, noise: 0, latency: 0, travel: 1, turning: 1, veer: 0}

export interface World {
  readonly name: string
  readonly title: string
  readonly size: Spot
  readonly start: Pose
  readonly tile: number
  /// Rows of `#`, `.` and `O`, the first is the top; none when the whole room is floor.
  readonly tiles: readonly string[]
  readonly walls: readonly Wall[]
  readonly boxes: readonly Box[]
  readonly rounds: readonly Round[]
  readonly lines: readonly FloorLine[]
  readonly goals: readonly WorldGoal[]
  readonly realism: Realism | null
  /// Where a docked robot stands.
  readonly dock: Pose | null
  /// Charge of the battery at the start, 0 to 1.
  readonly battery: number
  /// Whether the robot carries a laser scanner.
  readonly scanner: boolean
  readonly robot: SimulatedRobot
  /// Floor without walls around (0, 0), below a real robot whose room is unknown. Never in a file.
  readonly open?: true
}

/// A world as it stands in a file: JSON.
export type WorldFile = {readonly [key: string]: unknown}

/// protocol §6: walls are so thick; a tile, a line's width, a mass and a number of laps that the file does not say.
export const wallThickness = 0.05
export const defaultLineWidth = 0.05
export const defaultTile = 0.5
export const defaultMass = 1
export const defaultLaps = 1

/// protocol/world.schema.json, and `arena.py`, which reads the same.
export const limits = {
  side: 100,
  length: [0.01, 100],
  mass: [0.05, 1000],
  tile: [0.05, 10],
  tiles: 40_000,
  things: 2000,
  movable: 200,
  goals: 10,
  lines: 10,
  points: 200,
  laps: 1000,
  within: [0.01, 1e6],
  realism: {
    slip: [0, 0.5],
    drift: [0, 1],
    noise: [0, 0.5],
    latency: [0, 2],
    travel: [0.2, 2],
    turning: [0.2, 2],
    veer: [-5, 5],
  },
} as const

/// Metres: in a longer room that is shown whole, the robot is too small to see, so the view follows it.
const longestSeenWhole = 12
export const isLarge = ({size}: World): boolean => Math.max(...size) > longestSeenWhole

/// A robot of the simulator, by its name in `protocol/robots`.
export type SimulatedRobot = keyof typeof robot.simulated
export const simulatedRobots = Object.keys(robot.simulated) as readonly SimulatedRobot[]
/// That of a room which names none.
export const usualRobot: SimulatedRobot = robot.usual

/// What a robot of the simulator is called, its numbers, and the names that stand for what it lacks.
export const aboutRobot = (name: SimulatedRobot): (typeof robot.simulated)[SimulatedRobot] =>
  robot.simulated[name]

/// The radius of the robot of a room, m.
export const robotRadius = (world: World): number => aboutRobot(world.robot).body.radius
/// Half of the distance between its wheels, m.
export const wheelOffset = (world: World): number => aboutRobot(world.robot).body.wheelbase / 2

/// The places of a goal: where it is drawn. Several points with `r` 0 are a line.
export function placesOf(goal: WorldGoal): {readonly points: readonly Spot[]; readonly r: number} {
  switch (goal.kind) {
    case "reach":
    case "touch":
      return {points: [[goal.x, goal.y]], r: goal.r}
    case "avoid":
      return goal.what === "place" ? {points: [[goal.x, goal.y]], r: goal.r} : {points: [], r: 0}
    case "visit":
      return {points: goal.points, r: goal.r}
    case "lap":
      return {points: [goal.from, goal.to], r: 0}
    case "draw":
      return {points: goal.points, r: 0}
  }
}

/// What is under a point: `#`, `.` or `O`. Outside the room it is wall.
export function tileAt(world: Pick<World, "size" | "tile" | "tiles">, x: number, y: number): string {
  const [width, height] = world.size
  if (!(x >= 0 && x < width && y >= 0 && y < height)) return "#"
  if (world.tiles.length === 0) return "."
  const row = world.tiles.length - 1 - Math.floor(y / world.tile)
  return world.tiles[row]?.[Math.floor(x / world.tile)] ?? "#"
}
