/// Reading after an edit: only the definitions around it are looked at, and the pieces are those of a text that was never read before.

import fc from "fast-check"
import {beforeAll, expect, onTestFinished, test, vi} from "vitest"
import type {Module, Reader} from "../../src/reader/index.ts"
import {breathe} from "../process.ts"
import {mutate, mutations, rareMutations} from "./mutations.ts"
import {corpus, testReader} from "./open.ts"

// More to look for what was never seen: `RUNS=20000 npx vitest run test/reader/incremental_reading.test.ts`.
const runs = Number(process.env.RUNS ?? 60)
const seeded = process.env.RUNS === undefined ? {seed: 1} : {}

let reader: Reader
/// Forgets what it has read.
let other: Reader
beforeAll(async () => {
  reader = await testReader()
  other = await testReader()
})

function readAfresh(text: string): Module {
  other.read("")
  return other.read(text)
}

function shape({text, pieces, fixities}: Module): unknown {
  return {
    text,
    fixities: [...fixities],
    pieces: pieces.map(({spans, ...piece}) => ({...piece, spans: [...spans.values()]})),
  }
}

function expectAsAfresh(text: string): void {
  const module = reader.read(text)
  expect(shape(module)).toEqual(shape(readAfresh(text)))
  const made = module.pieces.flatMap(piece => piece.declaration ?? [])
  expect(new Set(made).size).toBe(made.length)
}

test("after any walk of small changes the pieces are those of the text read afresh", async () => {
  await fc.assert(
    fc.asyncProperty(
      fc.constantFrom(...corpus),
      fc.array(fc.oneof(mutations, rareMutations), {minLength: 1, maxLength: 6}),
      async ({text}, steps) => {
        await breathe()
        reader.read(text)
        let now = text
        for (const changes of steps) {
          const before = now
          now = mutate(now, changes)
          expectAsAfresh(now)
          // Back and forth, as an edit of the blocks is tried.
          if (changes.length % 2 === 0) {
            expectAsAfresh(before)
            expectAsAfresh(now)
          }
        }
      },
    ),
    {numRuns: runs, ...seeded},
  )
}, 1_200_000)

test.each([
  ["a comment that closes one far above", "a = 1 {-\n\nb = 2\n\nc = 3\n\nd = 4\n", "d = 4", "d = 4 -}"],
  ["one that opens above others", "a = 1\n\nb = 2\n\nc = 3 -}\n\nd = 4\n", "a = 1", "a = 1 {-"],
  ["a fixity", "a = 1 + 2 * 3\n\nb = 2\n\nc = 3\n\nd = 4\n", "d = 4", "infixl 5 *\nd = 4"],
  ["an operator that is defined anew", "a = 1 + 2 * 3\n\nb = 2\n\nc = 3\n\nx / y = 4\n", "x / y", "x * y"],
  ["an equation that joins the one below", "a = 1\n\nb = 2\n\nc = 3\n\nd 0 = 1\n", "c = 3", "d 1 = 3"],
  ["an equation that leaves the one below", "a = 1\n\nb = 2\n\nd 1 = 3\n\nd 0 = 1\n", "d 1", "c"],
  ["a definition that becomes part of the one above", "a = 1\n\nb = 2\n\nc = 3\n\nd = 4\n", "c =", " c ="],
  ["another margin", "  a = 1\n\n  b = 2\n\n  c = 3\n", "  a", "    a"],
  ["a margin less", "  a = 1\n\n  b = 2\n\n  c = 3\n", "  c", "c"],
  ["the head of a module", "a = 1\n\nb = 2\n\nc = 3\n", "a = 1", "module A where\na = 1"],
  ["an import below", "a = 1\n\nb = 2\n\nc = 3\n\nd = 4\n", "c = 3", "import Data.Char\nc = 3"],
  ["a string gap over definitions", 'a = "1\n\nb = 2\n\n\\x"\n\nc = 3\n', "b = 2\n", "\\\n"],
  ["a comment above that leaves", "a = 1\n\n-- it\nb = 2\n\nc = 3\n", "-- it\n", "-- it\n\n"],
  ["equal definitions", "a = 1\n\nb = 2\n\nc = 3\n\nd = 4\n", "c = 3", "b = 2"],
  ["all that there is", "a = 1\n\nb = 2\n\nc = 3\n", "a = 1\n\nb = 2\n\nc = 3\n", ""],
])("%s is seen wherever it has an effect", (_, before, from, to) => {
  const after = before.replace(from, to)
  expect(after).not.toBe(before)
  reader.read(before)
  expectAsAfresh(after)
  expectAsAfresh(before)
})

test("a number in a long program costs the definitions around it, not the program", async () => {
  const lexed = {characters: 0}
  // Modules of their own: those that other files share have been loaded with the real lexer.
  vi.resetModules()
  vi.doMock("../../src/source/top_level_items.ts", async original => {
    const real = await original<typeof import("../../src/source/top_level_items.ts")>()
    const lex: typeof real.lex = (text, margin) => {
      lexed.characters += text.length
      return real.lex(text, margin)
    }
    return {...real, lex}
  })
  onTestFinished(() => {
    vi.doUnmock("../../src/source/top_level_items.ts")
    vi.resetModules()
  })
  const counted = await (await import("./open.ts")).testReader()
  const one = (i: number) =>
    `-- number ${i}\nmove${i} :: Double -> Double\nmove${i} x\n  | x > 0.${i} = x\n  | otherwise = 1\n\n`
  const text = `import Rosy\n\n${Array.from({length: 200}, (_, i) => one(i)).join("")}main = print move0\n`
  for (const n of [0, 100, 199]) {
    const before = counted.read(text)
    const after = text.replace(`x > 0.${n} `, "x > 77 ")
    lexed.characters = 0
    const module = counted.read(after)
    expect(lexed.characters).toBeGreaterThan(0)
    expect(lexed.characters).toBeLessThan(600)
    expect(shape(module)).toEqual(shape(readAfresh(after)))
    const kept = module.pieces.filter((piece, i) => piece.declaration === before.pieces[i]?.declaration)
    expect(kept.length).toBe(before.pieces.length - 1)
  }
})
