/// Labels of Rosy's constructors and types on blocks: colour, words, names of their fields.

import type {Family} from "../../block_shape.ts"
import {robot} from "../../robot/description.generated.ts"
import {type Words, words} from "../../words/index.ts"

export interface ConstructorLabels {
  /// Colour and outline as a value, and as a pattern.
  readonly family: Family
  readonly asPattern: Family
  /// What each part is, for labels that are read aloud and for empty sockets.
  readonly parts: readonly string[]
  /// The word on the block, where it is not the constructor's name.
  readonly word?: string
  readonly tooltip: string
}

const memory = ["memory", "memory"] as const

/// Colour and outline as a value, and as a pattern.
const families: {readonly [Name in keyof Words["constructors"]]: readonly [Family, Family]} = {
  ...robot.families,
  Seconds: ["number", "state"],
  Clock: ["state", "state"],
  Just: memory,
  Nothing: memory,
  Left: memory,
  Right: memory,
  Memory: memory,
  Param: memory,
  Done: ["task", "task"],
}

/// Units of a constructor's parts, as they stand behind each part on a block; those of the robot's types are in its description.
export const units: {readonly [name: string]: readonly string[]} = {
  ...robot.units,
  Seconds: ["s"],
  Clock: ["h", "min", "s", "ms"],
}

const isKnown = (name: string): name is keyof Words["constructors"] => Object.hasOwn(families, name)

export function labelsOf(name: string): ConstructorLabels {
  if (!isKnown(name)) return {family: "own", asPattern: "own", parts: [], tooltip: words.makesAValue(name)}
  const [family, asPattern] = families[name]
  const labels: {readonly parts: readonly string[]; readonly tooltip: string; readonly word?: string} =
    words.constructors[name]
  return {family, asPattern, ...labels}
}

/// Types whose values are chosen from a menu, with the word before the menu, if any.
export interface ChoiceLabels {
  readonly family: Family
  readonly word?: string
  readonly options: readonly string[]
}

export const choices: {readonly [type: string]: ChoiceLabels} = {
  ...robot.choices,
  Bool: {family: "choice", options: ["True", "False"]},
  Ordering: {family: "choice", options: ["LT", "EQ", "GT"]},
}

/// What a type's values are, for a label that is read aloud.
export function exampleNameOf(type: string): string {
  const nouns: {readonly [type: string]: string} = words.whats
  return nouns[type] ?? type
}

/// The word on blocks for a value that is chosen from a menu: the robot description's label, else the constructor's name.
export function valueLabel(type: string, value: string): string {
  const labels: {readonly [type: string]: {readonly [value: string]: string}} = words.valueLabels
  return labels[type]?.[value] ?? value
}

/// The type whose menu holds a constructor, if one does.
export function choiceOf(name: string): string | undefined {
  return Object.keys(choices).find(type => choices[type]?.options.includes(name))
}

const typeFamilies: {readonly [type: string]: Family} = {
  Clock: "state",
  StdGen: "state",
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

/// The families of the robot's types, as a value and as a pattern.
const robotFamilies: {readonly [type: string]: readonly [Family, Family]} = robot.typeFamilies

/// The family of a type's values. A pattern of Velocity is a state; as a value it is a command.
export function familyOfHead(type: string, as: "value" | "pattern"): Family {
  const [value, pattern] = robotFamilies[type] ?? []
  return (as === "pattern" ? pattern : value) ?? typeFamilies[type] ?? "own"
}
