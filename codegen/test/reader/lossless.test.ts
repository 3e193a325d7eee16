/// Whatever the text: reading never throws, and the pieces put together are the text.

import fc from "fast-check"
import {beforeAll, describe, expect, test} from "vitest"
import type {Module, Reader} from "../../src/reader/index.ts"
import {mutate, mutations} from "./mutations.ts"
import {corpus, testReader} from "./open.ts"

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

  test("after any small change to it", () => {
    fc.assert(
      fc.property(fc.constantFrom(...corpus), mutations, (program, changes) => {
        expectLossless(reader.read(mutate(program.text, changes)))
      }),
      {numRuns: 600},
    )
  })

  test("also when it is not Haskell", () => {
    fc.assert(
      fc.property(
        fc.oneof(fc.string({unit: "binary", maxLength: 300}), fc.string({unit: "grapheme", maxLength: 300})),
        text => {
          expectLossless(reader.read(text))
        },
      ),
      {numRuns: 400},
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
