/// The parts of a world that a hand can take: what each is, where it can be held, and the world after it was moved,
/// turned, pulled at a handle, doubled or taken away. Pure; nothing here leaves the room or the limits of the schema.

import {
  clamp,
  distance,
  gridStep,
  gridTurn,
  nearestOn,
  onGrid,
  plus,
  tidy,
  turnedBy,
  wrapped,
} from "./plane.ts"
import {limits, robotRadius, type Spot, type World, type WorldGoal, wallThickness} from "./world.ts"

export type Part =
  | {readonly kind: "start"}
  | {readonly kind: "wall" | "box" | "round" | "goal"; readonly index: number}

/// A place to pull at: an end of a wall, a corner, an edge of a circle, a point of a shape, or what turns a thing.
export interface Handle {
  readonly name: "from" | "to" | "corner" | "rim" | "point" | "turn"
  /// Which corner (counter-clockwise from the lower left) or which point.
  readonly index: number
  readonly at: Spot
}

/// The smallest thing that hands make, m: a mouse can still hold it.
export const smallest = 0.05
/// From the rim of a thing to the handle that turns it, m.
const turnReach = 0.18
/// Where the handle that turns the robot is, from its middle, m.
const startReach = 0.32

export const samePart = (a: Part | null, b: Part | null): boolean =>
  a?.kind === b?.kind && ((a as {index?: number})?.index ?? 0) === ((b as {index?: number})?.index ?? 0)

/// All parts in the order of the file; the start comes first.
export function partsOf(world: World): readonly Part[] {
  const many = (kind: "wall" | "box" | "round" | "goal", list: readonly unknown[]) =>
    list.map((_, index): Part => ({kind, index}))
  return [
    {kind: "start"},
    ...many("wall", world.walls),
    ...many("box", world.boxes),
    ...many("round", world.rounds),
    ...many("goal", world.goals),
  ]
}

export function exists(world: World, part: Part): boolean {
  return partsOf(world).some(other => samePart(part, other))
}

const inRoom = (world: World, [x, y]: Spot): Spot => [
  tidy(clamp(x, 0, world.size[0])),
  tidy(clamp(y, 0, world.size[1])),
]

export function put<T>(list: readonly T[], index: number, item: T): readonly T[] {
  return list.map((old, i) => (i === index ? item : old))
}
const without = <T>(list: readonly T[], index: number): readonly T[] => list.filter((_, i) => i !== index)

const putGoal = (world: World, index: number, goal: WorldGoal): World => ({
  ...world,
  goals: put(world.goals, index, goal),
})

// What is there

/// How far a point is from a part, m: 0 on it. `null` for what has no place.
export function gapTo(world: World, part: Part, at: Spot): number | null {
  switch (part.kind) {
    case "start":
      return Math.max(0, distance([world.start.x, world.start.y], at) - robotRadius)
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
      return Math.min(
        ...goal.points.slice(1).map((b, i) => distance(nearestOn(goal.points[i] ?? b, b, at), at)),
      )
    case "visit":
      return Math.min(...goal.points.map(p => Math.max(0, distance(p, at) - goal.r)))
    case "avoid":
      return goal.what === "place" ? Math.max(0, distance([goal.x, goal.y], at) - goal.r) : null
    default:
      return Math.max(0, distance([goal.x, goal.y], at) - goal.r)
  }
}

/// What a pointer at `at` that reaches so far (m) takes: the robot before things, things before goals, and of things
/// that lie on each other the one that was put there last.
export function partAt(world: World, at: Spot, reach: number): Part | null {
  const rank = {start: 0, wall: 1, box: 1, round: 1, goal: 2}
  let best: {part: Part; rank: number; gap: number} | null = null
  for (const part of partsOf(world)) {
    const gap = gapTo(world, part, at)
    if (gap === null || gap > reach) continue
    const here = {part, rank: rank[part.kind], gap}
    if (best === null || here.rank < best.rank || (here.rank === best.rank && here.gap <= best.gap))
      best = here
  }
  return best?.part ?? null
}

// Moving

/// The world with a part moved by so much; with `snap` what is moved ends on the grid.
export function moved(world: World, part: Part, dx: number, dy: number, snap: boolean): World {
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
export function turned(world: World, part: Part, by: number): World {
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

// Handles

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
export function pulled(world: World, part: Part, handle: Handle, at: Spot, snap: boolean): World {
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

// Taking away and doubling

/// The robot always starts somewhere: the start cannot be taken away.
export function removed(world: World, part: Part): World {
  switch (part.kind) {
    case "start":
      return world
    case "wall":
      return {...world, walls: without(world.walls, part.index)}
    case "box":
      return {...world, boxes: without(world.boxes, part.index)}
    case "round":
      return {...world, rounds: without(world.rounds, part.index)}
    case "goal":
      return {...world, goals: without(world.goals, part.index)}
  }
}

/// The world with another such thing beside a thing, and which one that is; `null` where there can be no more.
export function doubled(world: World, part: Part): {readonly world: World; readonly part: Part} | null {
  const beside = (more: World, copy: Part) => ({world: moved(more, copy, 0.2, 0.2, false), part: copy})
  if (part.kind === "start" || !exists(world, part) || !hasRoomFor(world, part.kind)) return null
  const list = {wall: "walls", box: "boxes", round: "rounds", goal: "goals"} as const
  const key = list[part.kind]
  const all = world[key] as readonly unknown[]
  const more: World = {...world, [key]: [...all, all[part.index]]}
  return beside(more, {kind: part.kind, index: all.length})
}

/// Whether the schema allows one more.
export function hasRoomFor(world: World, kind: "wall" | "box" | "round" | "goal"): boolean {
  return kind === "goal"
    ? world.goals.length < limits.goals
    : world.walls.length + world.boxes.length + world.rounds.length < limits.things
}

// Tiles and the room itself

/// The world with one tile painted: `#`, `.` or `O`. A room without tiles gets a grid first, and grows to fit it; one
/// with floor only has none. The last tile of floor stays, for a room needs one.
export function painted(world: World, at: Spot, tile: "#" | "." | "O"): World {
  const grid = world.tiles.length > 0 ? world : withGrid(world)
  const row = grid.tiles.length - 1 - Math.floor(at[1] / grid.tile)
  const column = Math.floor(at[0] / grid.tile)
  const old = grid.tiles[row]
  if (old === undefined || column < 0 || column >= old.length || old[column] === tile) return world
  const tiles = put(grid.tiles, row, old.slice(0, column) + tile + old.slice(column + 1))
  if (!tiles.some(r => r.includes("."))) return world
  const bare = tiles.every(r => !/[#O]/.test(r))
  return bare ? {...grid, tiles: []} : {...grid, tiles}
}

function withGrid(world: World): World {
  const [columns, rows] = world.size.map(side => Math.max(1, Math.ceil(side / world.tile - 1e-6)))
  if (columns === undefined || rows === undefined || columns * rows > limits.tiles) return world
  const tiles = Array.from({length: rows}, () => ".".repeat(columns))
  return {...world, size: [tidy(columns * world.tile), tidy(rows * world.tile)], tiles}
}

/// The room with another size, m. Tiles are added as floor on the right and at the top, or cut off there; things that
/// would stand outside come in.
export function resized(world: World, width: number, height: number): World {
  const side = (value: number) => clamp(tidy(value), 0.5, limits.side)
  if (world.tiles.length === 0) return gathered({...world, size: [side(width), side(height)]})
  const count = (value: number) => Math.max(1, Math.round(side(value) / world.tile))
  let [columns, rows] = [count(width), count(height)]
  // A grid may not become larger than the schema allows.
  while (columns * rows > limits.tiles || columns * world.tile > limits.side) columns -= 1
  while (rows * world.tile > limits.side) rows -= 1
  const kept = world.tiles.slice(-rows).map(row => row.slice(0, columns).padEnd(columns, "."))
  const added = Array.from({length: rows - kept.length}, () => ".".repeat(columns))
  const tiles = [...added, ...kept]
  const floor = tiles.some(row => row.includes(".")) ? tiles : put(tiles, 0, `.${tiles[0]?.slice(1) ?? ""}`)
  return gathered({...world, size: [tidy(columns * world.tile), tidy(rows * world.tile)], tiles: floor})
}

/// Everything brought inside the room.
function gathered(world: World): World {
  const inside = (p: Spot) => inRoom(world, p)
  const within: World = {
    ...world,
    walls: world.walls.map(({from, to}) => ({from: inside(from), to: inside(to)})),
    goals: world.goals.map(goal => {
      if (goal.kind === "lap") return {...goal, from: inside(goal.from), to: inside(goal.to)}
      return goal.kind === "visit" || goal.kind === "draw" ? {...goal, points: goal.points.map(inside)} : goal
    }),
  }
  return partsOf(within).reduce((now: World, part) => moved(now, part, 0, 0, false), within)
}
