/// Types and type problems in a learner's words.

import {familyOfHead} from "../blocks/vocabulary.ts"
import type {Family} from "../shape.ts"
import type {TypeProblem} from "./problems.ts"
import type {Constraint, Type} from "./type.ts"
import {asFunction, prune, showType, spine} from "./type.ts"

const nouns: {readonly [type: string]: string} = {
  Double: "a number",
  Float: "a number",
  Int: "a whole number",
  Integer: "a whole number",
  Word: "a whole number",
  Bool: "a yes or no",
  Char: "a character",
  Led1: "a light",
  Led2: "a light",
  LedColor: "a colour",
  Sound: "a sound",
  Say: "something to say",
  Bumper: "a bumper event",
  Cliff: "a cliff event",
  Wheel: "a wheel event",
  Button: "a button event",
  BumperSide: "a side of the bumper",
  ButtonStatus: "Pressed or Released",
  CliffStatus: "Hole or Floor",
  WheelStatus: "Air or Ground",
  Seconds: "a time in seconds",
  IO: "a whole program",
  Task: "a task",
}

/// "a Velocity", "a light", "a list of numbers", "a function".
export function describe(type: Type): string {
  const {head, args} = spine(type)
  if (head.kind === "meta") return "something"
  if (head.kind === "var") return "something of any type"
  if (head.kind !== "con") return "something"
  const [first] = args
  if (asFunction(type) !== undefined) return "a function"
  if (head.name === "[]" && first !== undefined) {
    const item = spine(first)
    if (item.head.kind === "con" && item.head.name === "Char") return "text"
    return `a list (${showType(type)})`
  }
  if (head.name === "()") return "nothing, ()"
  if (/^\(,+\)$/.test(head.name)) return `${args.length} things together, ${showType(type)}`
  const noun = nouns[head.name]
  if (noun !== undefined && args.length === 0) return noun
  const shown = showType(type)
  return `${/^[AEIOU]/.test(shown) ? "an" : "a"} ${shown}`
}

const abilities: {readonly [name: string]: string} = {
  Num: "be a number",
  Fractional: "be a number with a decimal point",
  Floating: "be a number with a decimal point",
  RealFrac: "be a number with a decimal point",
  Real: "be a number",
  Integral: "be a whole number",
  Eq: "be compared",
  Ord: "be put in order",
  Show: "be shown as text",
  Enum: "be counted through",
  Random: "be drawn at random",
  Sensor: "be sensed",
  Command: "be sent to the robot",
  Controller: "run on the robot",
  Runnable: "be run on the robot",
  Monad: "be done step by step",
  Applicative: "be done step by step",
  Functor: "hold values to change",
  Foldable: "be gone through item by item",
  Default: "have a first value to remember",
}

export function ability(constraint: Constraint): string {
  return abilities[constraint.name] ?? `do what ${constraint.name} asks`
}

/// What is wrong, and why or what to do: two short sentences. `what` names the block it is about.
export function problemWords(
  problem: TypeProblem,
  what: string,
): {kind: string; message: string; hint: string} {
  switch (problem.kind) {
    case "mismatch": {
      const wanted = describe(problem.wanted)
      const found = describe(problem.found)
      const same = wanted === found
      return {
        kind: "type-mismatch",
        message: same
          ? `Here goes ${showType(problem.wanted)}, and ${what} is ${showType(problem.found)}.`
          : `Here goes ${wanted}, and ${what} is ${found}.`,
        hint: "Put something else here, or change what is around it.",
      }
    }
    case "no-instance":
      if (problem.constraint.name === "Ends") return endWords(problem.constraint)
      return {
        kind: "type-mismatch",
        message: `${capital(describe(problem.constraint.type))} cannot ${ability(problem.constraint)}.`,
        hint: "Use another block here.",
      }
    case "unknown-name":
      return {
        kind: "not-in-scope",
        message: `${what} has no meaning here.`,
        hint: "A name is known only inside the function that names it; check its spelling or define it.",
      }
    case "taken":
      return {
        kind: "duplicate",
        message: `Haskell itself has a \`${problem.name}\` already.`,
        hint: "Give this one another name.",
      }
    case "twice":
      return {
        kind: "duplicate",
        message: `\`${problem.name}\` is given to two things here.`,
        hint: "Give one of them another name.",
      }
    case "too-many-arguments":
      return {
        kind: "type-mismatch",
        message: `${what} gets more inputs than it takes.`,
        hint: "Take the last ones away.",
      }
    case "wrong-field-count":
      return {
        kind: "type-mismatch",
        message: `${problem.name} has ${problem.wanted} parts, and here are ${problem.found}.`,
        hint: "Take a fresh block from the toolbox.",
      }
    case "ambiguous":
      if (problem.constraint.name === "Sensor")
        return {
          kind: "ambiguous",
          message: "Nothing says what one of the inputs of a function here is.",
          hint: "Put a pattern like Bumper into it, or write the function's type.",
        }
      if (["Command", "Controller", "Runnable"].includes(problem.constraint.name))
        return {
          kind: "ambiguous",
          message: "Nothing says what a function here sends.",
          hint: "Let it send something definite, or write the function's type.",
        }
      return {
        kind: "ambiguous",
        message: `Nothing says what type ${what} has.`,
        hint: "Use a value of a definite type, or write the type on the definition.",
      }
    case "too-general":
      return {
        kind: "type-mismatch",
        message: `The type of this definition promises too much: not everything can ${ability(problem.constraint)}.`,
        hint: `Add ${problem.constraint.name} ${showType(problem.constraint.type)} to its type.`,
      }
    case "bad-signature":
      return {
        kind: "syntax",
        message: `“${problem.text}” is not a type.`,
        hint: "Write it like Velocity -> Maybe Sound.",
      }
    case "unknown-type":
      return {
        kind: "not-in-scope",
        message: `There is no type ${problem.name}.`,
        hint: "Check its spelling, or define it.",
      }
  }
}

/// A `Done` that does not belong: outside a task, or with another result than its task's.
function endWords(constraint: Constraint): {kind: string; message: string; hint: string} {
  const [end] = spine(constraint.type).args
  const outside = end !== undefined && showType(end) === "NotInATask"
  return {
    kind: "type-mismatch",
    message: outside
      ? "A Done ends a task, and this is no task."
      : "This Done does not carry what its task ends with.",
    hint: outside
      ? "Put it into the functions of a task."
      : "Give Done the same kind of value everywhere in the task.",
  }
}

export function capital(text: string): string {
  return text.replace(/^\p{Ll}/u, c => c.toUpperCase())
}

/// The colour of a type's values; `undefined` while the type is unknown.
export function familyOfType(type: Type, as: "value" | "pattern"): Family | undefined {
  const f = asFunction(type)
  // A function looks like what it reacts to.
  if (f !== undefined) return familyOfType(f.from, "pattern") ?? "own"
  const {head} = spine(prune(type))
  return head.kind === "con" ? familyOfHead(head.name, as) : undefined
}
