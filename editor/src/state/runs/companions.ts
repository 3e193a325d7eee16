/// Companions: the other robots in the room of a run. Where each starts, and what its program is. Pure.
///
/// They belong to the page and not to the program's file: a program is alone with its robot.

import {startFaultKind} from "../../worlds/start_validation.ts"
import {type Pose, robotRadius, type World} from "../../worlds/world.ts"

export interface Companion extends Pose {
  /// A program of the learner as it is stored; `null` is the one that is open.
  readonly program: {readonly id: string; readonly name: string; readonly text: string} | null
}

/// Floor that robots leave between them at the start, m.
const gap = 0.02

/// Between two places that are tried, m.
const ringStep = 0.3
const placesInRing = 12

/// Whether a robot can start at a place, beside the first robot and the others.
export function isFreePlace(world: World, place: Pose, others: readonly Pose[]): boolean {
  if (startFaultKind({...world, start: place}) !== null) return false
  const apart = 2 * robotRadius(world) + gap
  return [world.start, ...others].every(({x, y}) => Math.hypot(x - place.x, y - place.y) >= apart)
}

/// The free place nearest to the start of the first robot, first to its left; `null` when there is none.
export function freePlace(world: World, others: readonly Pose[]): Pose | null {
  const {x, y, theta} = world.start
  for (let r = 2 * ringStep; r < Math.hypot(...world.size); r += ringStep) {
    for (let i = 0; i < placesInRing; i++) {
      // Alternately to the left and to the right of straight left.
      const turn = (i % 2 === 0 ? i / 2 : -(i + 1) / 2) * ((2 * Math.PI) / placesInRing)
      const angle = theta + Math.PI / 2 + turn
      const place = {x: round(x + r * Math.cos(angle)), y: round(y + r * Math.sin(angle)), theta}
      if (isFreePlace(world, place, others)) return place
    }
  }
  return null
}

const round = (metres: number) => Math.round(metres * 100) / 100

/// The same robots in another room: each stays where it is, or goes to the nearest free place; those without any are gone.
export function inOtherRoom(world: World, companions: readonly Companion[]): readonly Companion[] {
  return companions.reduce<readonly Companion[]>((placed, companion) => {
    const place = isFreePlace(world, companion, placed) ? companion : freePlace(world, placed)
    return place === null ? placed : [...placed, {...companion, ...place, program: companion.program}]
  }, [])
}

/// What a request for a run says of them; `text` is the open program.
export const companionsOf = (companions: readonly Companion[], text: string) =>
  companions.map(({program, x, y, theta}) => ({
    source: program?.text ?? text,
    x,
    y,
    theta,
  }))
