/// Names of memories: the synonym that the program writes.

import {expect, test} from "vitest"
import type {ProgramPart, TypeShape} from "../../src/program/program_graph.ts"
import {memoryNames} from "../../src/program/written_memories.ts"
import {namedMemory} from "../../src/values/quantities.ts"
import {networkOf} from "../../src/views/diagram/network/network_builder.ts"

const type = (written: string, spelled = written): TypeShape => ({
  kind: "type",
  written,
  spelled,
  own: false,
  topic: null,
})
const hit = type("Memory Hit", "Memory Bool")
const lit = type("Memory Lit", "Memory Bool")
const plain = type("Memory Bool")

/// A task in a repetition whose function takes the first of the types and gives the others.
const program = (...[output = plain, ...inputs]: readonly TypeShape[]): readonly ProgramPart[] => {
  const function_: ProgramPart = {kind: "function", name: "f", at: null, inputs, output}
  const task: ProgramPart = {kind: "task", name: "t", at: null, start: [], parts: [function_]}
  return [{kind: "repeat", name: "", at: null, turns: 2, steps: [task]}]
}

test.each([
  ["one synonym", [hit, hit], "Memory Hit"],
  ["a synonym beside the type itself", [plain, {kind: "maybe", of: hit}], "Memory Hit"],
  ["a synonym of the whole", [{kind: "all", of: [type("Flag", "Memory Bool")]}], "Flag"],
  ["two synonyms for one memory", [hit, lit], "Memory Bool"],
  ["none", [plain], "Memory Bool"],
  ["a synonym of a command", [type("Go", "Velocity")], "Memory Bool"],
] satisfies readonly (readonly [string, readonly TypeShape[], string])[])("%s", (_, shapes, name) => {
  const parts = program(...shapes)
  const nameOf = memoryNames({parts})
  expect(nameOf("Memory Bool")).toBe(name)
  expect(namedMemory([{type: "Memory Bool", value: "True"}], nameOf)).toEqual([
    {key: "memory Memory Bool", name, type: "Memory Bool", value: "True"},
  ])
  const stores = networkOf(parts, () => "").nodes.filter(node => node.kind === "store")
  for (const store of stores) expect(store.label).toBe(name)
})

test("a text, which a run tells as a list of characters", () => {
  const nameOf = memoryNames({parts: program(type("Memory Note", "Memory String"))})
  expect(nameOf("Memory [Char]")).toBe("Memory Note")
})

test("two tasks may each remember the type", () => {
  const memory = [1, 2].map(value => ({type: "Memory Bool", value: `${value}`}))
  const named = namedMemory(memory, memoryNames({parts: program(hit)}))
  expect(named.map(one => one.name)).toEqual(["Memory Hit", "Memory Hit (2)"])
})
