/// Comments behind the last step or the last local definition of a definition: they are on its block, as those of the others are, and go with it.

import {beforeAll, describe, expect, test} from "vitest"
import type {Reader} from "../../src/reader/index.ts"
import {layoutOf, openView, syncBlocks, workspaceOf} from "../../src/reader/index.ts"
import {without} from "../../src/workspace/block_moves.ts"
import {everyBlock} from "./agreement.ts"
import {testReader} from "./open.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

/// The program after the deletion of its last step or local definition that has a comment.
function withoutLast(text: string): string {
  const view = openView(reader, text)
  const workspace = workspaceOf(view)
  const last = workspace.blocks.blocks
    .flatMap(everyBlock)
    .slice(1)
    .findLast(b => b.icons?.comment !== undefined)
  const after = syncBlocks(reader, view, without(workspace, last?.id ?? ""))
  // What is saved opens as the same.
  const opened = openView(reader, after.text, structuredClone(layoutOf(after)))
  expect(opened.contradicted).toBeUndefined()
  expect(workspaceOf(opened)).toEqual(workspaceOf(after))
  return after.text
}

describe("the comment behind the end of a definition", () => {
  test.each([
    ["f = do\n  a 1\n  b 2 -- two\n", ["two"]],
    ["f = do\n  a 1 -- one\n  b 2 {- two -}\n\ng = 1\n", ["one", "two"]],
    ["f x = y\n  where\n    y = 2 -- two\n", ["two"]],
    ["f = do\n  when c $ do\n    a 1\n    b 2 -- two\n", ["two"]],
    // Of no step: it stays behind the definition.
    ["f x =\n  x + 1 -- more\n", []],
    ["f = 1 -- one\n", []],
  ])("of %j is on the block of its last step", (text, comments) => {
    const view = openView(reader, text)
    const found = workspaceOf(view)
      .blocks.blocks.flatMap(everyBlock)
      .flatMap(b => b.icons?.comment?.text ?? [])
    expect(found).toEqual(comments)
    expect(syncBlocks(reader, view, structuredClone(workspaceOf(view))).text).toBe(text)
  })

  test.each([
    ["f = do\n  a 1\n  b 2 -- two\n  c 3 -- three\n", "f = do\n  a 1\n  b 2 -- two\n"],
    ["f = do\n  a 1\n  b 2 -- two\n\ng = 1\n", "f = a 1\n\ng = 1\n"],
    ["f x = y\n  where\n    y = 2\n    z = 3 -- three\n", "f x = y\n  where\n    y = 2\n"],
  ])("of %j goes with it", (text, after) => {
    expect(withoutLast(text)).toBe(after)
  })
})
