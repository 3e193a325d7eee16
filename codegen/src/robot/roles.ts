/// What the robots' types do in a program, as sets: their roles in the robot descriptions (rules R1 to R4 and R9 of `rosy-hs/LANGUAGE.md`).

import {robot} from "./description.generated.ts"

/// Each value triggers a function.
export const events: ReadonlySet<string> = new Set(robot.roles.events)

/// They always have a current value.
export const states: ReadonlySet<string> = new Set(robot.roles.states)

/// States that odometry measures.
export const odometry: ReadonlySet<string> = new Set(robot.roles.odometry)

/// Commands of all robots, in the order of their descriptions.
export const commands: ReadonlySet<string> = new Set(robot.roles.commands)

/// Commands that hold until the next one (rule R9).
export const heldCommands: ReadonlySet<string> = new Set(robot.roles.held)

/// Types with one constructor, which has the type's name.
export const records: ReadonlySet<string> = new Set(robot.roles.records)

const views: {readonly [type: string]: string} = robot.roles.views

/// The event that a type shows one place of, such as `Bumper` for `BumperLeft`; the type itself if it is no such view.
export const viewedEvent = (type: string): string => views[type] ?? type

const choices: {readonly [type: string]: {readonly options: readonly string[]}} = robot.choices

const typesOfValues = new Map(
  Object.entries(choices).flatMap(([type, {options}]) => options.map(option => [option, type] as const)),
)

/// The type that a constructor of the robots' types makes: `Velocity` for `Velocity`, `Sound` for `ErrorSound`.
export const typeOfConstructor = (name: string): string | undefined =>
  records.has(name) ? name : typesOfValues.get(name)
