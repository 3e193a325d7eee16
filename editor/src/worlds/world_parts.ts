/// Parts of a world that can be selected: their list, their removal, and the limits of the schema on their number. Pure.

import {clamp, tidy} from "./geometry.ts"
import {limits, type Spot, type World, type WorldGoal} from "./world.ts"

export type Part = {readonly kind: "start"} | {readonly kind: keyof typeof partLists; readonly index: number}

export const samePart = (a: Part | null, b: Part | null): boolean =>
  a?.kind === b?.kind && ((a as {index?: number})?.index ?? 0) === ((b as {index?: number})?.index ?? 0)

/// All parts in the order of the file; the start comes first.
export function partsOf(world: World): readonly Part[] {
  const many = (kind: keyof typeof partLists) =>
    world[partLists[kind]].map((_, index: number): Part => ({kind, index}))
  return [
    {kind: "start"},
    ...many("wall"),
    ...many("box"),
    ...many("round"),
    ...many("line"),
    ...many("goal"),
  ]
}

export function exists(world: World, part: Part): boolean {
  return partsOf(world).some(other => samePart(part, other))
}

export const inRoom = (world: World, [x, y]: Spot): Spot => [
  tidy(clamp(x, 0, world.size[0])),
  tidy(clamp(y, 0, world.size[1])),
]

export function put<T>(list: readonly T[], index: number, item: T): readonly T[] {
  return list.map((old, i) => (i === index ? item : old))
}

export const putGoal = (world: World, index: number, goal: WorldGoal): World => ({
  ...world,
  goals: put(world.goals, index, goal),
})

/// The lists of a world by the kind of their parts.
export const partLists = {wall: "walls", box: "boxes", round: "rounds", line: "lines", goal: "goals"} as const

/// The world without a part. The robot always starts somewhere, so the start stays.
export function removePart(world: World, part: Part): World {
  if (part.kind === "start") return world
  const key = partLists[part.kind]
  const list: readonly unknown[] = world[key]
  return {...world, [key]: list.filter((_, i) => i !== part.index)}
}

/// Limits of the schema: walls, boxes and posts together, those that can be pushed, lines, goals, and the points of one line or shape.
export const partLimits = {
  things: limits.things,
  movable: limits.movable,
  lines: limits.lines,
  goals: limits.goals,
  points: limits.points,
} as const
export type PartLimit = keyof typeof partLimits

const counts: Readonly<Record<PartLimit, (world: World) => number>> = {
  things: ({walls, boxes, rounds}) => walls.length + boxes.length + rounds.length,
  movable: ({boxes, rounds}) => [...boxes, ...rounds].filter(thing => thing.movable).length,
  lines: ({lines}) => lines.length,
  goals: ({goals}) => goals.length,
  points: ({lines, goals}) =>
    Math.max(0, ...[...lines, ...goals].map(part => ("points" in part ? part.points.length : 0))),
}

/// The limit that a world exceeds; `null` for none.
export function exceededLimit(world: World): PartLimit | null {
  return atLimit(world, ["things", "movable", "lines", "goals"], 1)
}

/// The limit that one more part would exceed; `null` for none.
export function limitReached(world: World, kind: keyof typeof partLists, movable: boolean): PartLimit | null {
  if (kind === "goal") return atLimit(world, ["goals"], 0)
  if (kind === "line") return atLimit(world, ["lines"], 0)
  return atLimit(world, movable ? ["things", "movable"] : ["things"], 0)
}

function atLimit(world: World, those: readonly PartLimit[], more: number): PartLimit | null {
  return those.find(limit => counts[limit](world) >= partLimits[limit] + more) ?? null
}

/// Whether a part can be pushed.
export function isMovable(world: World, part: Part): boolean {
  if (part.kind === "box") return world.boxes[part.index]?.movable ?? false
  return part.kind === "round" && (world.rounds[part.index]?.movable ?? false)
}
