/// How Rosy's own constructors and types are shown: colour, words, what their parts are called.

import type {Family} from "../shape.ts"

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

const event = (parts: readonly string[], tooltip: string): ConstructorLook => ({
  family: "event",
  asPattern: "event",
  parts,
  tooltip,
})
const state = (family: Family, parts: readonly string[], tooltip: string): ConstructorLook => ({
  family,
  asPattern: "state",
  parts,
  tooltip,
})
const command = (parts: readonly string[], tooltip: string): ConstructorLook => ({
  family: "command",
  asPattern: "command",
  parts,
  tooltip,
})
const memory = (parts: readonly string[], tooltip: string, word?: string): ConstructorLook => ({
  family: "memory",
  asPattern: "memory",
  parts,
  tooltip,
  ...(word === undefined ? {} : {word}),
})

const looks: {readonly [name: string]: ConstructorLook} = {
  Bumper: event(["side", "status"], "A bumper was pressed or released. Example: Bumper LeftBumper Pressed."),
  BumperLeft: event(["status"], "The left bumper was pressed or released. Example: BumperLeft Pressed."),
  BumperCenter: event(["status"], "The front bumper was pressed or released. Example: BumperCenter Pressed."),
  BumperRight: event(["status"], "The right bumper was pressed or released. Example: BumperRight Pressed."),
  Cliff: event(
    ["side", "status"],
    "The robot came to a hole or back to the floor. Example: Cliff LeftCliff Hole.",
  ),
  CliffLeft: event(["status"], "The left cliff sensor saw a hole or the floor. Example: CliffLeft Hole."),
  CliffCenter: event(
    ["status"],
    "The front cliff sensor saw a hole or the floor. Example: CliffCenter Hole.",
  ),
  CliffRight: event(["status"], "The right cliff sensor saw a hole or the floor. Example: CliffRight Hole."),
  Wheel: event(
    ["side", "status"],
    "A wheel left the ground or touched it again. Example: Wheel LeftWheel Air.",
  ),
  WheelLeft: event(["status"], "The left wheel left the ground or touched it again. Example: WheelLeft Air."),
  WheelRight: event(
    ["status"],
    "The right wheel left the ground or touched it again. Example: WheelRight Air.",
  ),
  Button: event(["button", "status"], "A button was pressed or released. Example: Button Button0 Pressed."),
  ButtonZero: event(["status"], "Button 0 was pressed or released. Example: ButtonZero Pressed."),
  ButtonOne: event(["status"], "Button 1 was pressed or released. Example: ButtonOne Pressed."),
  ButtonTwo: event(["status"], "Button 2 was pressed or released. Example: ButtonTwo Pressed."),
  Velocity: state(
    "command",
    ["speed, metres a second", "turning, radians a second"],
    "How fast the robot drives and turns. Example: Velocity 0.5 0 drives straight on.",
  ),
  Position: state(
    "state",
    ["x, metres", "y, metres"],
    "Where the robot is, seen from where it started. Example: Position 1 0 is one metre ahead.",
  ),
  Orientation: state(
    "state",
    ["angle, radians"],
    "Which way the robot looks; left turns count up. Example: Orientation pi looks back.",
  ),
  Pose: state(
    "state",
    ["position", "orientation"],
    "Where the robot is and which way it looks. Example: Pose here facing.",
  ),
  Seconds: state("number", ["seconds"], "A time in seconds. Example: Seconds 2."),
  Clock: state(
    "state",
    ["hours", "minutes", "seconds", "milliseconds"],
    "The time of day. Example: Clock 8 30 0 0 is half past eight.",
  ),
  Led1: command(["colour"], "Sets the first light. Example: Led1 Orange."),
  Led2: command(["colour"], "Sets the second light. Example: Led2 Green."),
  Say: command(["text"], 'The robot says something. Example: Say "hello".'),
  Just: memory(["value"], "There is a value, and this is it. Example: just 3.", "just"),
  Nothing: memory([], "There is no value. Example: send nothing.", "nothing"),
  Left: memory(["value"], "The first of two possibilities. Example: left (Velocity 0.5 0).", "left"),
  Right: memory(["value"], "The second of two possibilities. Example: right (Done ()).", "right"),
  Memory: memory(
    ["value"],
    "What the program remembers. As an input it is read, as an output it is written. Example: Memory True.",
  ),
  Param: memory(["value"], "What all tasks of the program remember together. Example: Param 0."),
  Done: {
    family: "task",
    asPattern: "task",
    parts: ["result"],
    tooltip: "Ends the task with a result. Example: Done ().",
  },
}

export function lookOf(name: string): ConstructorLook {
  return (
    looks[name] ?? {
      family: "own",
      asPattern: "own",
      parts: [],
      tooltip: `Makes a value with ${name || "a constructor"}. Example: ${name || "Go"}.`,
    }
  )
}

/// Types whose values are chosen from a menu, with the word before the menu, if any.
export interface ChoiceLook {
  readonly family: Family
  readonly word?: string
  readonly what: string
  readonly options: readonly string[]
}

export const choices: {readonly [type: string]: ChoiceLook} = {
  BumperSide: {family: "event", what: "side", options: ["LeftBumper", "CenterBumper", "RightBumper"]},
  ButtonStatus: {family: "event", what: "status", options: ["Pressed", "Released"]},
  CliffSide: {family: "event", what: "side", options: ["LeftCliff", "CenterCliff", "RightCliff"]},
  CliffStatus: {family: "event", what: "status", options: ["Hole", "Floor"]},
  WheelSide: {family: "event", what: "side", options: ["LeftWheel", "RightWheel"]},
  WheelStatus: {family: "event", what: "status", options: ["Air", "Ground"]},
  ButtonNumber: {family: "event", what: "button", options: ["Button0", "Button1", "Button2"]},
  RobotStatus: {family: "event", word: "RobotStatus", what: "status", options: ["Online", "Offline"]},
  LedColor: {family: "command", what: "colour", options: ["Black", "Green", "Orange", "Red"]},
  Sound: {
    family: "command",
    word: "Sound",
    what: "sound",
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
  Bool: {family: "choice", what: "yes or no", options: ["True", "False"]},
  Ordering: {family: "choice", what: "order", options: ["LT", "EQ", "GT"]},
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
