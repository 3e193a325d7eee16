/// Outcome of a preview: what the robot does in it, as facts, and which of two outcomes is better. Pure.

import type {PathPoint, Preview} from "../../state/messages/preview.ts"

/// A side of the room's picture.
export type Onward = "left" | "right" | "up" | "down"

export interface Outcome {
  readonly bumps: number
  /// Length of the path, m.
  readonly distance: number
  /// It bumps again and again at one place.
  readonly trembles: boolean
  /// It neither drives nor turns.
  readonly stands: boolean
  /// It stays where it bumped last.
  readonly sticks: boolean
  /// Where it ends, seen from its last bump; `null` without a bump, and near to it.
  readonly onward: Onward | null
  /// Goals that are reached.
  readonly goals: number
  /// When the program fails, s.
  readonly fails: number | null
}

/// A shorter path is none, m: the points of a path are 2 cm apart.
const leastPath = 0.03

/// A smaller turn is none, rad.
const leastTurn = 0.02

/// So many bumps in a row, each within this time (s) and distance (m) of the one before, are a trembling.
const trembling = {bumps: 4, time: 1, distance: 0.15}

/// A robot that for so long (s) has not gone so far (m) from its last bump sticks there. A bump may push it a little.
const sticking = {time: 1, distance: 0.05}

/// Nearer to its last bump than this the robot is on no side of it, m.
const away = 0.1

/// `start` is the angle of the robot at the start, rad.
export function outcomeOf(preview: Preview, start: number): Outcome {
  const {path, collisions, goals, ended, time, theta} = preview
  const distance = lengthOf(path)
  const turned = Math.abs(Math.sin((theta - start) / 2))
  return {
    bumps: collisions.length,
    distance,
    trembles: isTrembling(collisions),
    stands: distance < leastPath && turned < leastTurn / 2,
    sticks: isSticking(preview),
    onward: onwardOf(preview),
    goals: goals.filter(goal => goal.state === "done").length,
    fails: ended === "error" || ended === "stuck" ? time : null,
  }
}

const apart = (a: Pick<PathPoint, "x" | "y">, b: Pick<PathPoint, "x" | "y">) =>
  Math.hypot(b.x - a.x, b.y - a.y)

const lengthOf = (path: readonly PathPoint[]): number =>
  path.reduce((sum, point, i) => sum + apart(path[i - 1] ?? point, point), 0)

function isTrembling(bumps: readonly PathPoint[]): boolean {
  let row = 1
  return bumps.some((bump, i) => {
    const before = bumps[i - 1]
    const isNear =
      before !== undefined &&
      bump.time - before.time <= trembling.time &&
      apart(before, bump) <= trembling.distance
    row = isNear ? row + 1 : 1
    return row >= trembling.bumps
  })
}

function isSticking({path, collisions, time}: Preview): boolean {
  const last = collisions.at(-1)
  if (last === undefined || time - last.time < sticking.time) return false
  return path.every(point => point.time <= last.time || apart(last, point) < sticking.distance)
}

function onwardOf({collisions, x, y}: Preview): Onward | null {
  const last = collisions.at(-1)
  if (last === undefined || apart(last, {x, y}) < away) return null
  const [dx, dy] = [x - last.x, y - last.y]
  if (Math.abs(dx) >= Math.abs(dy)) return dx < 0 ? "left" : "right"
  return dy < 0 ? "down" : "up"
}

/// Negative when `a` is better: it reaches more goals, does not fail, moves, does not tremble, does not stick, bumps less often, drives
/// further.
export function compareOutcomes(a: Outcome, b: Outcome): number {
  const ranks = [a, b].map(({goals, fails, stands, trembles, sticks, bumps, distance}) => [
    -goals,
    fails === null ? 0 : 1,
    stands ? 1 : 0,
    trembles ? 1 : 0,
    sticks ? 1 : 0,
    bumps,
    -Math.round(10 * distance),
  ])
  const [first = [], second = []] = ranks
  return first.map((rank, i) => rank - (second[i] ?? 0)).find(difference => difference !== 0) ?? 0
}

/// Whether a way out mends what the program does. Where neither of them bumps, trembles or fails, the run does not tell, and it may.
export function isBetter(way: Outcome, program: Outcome): boolean {
  if (way.stands) return false
  if (program.stands || way.goals > program.goals) return true
  if ((way.fails === null) !== (program.fails === null)) return way.fails === null
  if (way.trembles !== program.trembles) return program.trembles
  if (way.sticks !== program.sticks) return program.sticks
  return way.bumps < program.bumps || (way.bumps === 0 && program.bumps === 0)
}
