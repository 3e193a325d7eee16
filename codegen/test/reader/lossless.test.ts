/// Whatever the text: reading never throws, and the pieces put together are the text.

import fc from "fast-check"
import {beforeAll, describe, expect, test} from "vitest"
import type {Module, Reader} from "../../src/reader/index.ts"
import {openView, syncBlocks, workspaceOf} from "../../src/reader/index.ts"
import {breathe} from "../process.ts"
import {mutate, rareMutations} from "./mutations.ts"
import {corpus, testReader} from "./open.ts"

// More to look for what was never seen: `RUNS=20000 npx vitest run test/reader/lossless.test.ts`.
const runs = Number(process.env.RUNS ?? 500)
// The same cases in every regular run; many are other ones each time.
const seeded = process.env.RUNS === undefined ? {seed: 1} : {}

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

function expectLossless(module: Module): void {
  expect(module.pieces.map(p => p.slice).join("")).toBe(module.text)
  for (const p of module.pieces) {
    expect(module.text.slice(p.start, p.end)).toBe(p.slice)
    expect(p.core.start).toBeGreaterThanOrEqual(p.start)
    expect(p.core.end).toBeLessThanOrEqual(p.end)
    const source = module.text.slice(p.core.start, p.core.end)
    if (p.declaration?.kind === "raw-declaration")
      expect(p.declaration.text).toBe(source.replaceAll("\r\n", "\n"))
  }
}

describe("the pieces of a program are the program", () => {
  test.each(corpus.map(p => [p.name, p.text]))("%s", (_, text) => {
    const module = reader.read(text)
    expectLossless(module)
    expect(module.pieces.filter(p => p.broken).map(p => p.slice)).toEqual([])
  })

  test("after any small change to it", async () => {
    await fc.assert(
      fc.asyncProperty(fc.constantFrom(...corpus), rareMutations, async (program, changes) => {
        await breathe()
        expectLossless(reader.read(mutate(program.text, changes)))
      }),
      {numRuns: runs, ...seeded},
    )
  }, 1_200_000)

  test("and after it, text to blocks and back is the same, also when a block is moved and a comment is written", async () => {
    await fc.assert(
      fc.asyncProperty(
        fc.constantFrom(...corpus),
        rareMutations,
        fc.nat(50),
        async (program, changes, which) => {
          await breathe()
          const view = openView(reader, mutate(program.text, changes))
          expect(view.text).toBe(mutate(program.text, changes))
          const workspace = structuredClone(workspaceOf(view))
          const top = workspace.blocks.blocks[which % Math.max(1, workspace.blocks.blocks.length)]
          if (top === undefined) return
          top.x = 5000
          expect(syncBlocks(reader, view, workspace).text).toBe(view.text)
          top.icons = {comment: {text: "a remark"}}
          const after = syncBlocks(reader, view, workspace).text
          const shown = view.declarations.find(d => d.block.id === top.id)
          const piece = shown === undefined ? undefined : view.module.pieces[shown.piece]
          if (piece === undefined) return
          // What stands outside of the edited definition is there, byte for byte.
          expect(after.startsWith(view.text.slice(0, piece.start))).toBe(true)
          expect(after.endsWith(view.text.slice(piece.end))).toBe(true)
        },
      ),
      {numRuns: Math.ceil(runs / 4), ...seeded},
    )
  }, 1_200_000)

  test("also when it is not Haskell", async () => {
    await fc.assert(
      fc.asyncProperty(
        fc.oneof(fc.string({unit: "binary", maxLength: 300}), fc.string({unit: "grapheme", maxLength: 300})),
        async text => {
          await breathe()
          expectLossless(reader.read(text))
        },
      ),
      {numRuns: Math.max(300, Math.ceil(runs / 4))},
    )
    for (const text of [
      "",
      "\n",
      "\r\n\r\n",
      "\uFEFF",
      " ",
      "{",
      "{-",
      "module",
      '{"rosy": 1}\n',
      "<html>\n<body>\n</html>",
      "\0\0",
    ])
      expectLossless(reader.read(text))
  })
})

describe("an error stays where it is", () => {
  test("the definitions around a broken one are as before", () => {
    const good = "a = 1\n\nb :: Int\nb = 2\n\nc = 3\n"
    for (const broken of [
      "b = (",
      'b = "',
      "b = {- ",
      "b = case x of",
      "b = do",
      "b = [1,\n",
      "b x = if x then 1",
    ]) {
      const module = reader.read(good.replace("b = 2", broken))
      expect(module.pieces.filter(p => p.broken).map(p => p.names)).toEqual([["b"]])
      expect(module.pieces.map(p => p.names[0])).toEqual(["a", "b", "c"])
    }
  })

  test("a second reading of the same text gives the same nodes, and no node twice", () => {
    const text = "a = f 1\n\nb = 2\n\nb = 2\n"
    const first = reader.read(text)
    const second = reader.read(text)
    expect(second.pieces[0]?.declaration).toBe(first.pieces[0]?.declaration)
    const twice = reader.read("a = f 1\n\nx\n\na = f 1\n")
    expect(twice.pieces[0]?.declaration).not.toBe(twice.pieces[2]?.declaration)
  })
})
