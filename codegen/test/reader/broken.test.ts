/// Definitions with a syntax error: what can be read is blocks, the part with the error is text, and mending it brings all blocks.

import {beforeAll, describe, expect, test} from "vitest"
import type {Reader} from "../../src/reader/index.ts"
import {causeOf, openView, syncBlocks, syncText, workspaceOf} from "../../src/reader/index.ts"
import {everyBlock, infer} from "../../src/workspace/inference/workspace_inference.ts"
import {disagreements} from "./agreement.ts"
import {testReader} from "./open.ts"

let reader: Reader
let other: Reader
beforeAll(async () => {
  reader = await testReader()
  other = await testReader()
})

/// A broken program, the text of the part that is kept, and how many blocks there are beside it at least.
const programs: readonly (readonly [what: string, text: string, kept: string, blocks: number])[] = [
  ["a missing else", "f x = if x then 1\n", "if x then 1", 2],
  ["an open bracket in a step", 'main = do\n  say "a"\n  wait (\n  say "b"\n  drive 1\n', "wait (", 7],
  ["a bracket too much in an equation", "f 0 = 1\nf n = n * 2)\nf m = m\n", "n * 2)", 5],
  ["two commas in a local definition", "f x = g x\n  where\n    g y = [1,, 2]\n    h = 3\n", "[1,, 2]", 6],
  ["an alternative", "f x = case x of\n  1 -> 2\n  2 -> (3\n  n -> n\n", "(3", 7],
  ["a guard too much", "f x = x + 1\n\n  | otherwise = _\n", "x + 1\n\n  | otherwise = _", 2],
  ["an error above a where", "f x = x + * 2\n  where\n    y = 2\n", "x + * 2", 3],
]

describe("a definition with", () => {
  test.each(programs)("%s keeps what can be read as blocks", (_, text, kept, blocks) => {
    const view = openView(reader, text)
    expect(view.text).toBe(text)
    expect(view.module.pieces.filter(p => p.broken)).toHaveLength(1)
    const all = [...everyBlock(workspaceOf(view))]
    const raw = all.filter(b => b.type.startsWith("raw_"))
    expect(raw.map(b => [b.extraState?.text, causeOf(String(b.extraState?.reason))])).toEqual([
      [kept, "broken"],
    ])
    expect(all.length - raw.length).toBeGreaterThanOrEqual(blocks)
    expect(view.declarations.map(d => d.dimmed)).toEqual([false])
    expect(disagreements(view, other)).toEqual([])
  })
})

test("mending the text brings the other blocks, and those that were there stay the same", () => {
  const text = 'main = do\n  say "a"\n  wait (\n  say "b"\n'
  const view = openView(reader, text)
  const mended = syncText(reader, view, text.replace("wait (", "wait 2"))
  const ids = (v: typeof view, type: string) =>
    [...everyBlock(workspaceOf(v))].filter(b => b.type === type).map(b => b.id)
  expect([...everyBlock(workspaceOf(mended))].filter(b => b.type.startsWith("raw_"))).toEqual([])
  expect(ids(mended, "text")).toEqual(ids(view, "text"))
})

test("an edit of a readable part changes only its characters", () => {
  const text = 'main   =  do -- start\n  say "a"\n  wait   (\n  drive   7 -- far\n  say "b"\n'
  const view = openView(reader, text)
  const workspace = structuredClone(workspaceOf(view))
  for (const b of everyBlock(workspace)) if (b.type === "number") b.extraState = {value: "42"}
  expect(syncBlocks(reader, view, workspace).text).toBe(text.replace("7", "42"))
})

test("the readable parts of a broken definition have types", () => {
  const view = openView(reader, "f :: Int -> Bool\nf n = not n\n  where\n    g = (1\n")
  expect(infer(workspaceOf(view)).problems.map(p => p.kind)).toContain("type-mismatch")
})

test("text that was never a definition stays text as a whole", () => {
  const view = openView(reader, "this is (no Haskell\n")
  expect(workspaceOf(view).blocks.blocks.map(b => b.type)).toEqual(["raw_definition"])
})
