/// `to-blocks`, without files.

import {beforeAll, describe, expect, test} from "vitest"
import {commands, toBlocks} from "../../src/commands.ts"
import {openProject, parseProject} from "../../src/index.ts"
import type {Reader} from "../../src/reader/index.ts"
import {corpus, testReader} from "./open.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

const utf8 = (text: string) => new TextEncoder().encode(text)

describe("to-blocks", () => {
  test.each(corpus.map(p => [p.name, p.text]))(
    "%s comes back byte for byte, with blocks that stand for it",
    (name, text) => {
      const made = toBlocks(name, utf8(text), reader)
      expect(made.status).toBe(0)
      expect(commands("to-haskell", ["p.rosy"], () => made.out)).toEqual({out: text, err: "", status: 0})
      const parsed = parseProject(made.out)
      if (!parsed.ok) throw new Error(parsed.message)
      expect(openProject(parsed.project).changed.filter(c => c.name !== undefined)).toEqual([])
    },
  )

  test("says what stays as text, and why", () => {
    const made = toBlocks("p", utf8("type family A a\n"), reader)
    expect(made.status).toBe(0)
    expect(made.err).toBe(
      "“type family A a” stays as text. Types that are computed from types. Blocks have no shape for them.",
    )
  })

  test("says when a file is not text", () => {
    const made = toBlocks("p", Uint8Array.of(0x61, 0x20, 0x3d, 0x20, 0xff), reader)
    expect([made.status, made.err.split("\n")[0]]).toEqual([
      1,
      "Some characters of this file are not UTF-8 and were replaced.",
    ])
  })
})
