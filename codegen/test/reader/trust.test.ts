/// What an edit in blocks may rely on: text that GHC does not parse gets no structure, and an edit is made only where its new text, read again, is the
/// tree of the blocks.

import {beforeAll, expect, test} from "vitest"
import {readTree} from "../../src/blocks/block_reader.ts"
import type {Reader} from "../../src/reader/index.ts"
import {openView, syncBlocks, workspaceOf} from "../../src/reader/index.ts"
import {isSaidBy} from "../../src/reader/view/correspondence.ts"
import type {SavedBlock} from "../../src/serialized_blocks.ts"
import {everyBlock} from "./agreement.ts"
import {testReader} from "./open.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

/// The text after the first number of a program became 77.
function withNumber(text: string): string {
  const view = openView(reader, text)
  const workspace = structuredClone(workspaceOf(view))
  const number = workspace.blocks.blocks.flatMap(everyBlock).find(b => b.type === "number")
  if (number !== undefined) number.extraState = {value: "77"}
  return syncBlocks(reader, view, workspace).text
}

test.each([
  ["steps that lost their column", "main = do\n  print 1\n print 2\n print 3\n"],
  ["steps beside `do` that lost their column", "main = do print 1\n print 2\n"],
  ["a definition whose `where` is missing", "f x = y + 1\n  y = x * 2\n"],
  ["an alternative that lost its column", "f x = case x of\n  1 -> 2\n 3 -> 4\n"],
  ["a condition as a function", "f x = if x then 1 else 2\n  (y = 3)\n"],
  ["steps before another argument", "f = when True do\n  print 1\n 2\n"],
])("text that GHC does not parse stays as it is: %s", (_, text) => {
  const after = withNumber(text)
  // An edit of a part that is whole changes nothing but the number.
  expect([text, text.replace("1", "77")]).toContain(after)
  expect(after).not.toMatch(/77 +print|77 *\(/)
})

test("steps as a function are steps where the file has BlockArguments", () => {
  const text = "{-# LANGUAGE BlockArguments #-}\nmain = do\n   f 1\n g 2\n"
  expect(withNumber(text)).toBe(text.replace("1", "77"))
  expect(openView(reader, text.replace("BlockArguments", "LambdaCase")).module.pieces[1]?.broken).toBe(true)
})

test("an extension that is written above changes how the definitions below are read", () => {
  const body = "main = do\n   f 1\n g 2\n"
  const pragma = "{-# LANGUAGE BlockArguments #-}\n"
  expect(reader.read(body).pieces.some(p => p.broken)).toBe(true)
  expect(reader.read(pragma + body).pieces.some(p => p.broken)).toBe(false)
  expect(reader.read(body).pieces.some(p => p.broken)).toBe(true)
})

test.each([
  ["main = print $ $(sel 4 1) (a, 1)", "main = print $ $(sel 4 1) (a, 77)"],
  ["main = print $(g 1) $ h", "main = print $(g 1) $ h"],
  ["main = f $x 1", "main = f $x 77"],
  ["main = f$x 1", "main = f$x 77"],
])("a splice of Template Haskell stays one beside an edit: %s", (before, after) => {
  const pragma = "{-# LANGUAGE TemplateHaskell #-}\n"
  expect(withNumber(`${pragma}${before}\n`)).toBe(`${pragma}${after}\n`)
})

test.each([
  ["f = spec $ do\n  describe x $ do\n    it y $ do\n      check 1 `is` 2 -- c\n"],
  ["f = g $ do h 1\n"],
  ["f = do\n  g 1\n"],
  ["f = if x\n  then do\n    g 1\n  else do\n    h\n"],
  ["f = replicateM_ n $ do\n  move 1\n"],
  ["f = forever do\n  move 1\n"],
])("a `do` of one step keeps its form beside an edit in it: %s", text => {
  expect(withNumber(text)).toBe(text.replace("1", "77"))
})

test.each([
  ["f = (a + b) * c", "f = a + b * c"],
  ["f x = g (h x)", "f x = g h x"],
  ["f = [1, 2]", "f = [1]"],
  ["f = do\n  a\n  b", "f = do\n  a b"],
  ["f :: Int\nf = 1", "f = 1"],
  ["f = g $(x)", "f = g x"],
])("the tree of `%s` is not said by `%s`", (blocks, text) => {
  const declarationOf = (of: string) =>
    readTree(workspaceOf(openView(reader, of)).blocks.blocks[0] as SavedBlock).declarations[0]
  const pieceOf = (of: string) => reader.read(`${of}\n`).pieces[0]
  const [said, own, other] = [declarationOf(blocks), pieceOf(blocks), pieceOf(text)]
  if (said === undefined || own === undefined || other === undefined) throw new Error("expected a definition")
  expect([isSaidBy(said, own), isSaidBy(said, other)]).toEqual([true, false])
})

test.each([
  ["show", "Say (show A)", "deriving (Show)"],
  ["compare", "if A == B then Say 1 else Say 2", "deriving (Eq)"],
  ["order", "if A < B then Say 1 else Say 2", "deriving (Eq, Ord)"],
])(
  "a type whose values an edit is the first to %s derives the class, in text and blocks",
  (_, value, deriving) => {
    const text = "data M = A | B\n\ngo = Say 1\n"
    const view = openView(reader, text)
    const [, definition] = workspaceOf(openView(reader, `data M = A | B\n\ngo = ${value}\n`)).blocks.blocks
    const [data, before] = workspaceOf(view).blocks.blocks
    const edited = {...(definition as SavedBlock), id: before?.id}
    const after = syncBlocks(reader, view, {
      blocks: {languageVersion: 0, blocks: [data as SavedBlock, edited as SavedBlock]},
    })
    expect(after.text).toBe(`data M = A | B ${deriving}\n\ngo = ${value}\n`)
    expect(after.remade).toBe(true)
    expect(readTree(workspaceOf(after).blocks.blocks[0] as SavedBlock).declarations[0]).toMatchObject({
      deriving: deriving
        .replace(/deriving|[()]/g, "")
        .split(",")
        .map(c => c.trim()),
    })
    // A text that needed the class before the edit is not changed by another edit.
    const typed = `data M = A | B\n\ngo = ${value}\n\nother = 1\n`
    const there = openView(reader, typed)
    const workspace = structuredClone(workspaceOf(there))
    const [number] = everyBlock(workspace.blocks.blocks[2] as SavedBlock).filter(b => b.type === "number")
    if (number !== undefined) number.extraState = {value: "7"}
    expect(syncBlocks(reader, there, workspace).text).toBe(typed.replace("other = 1", "other = 7"))
  },
)
