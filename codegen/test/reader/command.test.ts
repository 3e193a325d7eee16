/// `to-blocks`, without files.

import {beforeAll, describe, expect, test} from "vitest"
import {argumentsOf, commands, toBlocks} from "../../src/commands.ts"
import {openProject, parseProject} from "../../src/index.ts"
import type {Reader} from "../../src/reader/index.ts"
import {corpus, testReader} from "./open.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

const utf8 = (text: string) => new TextEncoder().encode(text)

const utf16 = (text: string, isLittleEndian: boolean) => {
  const units = [...`\uFEFF${text}`].flatMap(c => Array.from({length: c.length}, (_, i) => c.charCodeAt(i)))
  return Uint8Array.from(units.flatMap(u => (isLittleEndian ? [u & 255, u >> 8] : [u >> 8, u & 255])))
}
const encodings: [string, (text: string) => Uint8Array][] = [
  ["UTF-8 with a mark", text => utf8(`\uFEFF${text}`)],
  ["UTF-16, little-endian", text => utf16(text, true)],
  ["UTF-16, big-endian", text => utf16(text, false)],
]

describe("to-blocks", () => {
  test.each(corpus.map(p => [p.name, p.text]))(
    "%s comes back byte for byte, with blocks that stand for it",
    (name, text) => {
      const made = toBlocks(name, utf8(text), reader)
      expect(made.status).toBe(0)
      expect(commands("to-haskell", ["p.rosy"], () => utf8(made.out))).toEqual({
        out: text,
        err: "",
        status: 0,
      })
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

  test("reads literate Haskell by the name of its file, and says when that has no code", () => {
    const made = toBlocks("walk.lhs", utf8("A robot.\n\n> main = simulate (drive 50)\n"), reader)
    const parsed = parseProject(made.out)
    if (!parsed.ok) throw new Error(parsed.message)
    expect(parsed.project).toMatchObject({
      name: "walk",
      haskell: "-- A robot.\n\nmain = simulate (drive 50)\n",
    })
    expect(toBlocks("walk.lhs", utf8("Only prose.\n"), reader)).toMatchObject({out: "", status: 1})
  })

  test("says when a file is not text, and in which encoding it was saved", () => {
    const bytes = Uint8Array.of(0x61, 0x20, 0x3d, 0x20, 0xe4)
    expect(toBlocks("p", bytes, reader)).toEqual({
      out: "",
      err: "This file is in the encoding Latin-1, not in UTF-8: see line 1, “a = ä”. Save it as UTF-8 in your editor, or add --encoding Latin-1 here.",
      status: 1,
    })
    expect(toBlocks("p", Uint8Array.of(0, 1), reader).err).toBe("This file is not text in UTF-8.")
  })

  test("reads an older encoding that is named, and nothing else of what is no UTF-8", () => {
    const bytes = Uint8Array.of(0x61, 0x20, 0x3d, 0x20, 0xe4, 0x93, 0x0a)
    const made = toBlocks("p", bytes, reader, true)
    expect([made.err, made.status]).toEqual(["", 0])
    const parsed = parseProject(made.out)
    if (!parsed.ok) throw new Error(parsed.message)
    expect(parsed.project.haskell).toBe("a = ä“\n")
    expect(toBlocks("p", Uint8Array.of(0xe4, 0x81), reader, true).err).toBe("This file is not text in UTF-8.")
    const project = Uint8Array.from(made.out, c => ({ä: 0xe4, "“": 0x93})[c] ?? c.charCodeAt(0))
    const read = (args: string[]) => commands("to-haskell", args, () => project)
    expect(read(["p.rosy"]).err).toContain("or add --encoding Windows-1252 here.")
    for (const encoding of [["--encoding", "Windows-1252"], ["--encoding=latin-1"]])
      expect(read(["p.rosy", ...encoding]).out).toBe("a = ä“\n")
  })

  test.each<[string[], object | undefined]>([
    [["a.hs"], {path: "a.hs", readsOlder: false}],
    [["a.hs", "-o", "b"], {path: "a.hs", to: "b", readsOlder: false}],
    [["-o", "b", "--encoding", "LATIN-1", "a.hs"], {path: "a.hs", to: "b", readsOlder: true}],
    [["--encoding=windows-1252", "a.hs"], {path: "a.hs", readsOlder: true}],
    [["a.hs", "--encoding", "morse"], undefined],
    [["a.hs", "--encoding"], undefined],
    [["a.hs", "--encoding="], undefined],
    [["a.hs", "-o"], undefined],
    [["a.hs", "b.hs"], undefined],
    [[], undefined],
  ])("understands %j", (given, expected) => {
    expect(argumentsOf(given)).toEqual(expected)
  })

  test.each(encodings)(
    "reads %s, keeps the mark, and gives the blocks of the text without it",
    (_, encode) => {
      const text = "größe = 1\r\n\r\nmain = simulate f\r\n"
      const made = toBlocks("p", encode(text), reader)
      expect([made.err, made.status]).toEqual(["", 0])
      const parsed = parseProject(made.out)
      const plain = parseProject(toBlocks("p", utf8(text), reader).out)
      if (!parsed.ok || !plain.ok) throw new Error("not a project")
      expect(parsed.project.haskell).toBe(`\uFEFF${text}`)
      expect(parsed.project.layout).toEqual(plain.project.layout)
      expect(commands("to-haskell", ["p.rosy"], () => encode(made.out))).toEqual({
        out: `\uFEFF${text}`,
        err: "",
        status: 0,
      })
    },
  )
})
