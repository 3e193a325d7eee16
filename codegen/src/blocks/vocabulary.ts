/// How Rosy's own constructors and types are shown: colour, words, what their parts are called.

import type {Family} from "../shape.ts"
import {type Words, words} from "../words/index.ts"

export interface ConstructorLook {
  /// Colour and outline as a value, and as a pattern.
  readonly family: Family
  readonly asPattern: Family
  /// What each part is, for labels that are read aloud and for empty sockets.
  readonly parts: readonly string[]
  /// The word on the block, where it is not the constructor's name.
  readonly word?: string
  readonly tooltip: string
}

const event = ["event", "event"] as const
const command = ["command", "command"] as const
const memory = ["memory", "memory"] as const

/// Colour and outline as a value, and as a pattern.
const families: {readonly [Name in keyof Words["constructors"]]: readonly [Family, Family]} = {
  Bumper: event,
  BumperLeft: event,
  BumperCenter: event,
  BumperRight: event,
  Cliff: event,
  CliffLeft: event,
  CliffCenter: event,
  CliffRight: event,
  Wheel: event,
  WheelLeft: event,
  WheelRight: event,
  Button: event,
  ButtonZero: event,
  ButtonOne: event,
  ButtonTwo: event,
  Velocity: ["command", "state"],
  Position: ["state", "state"],
  Orientation: ["state", "state"],
  Pose: ["state", "state"],
  Seconds: ["number", "state"],
  Clock: ["state", "state"],
  Led1: command,
  Led2: command,
  Say: command,
  Just: memory,
  Nothing: memory,
  Left: memory,
  Right: memory,
  Memory: memory,
  Param: memory,
  Done: ["task", "task"],
}

const isKnown = (name: string): name is keyof Words["constructors"] => Object.hasOwn(families, name)

export function lookOf(name: string): ConstructorLook {
  if (!isKnown(name)) return {family: "own", asPattern: "own", parts: [], tooltip: words.makesAValue(name)}
  const [family, asPattern] = families[name]
  const said: {readonly parts: readonly string[]; readonly tooltip: string; readonly word?: string} =
    words.constructors[name]
  return {family, asPattern, ...said}
}

/// Types whose values are chosen from a menu, with the word before the menu, if any.
export interface ChoiceLook {
  readonly family: Family
  readonly word?: string
  readonly options: readonly string[]
}

export const choices: {readonly [type: string]: ChoiceLook} = {
  BumperSide: {family: "event", options: ["LeftBumper", "CenterBumper", "RightBumper"]},
  ButtonStatus: {family: "event", options: ["Pressed", "Released"]},
  CliffSide: {family: "event", options: ["LeftCliff", "CenterCliff", "RightCliff"]},
  CliffStatus: {family: "event", options: ["Hole", "Floor"]},
  WheelSide: {family: "event", options: ["LeftWheel", "RightWheel"]},
  WheelStatus: {family: "event", options: ["Air", "Ground"]},
  ButtonNumber: {family: "event", options: ["Button0", "Button1", "Button2"]},
  RobotStatus: {family: "event", word: "RobotStatus", options: ["Online", "Offline"]},
  LedColor: {family: "command", options: ["Black", "Green", "Orange", "Red"]},
  Sound: {
    family: "command",
    word: "Sound",
    options: [
      "ErrorSound",
      "OnSound",
      "OffSound",
      "RechargeSound",
      "ButtonSound",
      "CleaningStartSound",
      "CleaningEndSound",
    ],
  },
  Bool: {family: "choice", options: ["True", "False"]},
  Ordering: {family: "choice", options: ["LT", "EQ", "GT"]},
}

/// What a type's values are, for a label that is read aloud.
export function whatOf(type: string): string {
  const said: {readonly [type: string]: string} = words.whats
  return said[type] ?? type
}

/// The type whose menu holds a constructor, if one does.
export function choiceOf(name: string): string | undefined {
  return Object.keys(choices).find(type => choices[type]?.options.includes(name))
}

const typeFamilies: {readonly [type: string]: Family} = {
  ...Object.fromEntries(
    "Bumper BumperLeft BumperCenter BumperRight BumperSide ButtonStatus Cliff CliffLeft CliffCenter CliffRight CliffSide CliffStatus Wheel WheelLeft WheelRight WheelSide WheelStatus Button ButtonZero ButtonOne ButtonTwo ButtonNumber RobotStatus"
      .split(" ")
      .map(t => [t, "event" as const]),
  ),
  Velocity: "command",
  Position: "state",
  Orientation: "state",
  Pose: "state",
  Clock: "state",
  StdGen: "state",
  Led1: "command",
  Led2: "command",
  LedColor: "command",
  Sound: "command",
  Say: "command",
  Memory: "memory",
  Param: "memory",
  Maybe: "memory",
  Either: "memory",
  Task: "task",
  Done: "task",
  IO: "task",
  Double: "number",
  Int: "number",
  Integer: "number",
  Float: "number",
  Seconds: "number",
  Word: "number",
  Bool: "choice",
  Ordering: "choice",
  Char: "own",
}

/// The family of a type's values. A pattern of Velocity is a state; as a value it is a command.
export function familyOfHead(type: string, as: "value" | "pattern"): Family {
  return as === "pattern" && type === "Velocity" ? "state" : (typeFamilies[type] ?? "own")
}
