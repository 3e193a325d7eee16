/// The real robots that the service offers, and the one that this page has. Pure.

import type {World} from "../worlds/world.ts"

/// A robot by its name, who has it, and whether that is this page.
export interface RobotName {
  readonly name: string
  readonly holder: string | null
  readonly yours: boolean
}

/// The robot that this page has, as the service tells of it (protocol §4, `robot`).
export interface Held {
  readonly name: string
  readonly link: "connecting" | "connected" | "lost"
  readonly why: string
  /// It backs off by itself from what it runs into, and does so now.
  readonly safety: boolean
  readonly backing: boolean
  /// The emergency stop holds its wheels.
  readonly stopped: boolean
  /// Metres and radians a second.
  readonly maxSpeed: number
  readonly maxTurn: number
}

export interface RobotsState {
  /// `null` where the service has no robots.
  readonly offered: {readonly locked: boolean; readonly robots: readonly RobotName[]} | null
  readonly held: Held | null
  /// The code that opens them, as far as this page knows it.
  readonly code: string | null
  /// What the service said to the last code or wish; it is said where the robots are chosen.
  readonly refused: string | null
  /// The name that others see.
  readonly who: string
}

export const noRobots: RobotsState = {offered: null, held: null, code: null, refused: null, who: ""}

/// Metres of floor that are drawn around the start of a real robot, whose room nobody knows.
const floor = 40

/// What is drawn below a real robot: open floor, with the start of the run in the middle.
export function openFloor(name: string): World {
  return {
    name,
    title: "",
    realism: null,
    open: true,
    size: [floor, floor],
    start: {x: 0, y: 0, theta: 0},
    tile: 0.5,
    tiles: [],
    walls: [],
    boxes: [],
    rounds: [],
    goals: [],
  }
}
