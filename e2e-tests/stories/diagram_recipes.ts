/// How the paper's examples are wired in the diagram, from an empty program, with any kind of input: which wires are drawn, in which order. The equations
/// are those of the example, as a person writes them.

import {readFileSync} from "node:fs"

/// `sensor Bumper`, `actuator Velocity`, `function spin`, `memory Mode`, `event ChgDir`; `memory` alone is a new one.
export type End = `${"sensor" | "actuator" | "function" | "memory" | "event"} ${string}` | "memory"

/// What is asked when a connection is made.
export interface Answers {
  /// Of a new function or event.
  readonly name?: string
  /// What a new memory remembers.
  readonly remembers?: string
  readonly joins?: "either"
}

/// What a person does in the diagram alone.
export interface Wiring {
  /// An empty program.
  begins(): Promise<void>
  connects(from: End, to: End, answers?: Answers): Promise<void>
  /// Writes a definition that the program has, such as the equations of a function.
  writes(name: string, text: string): Promise<void>
  /// Writes a definition that the program does not have.
  defines(name: string, text: string): Promise<void>
  /// Adds a task of the program as a step.
  adds(task: string): Promise<void>
}

type Wire = readonly [from: End, to: End, answers?: Answers]

export interface Recipe {
  readonly example: string
  /// Types that the wires need.
  readonly types?: readonly string[]
  readonly wires: readonly Wire[]
  /// `simulate` runs this task.
  readonly task?: string
  /// Whether what `simulate` gets is written: groups of functions, and steps with values.
  readonly isMainWritten?: boolean
}

const walk: readonly Wire[] = [
  ["sensor Bumper", "actuator Led1", {name: "bumper"}],
  ["sensor Cliff", "actuator Led2", {name: "cliff"}],
  ["sensor Wheel", "actuator Led1", {name: "wheel"}],
  ["function wheel", "actuator Led2"],
  ["function wheel", "memory", {remembers: "Mode"}],
  ["sensor StdGen", "memory Mode", {name: "chgdir"}],
  ["sensor Seconds", "function chgdir"],
  ["function bumper", "function chgdir", {name: "ChgDir"}],
  ["function cliff", "event ChgDir"],
  ["memory Mode", "actuator Velocity", {name: "spin"}],
  ["sensor Seconds", "function spin"],
  ["function spin", "memory Mode"],
]

export const recipes: readonly Recipe[] = [
  {example: "move", wires: [["sensor tick", "actuator Velocity", {name: "move"}]]},
  {example: "accelerate", wires: [["sensor Velocity", "actuator Velocity", {name: "accelerate"}]]},
  {
    example: "accelerateAndPlay",
    wires: [
      ["sensor Velocity", "actuator Velocity", {name: "accelerate"}],
      ["sensor Bumper", "actuator Sound", {name: "play"}],
    ],
  },
  {
    example: "forwardBackward",
    types: ["Hit"],
    wires: [
      ["sensor Bumper", "memory", {name: "bump", remembers: "Hit"}],
      ["memory Hit", "actuator Velocity", {name: "forwardBackward"}],
      ["sensor Velocity", "function forwardBackward"],
    ],
  },
  {example: "randomWalk", types: ["Mode"], wires: walk},
  {
    example: "safetyControl",
    types: ["Blocked"],
    wires: [
      ["sensor Bumper", "memory", {name: "watch", remembers: "Blocked"}],
      ["sensor Cliff", "function watch", {joins: "either"}],
      ["sensor Wheel", "function watch", {joins: "either"}],
      ["memory Blocked", "actuator Velocity", {name: "cruise"}],
      ["sensor Position", "function cruise"],
      ["sensor Bumper", "actuator Velocity", {name: "safetyControl"}],
      ["sensor Cliff", "function safetyControl", {joins: "either"}],
      ["sensor Wheel", "function safetyControl", {joins: "either"}],
    ],
  },
  {
    example: "mux",
    types: ["M1", "M2", "M"],
    wires: [
      ["sensor Button", "actuator Velocity", {name: "button"}],
      ["sensor Position", "actuator Velocity", {name: "circle"}],
      ["sensor Seconds", "actuator Velocity", {name: "muxVelocity"}],
      ["memory", "function muxVelocity", {remembers: "M"}],
    ],
  },
  {
    example: "safeRandomWalk",
    types: ["Mode", "M1", "M2", "M"],
    wires: [
      ...walk,
      ["sensor Bumper", "memory", {name: "watch", remembers: "Bool"}],
      ["sensor Cliff", "function watch", {joins: "either"}],
      ["memory Mode", "actuator Velocity", {name: "safetyControl"}],
      ["sensor Seconds", "actuator Velocity", {name: "muxVelocity"}],
      ["memory", "function muxVelocity", {remembers: "M"}],
    ],
    isMainWritten: true,
  },
  {
    example: "turn",
    wires: [["sensor Orientation", "actuator Velocity", {name: "runTurn"}]],
    isMainWritten: true,
  },
  {
    example: "moveAhead",
    wires: [["sensor Position", "memory", {name: "startMove", remembers: "Position"}]],
    isMainWritten: true,
  },
  {example: "drawSquare", wires: [], task: "drawSquare"},
]

/// The definitions of an example with the comments above them, by name.
export function definitionsOf(example: string): ReadonlyMap<string, string> {
  const text = readFileSync(new URL(`../../examples/${example}/Main.hs`, import.meta.url), "utf8")
  return new Map(paragraphs(text).map(one => [nameIn(one), one]))
}

/// What stands between empty lines.
export const paragraphs = (text: string): readonly string[] => text.trim().split(/\n{2,}/)

function nameIn(definition: string): string {
  const code = definition.replace(/^--.*\n/gm, "")
  return /^(?:(?:data|newtype|type) )?([\w']+)/.exec(code)?.[1] ?? code
}

/// Wires an example and writes what its wires do not say.
export async function builds(wiring: Wiring, {example, types = [], wires, ...of}: Recipe): Promise<void> {
  const definitions = definitionsOf(example)
  const there = new Set(types)
  const defines = (name: string) => wiring.defines(name, definitions.get(name) ?? "")
  await wiring.begins()
  for (const name of types) await defines(name)
  for (const [from, to, answers] of wires) {
    await wiring.connects(from, to, answers)
    if (answers?.name !== undefined) there.add(answers.name)
  }
  for (const [name, text] of definitions) {
    if (name === "main" || types.includes(name)) continue
    if (there.has(name)) await wiring.writes(name, text)
    else await defines(name)
  }
  if (of.task !== undefined) await wiring.adds(of.task)
  if (of.isMainWritten) await wiring.writes("main", definitions.get("main") ?? "")
}
