import {readFileSync} from "node:fs"
import * as codegen from "@rosy/codegen"
import {expect, test} from "vitest"
import {suggest} from "../../src/views/blocks/interaction/insertion_points.ts"

test("who adds to what runs is offered first what does not run yet", () => {
  const text = readFileSync(
    new URL("../../../examples/accelerateAndPlay/program.rosy", import.meta.url),
    "utf8",
  )
  const read = codegen.parseProject(text)
  if (!read.ok) throw new Error(read.message)
  const {workspace} = codegen.openProject(read.project)
  const offered = (empty: string) => {
    const blocks = workspace.blocks.blocks.map(block =>
      block.type === "main" ? {...block, inputs: {...block.inputs, [empty]: {}}} : block,
    )
    const now = {...workspace, blocks: {...workspace.blocks, blocks}}
    const main = blocks.find(({type}) => type === "main")?.id ?? ""
    const found = suggest(codegen.session(), now, {block: main, input: empty}, codegen.toolbox("reactions"))
    return found.slice(0, 2).map(item => item.label)
  }
  expect(offered("R0")).toEqual(["accelerate", "play"])
  expect(offered("R1")).toEqual(["play", "accelerate"])
})

test.each([
  ["tasks", ["drive 50 cm", "turn 90 degrees"]],
  ["reactions", ["ready-made: drive straight on", "ready-made: back off at a bump"]],
] as const)("simulate of an empty program is offered what the level %s begins with", (level, labels) => {
  const workspace = codegen.newWorkspace()
  const [main] = workspace.blocks.blocks
  const found = suggest(
    codegen.session(),
    workspace,
    {block: main?.id ?? "", input: "R0"},
    codegen.toolbox(level),
  )
  expect(found.slice(0, 2).map(item => item.label)).toEqual(labels)
})

test("an answer of any type is offered an own type last, until the program has it", () => {
  const named = (own: readonly codegen.SavedBlock[]) => {
    const workspace = codegen.newWorkspace()
    const answer = {id: "f", type: "define", extraState: {name: "f", as: "event", arity: 1, equations: [{}]}}
    const blocks = [...workspace.blocks.blocks, answer, ...own]
    const now = {...workspace, blocks: {...workspace.blocks, blocks}}
    const found = suggest(codegen.session(), now, {block: "f", input: "E0_0"}, codegen.toolbox("reactions"))
    return found.map(item => item.block)
  }
  const knock = named([]).at(-1)
  expect(knock).toMatchObject({type: "data", extraState: {name: "Knock"}})
  if (knock === undefined) throw new Error("expected an own type")
  const after = named([{...knock, id: "knock"}])
  expect(after).toContainEqual({type: "construct", extraState: {con: "Knock", args: 0}})
  expect(after.map(block => block.type)).not.toContain("data")
})

test("a definition is offered to itself after all else that fits", () => {
  const workspace = codegen.newWorkspace()
  const answer = {id: "f", type: "define", extraState: {name: "f", as: "event", arity: 1, equations: [{}]}}
  const blocks = [...workspace.blocks.blocks, answer]
  const now = {...workspace, blocks: {...workspace.blocks, blocks}}
  const categories = codegen.toolbox("reactions").map(category => ({
    ...category,
    items: category.items.filter(({block}) => block.type !== "data"),
  }))
  const labels = suggest(codegen.session(), now, {block: "f", input: "E0_0"}, categories).map(
    item => item.label,
  )
  expect(labels.indexOf("f")).toBe(labels.length - 1)
  expect(labels.length).toBeGreaterThan(5)
})
