/// Parts of a world that can be selected: their list, their removal, and whether the schema allows one more. Pure.

import {clamp, tidy} from "./geometry.ts"
import {limits, type Spot, type World, type WorldGoal} from "./world.ts"

export type Part = {readonly kind: "start"} | {readonly kind: keyof typeof partLists; readonly index: number}

export const samePart = (a: Part | null, b: Part | null): boolean =>
  a?.kind === b?.kind && ((a as {index?: number})?.index ?? 0) === ((b as {index?: number})?.index ?? 0)

/// All parts in the order of the file; the start comes first.
export function partsOf(world: World): readonly Part[] {
  const many = (kind: keyof typeof partLists) =>
    world[partLists[kind]].map((_, index: number): Part => ({kind, index}))
  return [{kind: "start"}, ...many("wall"), ...many("box"), ...many("round"), ...many("goal")]
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
export const partLists = {wall: "walls", box: "boxes", round: "rounds", goal: "goals"} as const

/// The world without a part. The robot always starts somewhere, so the start stays.
export function removePart(world: World, part: Part): World {
  if (part.kind === "start") return world
  const key = partLists[part.kind]
  const list: readonly unknown[] = world[key]
  return {...world, [key]: list.filter((_, i) => i !== part.index)}
}

/// Whether the schema allows one more.
export function hasRoomFor(world: World, kind: keyof typeof partLists): boolean {
  return kind === "goal"
    ? world.goals.length < limits.goals
    : world.walls.length + world.boxes.length + world.rounds.length < limits.things
}
