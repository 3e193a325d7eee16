/// The step at which a task is, from what fired.

import {describe, expect, it} from "vitest"
import type {ProgramPart} from "../../src/program/program_graph.ts"
import {networkOf} from "../../src/views/diagram/network/network_builder.ts"
import {runningSteps} from "../../src/views/diagram/network/running_steps.ts"

const step = (name: string): ProgramPart => ({kind: "step", name, at: null})
const chain = (kind: "sequence" | "repeat", ...steps: readonly ProgramPart[]): ProgramPart => ({
  kind,
  name: "",
  at: null,
  turns: null,
  steps,
})
const race = (...steps: readonly ProgramPart[]): ProgramPart => ({
  kind: "race",
  name: "",
  at: null,
  turns: null,
  steps,
})

/// The running steps after these firings, 0.02 s from one to the next, and some time.
function running(program: ProgramPart, trail: readonly string[], after = 0): readonly string[] {
  const firings = new Map<string, number[]>()
  for (const [i, name] of trail.entries()) firings.set(name, [...(firings.get(name) ?? []), i * 0.02])
  const collapsed = trail.filter((name, i) => name !== trail[i - 1])
  const network = networkOf([program], () => "")
  const now = {trail: collapsed, firings, time: trail.length * 0.02 + after}
  return [...runningSteps(network, now)].map(id => id.replace(/^.*\//, ""))
}

const many = (name: string) => Array.from({length: 9}, () => name)

describe("the step at which a task is", () => {
  const two = chain("repeat", step("driveUntilBump"), step("driveBack"))
  it.each<[string, ProgramPart, readonly string[], number, readonly string[]]>([
    ["is none before anything has fired", two, [], 0, []],
    ["is what fired last", two, ["start of a task"], 9, ["driveUntilBump"]],
    ["stays until another one fires", two, ["start of a task", "once", "once"], 1, ["driveBack"]],
    ["begins again in a loop", two, ["start of a task", "once", "start of a task"], 0, ["driveUntilBump"]],
    [
      "is the second of two with the same name",
      chain("sequence", step("drive"), step("turn"), step("drive")),
      [...many("drive"), ...many("turn"), ...many("drive")],
      0,
      ["drive#2"],
    ],
    [
      "is a wait behind what has stopped firing",
      chain("sequence", step("drive"), step("wait"), step("turn")),
      many("drive"),
      0.5,
      ["wait"],
    ],
    [
      "is not yet the wait while there are firings",
      chain("sequence", step("drive"), step("wait")),
      many("drive"),
      0,
      ["drive"],
    ],
    ["is a wait at the beginning", chain("sequence", step("wait"), step("turn")), [], 0.1, ["wait"]],
    [
      "is in each of two side by side",
      chain("sequence", step("turn"), race(step("drive"), step("say"))),
      ["turn", "drive", "say"],
      0,
      ["race", "drive", "say"],
    ],
  ])("%s", (_, program, trail, after, expected) => {
    expect(running(program, trail, after)).toEqual(expected)
  })
})
