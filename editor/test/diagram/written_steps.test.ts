/// Tasks that are read from the blocks: the same charts as the compiler reports, also of programs that it does not compile.

import {writtenNetwork} from "@rosy/codegen/network-edits"
import type {Reader} from "@rosy/codegen/reader"
import {beforeAll, describe, expect, it} from "vitest"
import {testReader} from "../../../codegen/test/reader/open.ts"
import {diagram} from "../../../languages/en/page/diagram.ts"
import {readHaskell} from "../../src/controller/document/document_conversion.ts"
import {innermostBlock, offsetOf, textRangeOf} from "../../src/program/program.ts"
import type {ProgramPart} from "../../src/program/program_graph.ts"
import {networkOf} from "../../src/views/diagram/network/network_builder.ts"
import {outlineText} from "../../src/views/diagram/network/outline.ts"
import {openedTasks, withWrittenTasks} from "../../src/views/diagram/network/written_steps.ts"
import {graphNames, readGraph, readParts, readSource} from "./graphs.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

/// What is drawn of a program whose compiler's report is this.
function drawn(text: string, reported: readonly ProgramPart[]) {
  const {workspace, program} = readHaskell(reader, "x", text).document
  const opened = openedTasks(reported, at =>
    innermostBlock(program.spans, {
      start: offsetOf(text, at),
      end: offsetOf(text, {line: at.endLine, column: at.endColumn}),
    }),
  )
  const textOf = (block: string) => {
    const range = textRangeOf(program.spans, block)
    return range === null ? "" : text.slice(range.start, range.end)
  }
  const parts = withWrittenTasks(reported, writtenNetwork(workspace).tasks, opened, textOf)
  return networkOf(
    parts,
    ({line, column, endColumn}) => text.split("\n")[line - 1]?.slice(column - 1, endColumn - 1) ?? "",
  )
}

describe("tasks that are read from the blocks", () => {
  it.each(graphNames())("are those of the compiler: %s", name => {
    // What the program calls results, and how a task of the library ends, is not in the report.
    const unnamed = (lines: string) => lines.replaceAll(/; gives [^;\n]*(?=; then)/g, "")
    const now = drawn(readSource(name), readParts(name))
    expect(unnamed(outlineText(now, diagram.list))).toBe(unnamed(outlineText(readGraph(name), diagram.list)))
  })

  it("are there before the program compiles, with their blocks and results", () => {
    const text = `f :: Velocity
f = _

main = simulate (f, do
  n <- dice 6
  forever $ do
    drive 50
    race (wait 1) (say (show n)))
`
    const {nodes, edges} = drawn(text, [])
    expect(outlineText({nodes, edges}, diagram.list)).toBe(`one after the other
  dice 6: step; gives n; then steps
  again and again
    drive 50: step; then steps
    race; then back to drive 50
      wait 1: step
      say (show n): step
`)
    expect(nodes.every(({block}) => block !== null && block !== "")).toBe(true)
  })
})
