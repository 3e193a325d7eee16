import {readFileSync} from "node:fs"
import * as codegen from "@rosy/codegen"
import {expect, test} from "vitest"
import {suggest} from "../../src/blocks/scope.ts"

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
