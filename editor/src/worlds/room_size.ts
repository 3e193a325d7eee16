/// The world after a tile was painted or its size was changed. Pure; every result is inside the limits of the schema.

import {clamp, tidy} from "./geometry.ts"
import {movePart} from "./part_movement.ts"
import {limits, type Spot, type World} from "./world.ts"
import {inRoom, partsOf, put} from "./world_parts.ts"

/// The world with one tile painted: `#`, `.` or `O`. A room without tiles gets a grid first, and grows to fit it; one
/// with floor only has none. The last tile of floor stays, for a room needs one.
export function paintTile(world: World, at: Spot, tile: "#" | "." | "O"): World {
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
export function resizeWorld(world: World, width: number, height: number): World {
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

/// A dock stands inside of the room, not on its upper or right edge; in m.
const fromEdge = 0.01

function atDock(world: World, [x, y]: Spot): {x: number; y: number} {
  const [width, height] = world.size
  return {x: Math.min(x, tidy(width - fromEdge)), y: Math.min(y, tidy(height - fromEdge))}
}

/// Everything brought inside the room.
function gathered(world: World): World {
  const inside = (p: Spot) => inRoom(world, p)
  const {dock} = world
  const within: World = {
    ...world,
    dock: dock === null ? null : {...dock, ...atDock(world, inside([dock.x, dock.y]))},
    walls: world.walls.map(({from, to}) => ({from: inside(from), to: inside(to)})),
    lines: world.lines.map(line => ({...line, points: line.points.map(inside)})),
    goals: world.goals.map(goal => {
      if (goal.kind === "lap") return {...goal, from: inside(goal.from), to: inside(goal.to)}
      return goal.kind === "visit" || goal.kind === "draw" ? {...goal, points: goal.points.map(inside)} : goal
    }),
  }
  return partsOf(within).reduce((now: World, part) => movePart(now, part, 0, 0, false), within)
}
