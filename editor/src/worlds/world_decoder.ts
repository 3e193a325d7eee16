/// Decoder of worlds: the world, or its first fault with a path. Rules and sentences are those of `sim-service/rosy_sim/world/arena.py`;
/// `protocol/goldens/worlds.jsonl` tests both.

import {Mismatch} from "../wire/decode.ts"
import {
  aboutRobot,
  type Box,
  defaultLaps,
  defaultLineWidth,
  defaultMass,
  defaultTile,
  type FloorLine,
  ideal,
  limits,
  type Pose,
  type Realism,
  type Round,
  type SimulatedRobot,
  type Spot,
  simulatedRobots,
  usualRobot,
  type Wall,
  type World,
  type WorldGoal,
} from "./world.ts"
import {
  type Fault,
  type Fields,
  field,
  flag,
  items,
  length,
  number,
  or,
  record,
  required,
  short,
  spot,
  spots,
  text,
  Wrong,
  within,
} from "./world_fields.ts"

/// A world in a message; throws a `Mismatch` at `path`.
export function worldAt(path: string, value: unknown): World {
  const read = readWorld(value)
  if (read.kind === "world") return read.world
  const {fault} = read
  const why = fault.why.replace(/^expected /, "").replace(/\.$/, "")
  throw new Mismatch([path, fault.path].filter(Boolean).join("."), why)
}

export type ReadWorld =
  | {readonly kind: "world"; readonly world: World}
  | {readonly kind: "fault"; readonly fault: Fault}

export function readWorld(value: unknown): ReadWorld {
  try {
    return {kind: "world", world: world(value)}
  } catch (wrong) {
    if (wrong instanceof Wrong) return {kind: "fault", fault: wrong.fault}
    throw wrong
  }
}

const known = [
  "name",
  "size",
  "start",
  "tile",
  "tiles",
  "walls",
  "boxes",
  "rounds",
  "goals",
  "title",
  "realism",
  "dock",
  "battery",
  "scanner",
  "lines",
  "robot",
]

function world(value: unknown): World {
  const fields = record(value, "")
  for (const key of Object.keys(fields))
    if (!known.includes(key))
      throw new Wrong(key, "a world has nothing of that name; perhaps it is of a newer Rosy.")
  const name = text(fields, "name", "the name must be text.")
  const title = text(fields, "title", "the title must be text.")
  const tile = number(or(field(fields, "tile"), defaultTile), "tile")
  if (!within(tile, limits.tile)) throw new Wrong("tile", "a tile must be between 0.05 and 10 metres wide.")
  const tiles = readTiles(or(field(fields, "tiles"), []))
  const size = readSize(field(fields, "size"), tile, tiles)
  const walls = items(fields, "walls").map(([v, path]) => wall(v, path))
  const boxes = items(fields, "boxes").map(([v, path]) => box(v, path))
  const rounds = items(fields, "rounds").map(([v, path]) => round(v, path))
  if (walls.length + boxes.length + rounds.length > limits.things)
    throw new Wrong("walls", `a world can hold at most ${limits.things} things.`)
  if ([...boxes, ...rounds].filter(thing => thing.movable).length > limits.movable)
    throw new Wrong("boxes", `a world can hold at most ${limits.movable} things that can be pushed.`)
  const goals = readGoals(fields)
  const realism = field(fields, "realism") === undefined ? null : readRealism(field(fields, "realism"))
  if (field(fields, "start") === undefined)
    throw new Wrong("start", "the world does not say where the robot starts.")
  const start = pose(field(fields, "start"), "start")
  const dock = field(fields, "dock") === undefined ? null : pose(field(fields, "dock"), "dock")
  if (dock !== null && !(dock.x >= 0 && dock.x < size[0] && dock.y >= 0 && dock.y < size[1]))
    throw new Wrong("dock", "the dock is outside the room.")
  const battery = number(or(field(fields, "battery"), 1), "battery")
  if (!(battery >= 0 && battery <= 1))
    throw new Wrong("battery", "the battery must be between 0, empty, and 1, full.")
  const scanner = flag(fields, "scanner", "", true)
  const robot = readRobot(field(fields, "robot"))
  return {
    ...{name, title, size, start, tile, tiles, walls, boxes, rounds, lines: readLines(fields), goals},
    ...{realism, dock, battery, scanner, robot},
  }
}

function readRobot(value: unknown): SimulatedRobot {
  if (value === undefined) return usualRobot
  if (typeof value !== "string") throw new Wrong("robot", "the robot must be text.")
  const found = simulatedRobots.find(name => name === value)
  const names = simulatedRobots.map(name => `${name} (${aboutRobot(name).title})`).join(", ")
  if (found === undefined) throw new Wrong("robot", `the simulator has no robot '${value}'; it has ${names}.`)
  return found
}

function readTiles(value: unknown): readonly string[] {
  if (!Array.isArray(value)) throw new Wrong("tiles", "expected a list of rows.")
  const rows: string[] = []
  value.forEach((row: unknown, i) => {
    const path = `tiles[${i}]`
    if (typeof row !== "string") throw new Wrong(path, "a row must be text.")
    const first = rows[0]
    if (first !== undefined && row.length !== first.length)
      throw new Wrong(path, `this row has ${row.length} tiles, the first one has ${first.length}.`)
    const strange = [...row].findIndex(char => !"#.O".includes(char))
    if (strange >= 0)
      throw new Wrong(
        path,
        `tile ${strange + 1} is '${[...row][strange]}'; use # for wall, . for floor and O for a hole.`,
      )
    rows.push(row)
  })
  const first = rows[0]
  if (first === undefined) return rows
  if (first === "") throw new Wrong("tiles[0]", "the row is empty.")
  if (rows.length * first.length > limits.tiles)
    throw new Wrong("tiles", `a world can have at most ${limits.tiles} tiles.`)
  if (!rows.some(row => row.includes(".")))
    throw new Wrong("tiles", "there is no floor; the robot needs at least some tiles marked with a dot.")
  return rows
}

/// Tiles that differ from the size by less than this still fit, m (`arena.py`).
const fits = 1e-3

function readSize(value: unknown, tile: number, tiles: readonly string[]): Spot {
  const grid: Spot | null = tiles[0] === undefined ? null : [tiles[0].length * tile, tiles.length * tile]
  let size = grid
  if (value === undefined || value === null) {
    if (size === null)
      throw new Wrong("size", "a world needs a size or tiles; without them there is no floor.")
  } else {
    if (!Array.isArray(value) || value.length !== 2)
      throw new Wrong("size", "expected two numbers, width and height.")
    size = [number(value[0], "size[0]"), number(value[1], "size[1]")]
    if (grid !== null && (Math.abs(size[0] - grid[0]) > fits || Math.abs(size[1] - grid[1]) > fits))
      throw new Wrong(
        "size",
        `the tiles fill ${short(grid[0])} by ${short(grid[1])} metres; leave the size out or make it the same.`,
      )
  }
  size.forEach((side, i) => {
    if (!(side > 0 && side <= limits.side))
      throw new Wrong(
        value === undefined || value === null ? "tiles" : `size[${i}]`,
        `a room must be more than 0 and at most ${limits.side} metres long.`,
      )
  })
  return size
}

function wall(value: unknown, path: string): Wall {
  const fields = record(value, path)
  return {from: spot(field(fields, "from"), `${path}.from`), to: spot(field(fields, "to"), `${path}.to`)}
}

function box(value: unknown, path: string): Box {
  const fields = record(value, path)
  const movable = flag(fields, "movable", path)
  const unknown = flag(fields, "unknown", path)
  if (movable && unknown) throw new Wrong(`${path}.movable`, "an unknown area cannot be pushed.")
  return {
    x: required(fields, "x", path),
    y: required(fields, "y", path),
    w: length(fields, "w", path),
    h: length(fields, "h", path),
    theta: number(or(field(fields, "theta"), 0), `${path}.theta`),
    movable,
    mass: mass(fields, path),
    ...(unknown ? {unknown} : {}),
  }
}

function round(value: unknown, path: string): Round {
  const fields = record(value, path)
  return {
    x: required(fields, "x", path),
    y: required(fields, "y", path),
    r: length(fields, "r", path),
    movable: flag(fields, "movable", path),
    mass: mass(fields, path),
  }
}

function readLines(fields: Fields): readonly FloorLine[] {
  const found = items(fields, "lines")
  if (found.length > limits.lines)
    throw new Wrong("lines", `a world can have at most ${limits.lines} lines on the floor.`)
  return found.map(([value, path]) => {
    const line = record(value, path)
    const width = field(line, "width") === undefined ? defaultLineWidth : length(line, "width", path)
    return {points: spots(line, path, 2), width}
  })
}

function mass(fields: Fields, path: string): number {
  const value = number(or(field(fields, "mass"), defaultMass), `${path}.mass`)
  if (!within(value, limits.mass))
    throw new Wrong(`${path}.mass`, "it must weigh between 0.05 and 1000 kilograms.")
  return value
}

function pose(value: unknown, path: string): Pose {
  const fields = record(value, path)
  const theta = number(or(field(fields, "theta"), 0), `${path}.theta`)
  return {x: required(fields, "x", path), y: required(fields, "y", path), theta}
}

const goalKinds = ["reach", "touch", "avoid", "visit", "lap", "draw"] as const

function readGoals(fields: Fields): readonly WorldGoal[] {
  const found = items(fields, "goals")
  if (found.length > limits.goals) throw new Wrong("goals", `a world can have at most ${limits.goals} goals.`)
  return found.map(([value, path]) => goal(record(value, path), path))
}

function goal(fields: Fields, path: string): WorldGoal {
  const kind = goalKinds.find(k => k === field(fields, "kind"))
  if (kind === undefined) throw new Wrong(`${path}.kind`, `expected one of ${goalKinds.join(", ")}.`)
  const title = text(fields, "title", "the title must be text.", path)
  const limit =
    field(fields, "within") === undefined ? null : length(fields, "within", path, limits.within[1])
  const about = {title, within: limit}
  const place = () => ({
    x: required(fields, "x", path),
    y: required(fields, "y", path),
    r: length(fields, "r", path),
  })
  switch (kind) {
    case "reach":
    case "touch":
      return {...about, kind, ...place()}
    case "avoid": {
      const what = or(field(fields, "what"), "place")
      if (what === "place") return {...about, within: null, kind, what, ...place()}
      if (what === "bumps" || what === "holes") return {...about, within: null, kind, what}
      throw new Wrong(`${path}.what`, "expected bumps, holes or place.")
    }
    case "visit":
      return {...about, kind, points: spots(fields, path, 1), r: length(fields, "r", path)}
    case "lap": {
      const line = record(field(fields, "line"), `${path}.line`)
      const laps = number(or(field(fields, "laps"), defaultLaps), `${path}.laps`)
      if (!(laps >= 1 && laps <= limits.laps && Number.isInteger(laps)))
        throw new Wrong(`${path}.laps`, "expected a whole number from 1 to 1000.")
      const from = spot(field(line, "from"), `${path}.line.from`)
      return {...about, kind, from, to: spot(field(line, "to"), `${path}.line.to`), laps}
    }
    case "draw":
      return {...about, kind, points: spots(fields, path, 2), tolerance: length(fields, "tolerance", path)}
  }
}

function readRealism(value: unknown): Realism {
  const read: Record<string, number> = {...ideal}
  for (const [key, given] of Object.entries(record(value, "realism"))) {
    const ranges: Readonly<Record<string, readonly [number, number]>> = limits.realism
    // A file may name what every object has, such as `toString`.
    const range = Object.hasOwn(ranges, key) ? ranges[key] : undefined
    if (range === undefined)
      throw new Wrong(`realism.${key}`, `expected one of ${Object.keys(limits.realism).join(", ")}.`)
    const amount = number(given, `realism.${key}`)
    if (!within(amount, range))
      throw new Wrong(`realism.${key}`, `it must be between ${range[0]} and ${range[1]}.`)
    read[key] = amount
  }
  return read as unknown as Realism
}
