/// What the diagram shows of a program that the compiler has not reported yet: the functions of its text, and tasks as they were.

import type {WrittenFunction, WrittenNetwork, WrittenShape} from "@rosy/codegen/network-edits"
import {describe, expect, it} from "vitest"
import type {ProgramPart} from "../../src/program/program_graph.ts"
import {pendingParts} from "../../src/views/diagram/network/pending_parts.ts"

const type = (written: string): WrittenShape => ({
  kind: "type",
  written,
  spelled: written,
  own: false,
  topic: null,
})
const fn = (name: string, input: string, runs = true): WrittenFunction => ({
  name,
  runs,
  inputs: [type(input)],
  output: type("Velocity"),
})
const part = (name: string, input: string): ProgramPart => ({
  kind: "function",
  name,
  at: null,
  inputs: [type(input)],
  output: type("Velocity"),
})
const step: ProgramPart = {kind: "step", name: "drive 10", at: null}
const literal: ProgramPart = {...part("Velocity 0.5 0", "()"), inputs: []} as ProgramPart
const network = (...functions: readonly WrittenFunction[]): WrittenNetwork => ({
  functions,
  types: [],
  tasks: null,
  steps: [],
  hasSimulate: true,
})
const defined = new Set(["main", "go", "stop", "beside"])

describe("before the compiler's report the diagram shows", () => {
  it.each<[string, readonly ProgramPart[], WrittenNetwork, readonly ProgramPart[]]>([
    ["a new function", [], network(fn("go", "Bumper")), [part("go", "Bumper")]],
    ["another input", [part("go", "Bumper")], network(fn("go", "Cliff")), [part("go", "Cliff")]],
    [
      "no deleted function",
      [part("gone", "Bumper"), step],
      network(fn("go", "Bumper")),
      [step, part("go", "Bumper")],
    ],
    [
      "no function that stands beside",
      [part("beside", "Bumper")],
      network(fn("beside", "Bumper", false)),
      [],
    ],
    ["tasks and values as they were reported", [step, literal], network(), [step, literal]],
    ["a definition that it cannot judge", [part("stop", "Bumper")], network(), [part("stop", "Bumper")]],
  ])("%s", (_, reported, written, shown) => {
    expect(pendingParts(reported, written, defined)).toEqual(shown)
  })

  it("what was reported, where simulate cannot be read", () => {
    const written = {functions: [], types: [], tasks: null, steps: [], hasSimulate: false}
    expect(pendingParts([part("gone", "Bumper")], written, defined)).toEqual([part("gone", "Bumper")])
  })
})
