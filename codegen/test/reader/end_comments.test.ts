/// Comments behind the last step or the last local definition of a definition: they are on its block, as those of the others are, and go with it.

import {beforeAll, describe, expect, test} from "vitest"
import type {Reader, View} from "../../src/reader/index.ts"
import {layoutOf, openView, syncBlocks, syncText, workspaceOf} from "../../src/reader/index.ts"
import {without} from "../../src/workspace/moves/block_moves.ts"
import {everyBlock} from "./agreement.ts"
import {testReader} from "./open.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

/// The program after the deletion of a block: what is saved opens as the same.
function deleted(view: View, id: string): View {
  const after = syncBlocks(reader, view, without(workspaceOf(view), id))
  const opened = openView(reader, after.text, structuredClone(layoutOf(after)))
  expect(opened.contradicted).toBeUndefined()
  expect(workspaceOf(opened)).toEqual(workspaceOf(after))
  return after
}

/// The program after the deletion of its last step or local definition that has a comment.
function withoutLast(text: string): string {
  const view = openView(reader, text)
  const last = workspaceOf(view)
    .blocks.blocks.flatMap(everyBlock)
    .slice(1)
    .findLast(b => b.icons?.comment !== undefined)
  return deleted(view, last?.id ?? "").text
}

/// The words of the comments on the blocks of a definition.
const commentsOf = (view: View, name: string) =>
  view.declarations
    .filter(d => d.name === name)
    .flatMap(d => everyBlock(d.block))
    .flatMap(b => b.icons?.comment?.text ?? [])

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

describe("the comment behind a definition that is deleted", () => {
  test("is above the next one, in the text and on its block", () => {
    const view = openView(reader, "f = 1 -- one\ng = 2\n")
    const after = deleted(view, view.declarations[0]?.block.id ?? "")
    expect(after.text).toBe("-- one\ng = 2\n")
    expect(commentsOf(after, "g")).toEqual(["one"])
    expect(after.remade).toBe(true)
  })

  test("whose text is unfinished is on the block of what the next line holds", () => {
    const whole = "f = 1\n\nmain = simulate (Say . show . f)\n"
    const view = syncText(reader, openView(reader, whole), whole.replace("show", "sh-- hi {there}\now"))
    expect(view.declarations.map(d => d.dimmed)).toEqual([false, true, false])
    const after = deleted(view, view.declarations[1]?.block.id ?? "")
    expect(after.text).toBe("f = 1\n-- hi {there}\now . f)\n")
    expect(after.declarations[1]?.block.icons?.comment?.text).toBe("hi {there}")
  })
})

describe("comments of steps that are deleted one by one", () => {
  test.each([
    "f = do\n  a 1\n  -- above\n  b 2 -- two\n  -- behind\n\ng = 1\n",
    "f = do\n  a 1\n  b 2 {- two -}\n  -- above\n  c 3 -- three\n",
    "f = do -- first\n  a 1\n  when c $ do\n    b 2 -- two\n    -- end\n",
    "f x = y\n  where\n    -- of y\n    y = 2 -- two\n    -- of z\n    z = 3\n    -- end\n",
  ])("in %j are the same in text and blocks after each", text => {
    let view = openView(reader, text)
    for (let step = 0; step < 4; step++) {
      const steps = everyBlock(view.declarations[0]?.block ?? {type: ""}).filter(
        b => /^(statement|step|define|do_|bind|call|name)/.test(b.type) && b.icons !== undefined,
      )
      const last = steps.at(-1)?.id
      if (last === undefined || last === view.declarations[0]?.block.id) break
      view = deleted(view, last)
    }
  })
})
