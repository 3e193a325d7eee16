/// A world as `protocol/README.md` §6 describes it, complete: the robot's room, what stands in it, and what is to be
/// done there. Metres, radians counter-clockwise, kilograms; the lower left corner of the room is (0, 0), y up.
///
/// Pure; `read.ts` makes one of JSON, `write.ts` makes JSON of one.

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
}

/// A post or a drum, by its centre.
export interface Round {
  readonly x: number
  readonly y: number
  readonly r: number
  readonly movable: boolean
  readonly mass: number
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
export type GoalKind = WorldGoal["kind"]

/// How the robot differs from an ideal one: see protocol §6.
export interface Realism {
  readonly slip: number
  readonly drift: number
  readonly noise: number
  readonly latency: number
}

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
  readonly goals: readonly WorldGoal[]
  readonly realism: Realism | null
  /// Floor without walls around (0, 0), below a real robot whose room nobody knows. Never in a file.
  readonly open?: true
}

/// A world as it stands in a file: JSON.
export type WorldFile = {readonly [key: string]: unknown}

/// protocol §6: walls are so thick; a tile, a mass and a number of laps that the file does not say.
export const wallThickness = 0.05
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
  goals: 10,
  points: 200,
  laps: 1000,
  within: [0.01, 1e6],
  realism: {slip: 0.5, drift: 1, noise: 0.5, latency: 2},
} as const

/// Kobuki's radius: half of 351.5 mm (factory drawing, 2012-11-30).
export const robotRadius = 0.17575
/// Half of Kobuki's wheelbase of 0.230 m (kobuki_core, diff_drive: `bias`).
export const wheelOffset = 0.115

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
