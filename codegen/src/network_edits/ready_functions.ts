/// Functions that work as they are, for a sensor that is connected to an actuator: one of the toolbox's ready-made functions where one has that type, or else
/// an example of what the actuator takes. No function where there is no example.

import {isAtomicType} from "../haskell/type_text.ts"
import {events, states, viewedEvent} from "../robot/roles.ts"
import type {SavedBlock} from "../serialized_blocks.ts"
import {
  answers,
  anything,
  con,
  make,
  match,
  named,
  num,
  pat,
  pick,
  reaction,
  text,
} from "../workspace/toolbox/block_builders.ts"
import {readyReactions} from "../workspace/toolbox/ready_made_definitions.ts"
import {examples} from "../workspace/toolbox/toolbox_robot_examples.ts"

export interface ReadyFunction {
  /// A definition with another name, and without a type.
  readonly block: SavedBlock
  readonly signature: string
}

/// What a function is made from. Types are written as the program writes them.
export interface Wire {
  /// `()` is the tick.
  readonly sensor: string
  readonly actuator: string
}

/// Ready-made functions of the toolbox by sensor and actuator.
const readyNames: ReadonlyMap<string, string> = new Map([
  ["() Velocity", "driveOn"],
  ["Bumper Velocity", "backOff"],
  ["Bumper Sound", "complain"],
  ["Cliff Velocity", "stopAtEdge"],
  ["Cliff Led1", "edgeLight"],
  ["LineSensor Velocity", "followLine"],
  ["Button Sound", "buttonSound"],
  ["Button Led1", "buttonLight"],
  ["Clock Led1", "blinkLight"],
  ["Velocity Velocity", "faster"],
])

/// The name of the ready-made function that a wire would be.
export const readyName = ({sensor, actuator}: Wire): string | undefined =>
  readyNames.get(`${sensor} ${actuator}`)

/// `expanded` gives a type without synonyms, `values` the values of a type of the program whose values hold nothing; `pattern` takes any value of the sensor.
export interface ReadyContext {
  expanded(type: string): string
  values(type: string): readonly string[]
  pattern(): SavedBlock
}

export function readyFunction(wire: Wire, context: ReadyContext): ReadyFunction | undefined {
  const {sensor, actuator} = wire
  const name = readyName(wire)
  const made = readyReactions().find(({block}) => block.extraState?.name === name)?.block
  const block = name === undefined ? example(wire, context) : made
  if (block === undefined) return undefined
  const isOptional = Object.values(block.inputs ?? {}).some(({block: answer}) => isJust(answer))
  const atom = isAtomicType(actuator) ? actuator : `(${actuator})`
  const result = isOptional ? `Maybe ${atom}` : actuator
  return {block: structuredClone(block), signature: sensor === "()" ? result : `${sensor} -> ${result}`}
}

const isJust = (block: SavedBlock | undefined) =>
  block?.type === "construct" && block.extraState?.con === "Just"

/// Patterns of events at which something begins: a bump, an edge, a lifted wheel, a pressed button.
const beginnings: {readonly [event: string]: SavedBlock} = {
  Bumper: match("ButtonStatus", "Pressed"),
  Cliff: match("CliffStatus", "Hole"),
  Wheel: match("WheelStatus", "Air"),
  Button: match("ButtonStatus", "Pressed"),
}

function example({sensor, actuator}: Wire, context: ReadyContext): SavedBlock | undefined {
  const whole = viewedEvent(sensor)
  const beginning = beginnings[whole]
  const isContact = beginning !== undefined && whole !== "Button"
  const held = /^Memory (.*)$/s.exec(actuator)?.[1]
  const as =
    sensor === "()" ? "command" : events.has(sensor) ? "event" : states.has(sensor) ? "state" : "plain"
  if (held !== undefined && held === sensor) {
    const value = sensor.charAt(0).toLowerCase() + sensor.slice(1)
    return reaction("", as, [named(value)], con("Memory", make("name", {name: value, args: 0})))
  }
  const answer = exampleOf(actuator, isContact, context)
  if (answer === undefined) return undefined
  if (sensor === "()") return reaction("", as, [], answer)
  if (beginning !== undefined) {
    const when = whole === sensor ? pat(sensor, anything("side"), beginning) : pat(sensor, beginning)
    const cases = [
      {when, answer: con("Just", answer)},
      {when: anything("thing"), answer: con("Nothing")},
    ]
    return answers("", cases)
  }
  const read = /^(?:Memory|Param) (.*)$/s.exec(sensor)?.[1]
  const quiet = read !== undefined && context.expanded(read) === "Bool" ? quietOf(actuator) : undefined
  if (quiet === undefined) return reaction("", as, [context.pattern()], answer)
  const head = sensor.startsWith("Param ") ? "Param" : "Memory"
  const loud = exampleOf(actuator, true, context) ?? answer
  return answers(
    "",
    [
      {when: pat(head, match("Bool", "True")), answer: loud},
      {when: pat(head, match("Bool", "False")), answer: quiet},
    ],
    as,
  )
}

const velocity = (speed: string) => con("Velocity", num(speed), num("0"))

/// What an actuator does while nothing is remembered.
function quietOf(actuator: string): SavedBlock | undefined {
  if (actuator === "Velocity") return velocity("0.2")
  if (actuator === "Led1" || actuator === "Led2") return con(actuator, pick("LedColor", "Black"))
  return undefined
}

/// A value of an actuator that can be seen or heard; away from what the robot has come upon.
function exampleOf(actuator: string, isAway: boolean, context: ReadyContext): SavedBlock | undefined {
  const held = /^Memory (.*)$/s.exec(actuator)?.[1]
  if (held !== undefined) {
    const value = exampleValue(held, context)
    return value === undefined ? undefined : con("Memory", value)
  }
  switch (actuator) {
    case "Velocity":
      return velocity(isAway ? "-0.2" : "0.2")
    case "Led1":
    case "Led2":
      return con(actuator, pick("LedColor", "Red"))
    case "Sound":
      return pick("Sound", "ErrorSound")
    case "Say":
      return con("Say", text("hello"))
    default: {
      const [only, ...others] = context.values(actuator)
      if (only !== undefined) return others.length === 0 ? con(only) : undefined
      return examples("command").find(
        ({block: {extraState}}) => extraState?.con === actuator || extraState?.of === actuator,
      )?.block
    }
  }
}

/// What a memory can be given. Of several values the last: programs begin with the first one.
function exampleValue(type: string, {expanded, values}: ReadyContext): SavedBlock | undefined {
  switch (expanded(type)) {
    case "Bool":
      return pick("Bool", "True")
    case "Int":
      return num("1")
    case "Double":
      return num("0.5")
    default: {
      const last = values(type).at(-1)
      return last === undefined ? undefined : con(last)
    }
  }
}
