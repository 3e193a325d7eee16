/// Real robots offered by the service, and the robot that this page controls. Pure.

import type {RobotName, RobotState} from "../wire/page/robots.generated.ts"
import {usualRobot, type World} from "../worlds/world.ts"

/// The robot that this page controls (protocol §4, `robot`).
export type OwnedRobot = Omit<RobotState, "op" | "sentence" | "link"> & {
  readonly link: Exclude<RobotState["link"], "gone">
}

/// Safety rules of the robot, simulated or real: on or off, and since when they override the program, in seconds of the
/// run; `null` while they do not.
export interface SafetyRules {
  readonly on: boolean
  readonly since: number | null
}

export interface RobotsState {
  /// `null` where the service has no robots.
  readonly offered: {
    readonly locked: boolean
    readonly robots: readonly RobotName[]
    /// More may appear by themselves.
    readonly discovers: boolean
  } | null
  readonly held: OwnedRobot | null
  /// The code that unlocks them; `null` until it is entered or read from the storage.
  readonly code: string | null
  /// What the service said to the last code or wish; it is said where the robots are chosen.
  readonly refused: string | null
  /// The name that others see.
  readonly who: string
  /// Whether a program that drives a real robot also drives the simulated one beside it.
  readonly twin: boolean
  /// The room of the simulated robot while the page has a real one.
  readonly room: World | null
}

export const noRobots: RobotsState = {
  offered: null,
  held: null,
  code: null,
  refused: null,
  who: "",
  twin: false,
  room: null,
}

/// What is drawn below the robot that the page has: with a twin the room in which that drives.
export function floorOf(robots: RobotsState, name: string): World {
  return (robots.twin ? robots.room : null) ?? openFloor(name)
}

/// Metres of floor that are drawn around the start of a real robot, whose room is unknown.
const floor = 40

/// What is drawn below a real robot: open floor, with the start of the run in the middle.
function openFloor(name: string): World {
  return {
    name,
    title: "",
    realism: null,
    dock: null,
    battery: 1,
    scanner: false,
    robot: usualRobot,
    open: true,
    size: [floor, floor],
    start: {x: 0, y: 0, theta: 0},
    tile: 0.5,
    tiles: [],
    lines: [],
    walls: [],
    boxes: [],
    rounds: [],
    goals: [],
  }
}
