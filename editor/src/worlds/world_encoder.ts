/// Encoder of worlds as JSON without default values. `readWorld(writeWorld(world))` is the same world.

import {
  defaultLaps,
  defaultLineWidth,
  defaultMass,
  defaultTile,
  usualRobot,
  type World,
  type WorldFile,
  type WorldGoal,
} from "./world.ts"

export function writeWorld(world: World): WorldFile {
  const {
    name,
    title,
    size,
    start,
    tile,
    tiles,
    walls,
    boxes,
    rounds,
    lines,
    goals,
    realism,
    dock,
    battery,
    scanner,
    robot,
  } = world
  return {
    name,
    ...(title === "" ? {} : {title}),
    // Tiles say the size themselves.
    ...(tiles.length === 0 ? {size: [...size]} : {}),
    start: {x: start.x, y: start.y, theta: start.theta},
    ...(tiles.length === 0 && tile === defaultTile ? {} : {tile}),
    ...some("tiles", tiles, row => row),
    ...some("walls", walls, wall => ({from: [...wall.from], to: [...wall.to]})),
    ...some("boxes", boxes, ({x, y, w, h, theta, movable, mass, unknown}) => ({
      ...{x, y, w, h},
      ...(theta === 0 ? {} : {theta}),
      ...weight(movable, mass),
      ...(unknown ? {unknown} : {}),
    })),
    ...some("rounds", rounds, ({x, y, r, movable, mass}) => ({x, y, r, ...weight(movable, mass)})),
    ...some("lines", lines, ({points, width}) => ({
      points: points.map(p => [...p]),
      ...(width === defaultLineWidth ? {} : {width}),
    })),
    ...some("goals", goals, writeGoal),
    ...(realism === null ? {} : {realism: {...realism}}),
    ...(dock === null ? {} : {dock: {x: dock.x, y: dock.y, theta: dock.theta}}),
    ...(battery === 1 ? {} : {battery}),
    ...(scanner ? {} : {scanner}),
    ...(robot === usualRobot ? {} : {robot}),
  }
}

/// A world as the text of a file.
export function worldText(world: World): string {
  return `${JSON.stringify(writeWorld(world), null, 2)}\n`
}

const some = <T>(key: string, list: readonly T[], write: (item: T) => unknown) =>
  list.length === 0 ? {} : {[key]: list.map(write)}

const weight = (movable: boolean, mass: number) => ({
  ...(movable ? {movable} : {}),
  ...(mass === defaultMass ? {} : {mass}),
})

function writeGoal(goal: WorldGoal): WorldFile {
  const {title, within} = goal
  const about = {...(title === "" ? {} : {title}), ...(within === null ? {} : {within})}
  switch (goal.kind) {
    case "reach":
    case "touch":
      return {kind: goal.kind, x: goal.x, y: goal.y, r: goal.r, ...about}
    case "avoid":
      return goal.what === "place"
        ? {kind: goal.kind, x: goal.x, y: goal.y, r: goal.r, ...about}
        : {kind: goal.kind, what: goal.what, ...about}
    case "visit":
      return {kind: goal.kind, points: goal.points.map(p => [...p]), r: goal.r, ...about}
    case "lap": {
      const line = {from: [...goal.from], to: [...goal.to]}
      return {kind: goal.kind, line, ...(goal.laps === defaultLaps ? {} : {laps: goal.laps}), ...about}
    }
    case "draw":
      return {kind: goal.kind, points: goal.points.map(p => [...p]), tolerance: goal.tolerance, ...about}
  }
}
