/// The reader and the printer agree: what one prints the other reads, node for node.

import fc from "fast-check"
import {beforeAll, describe, expect, test} from "vitest"
import {readTree} from "../../src/blocks/block_reader.ts"
import {Writer} from "../../src/blocks/block_writer.ts"
import {printProgram} from "../../src/haskell/printer.ts"
import type {Declaration, Program} from "../../src/model/syntax_tree.ts"
import type {Reader} from "../../src/reader/index.ts"
import {openView, workspaceOf} from "../../src/reader/index.ts"
import {hashTree} from "../../src/reader/view/tree_matching.ts"
import type {SavedBlock} from "../../src/serialized_blocks.ts"
import {breathe} from "../process.ts"
import {wellFormed} from "./models.ts"
import {corpus, testReader} from "./open.ts"

// More to look for what was never seen: `RUNS=5000 npx vitest run test/reader/agree.test.ts`.
const runs = Number(process.env.RUNS ?? 150)
// The same cases in every regular run; many are other ones each time.
const seeded = process.env.RUNS === undefined ? {seed: 1} : {}
const patience = 600_000

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

function readProgram(text: string): Program {
  const declarations = reader
    .read(text)
    .pieces.flatMap(p => (p.declaration === undefined ? [] : [p.declaration]))
  return {kind: "program", declarations}
}

/// Without what only says where a node comes from.
function plain(value: unknown): unknown {
  return JSON.parse(JSON.stringify(value, (key, v: unknown) => (key === "from" ? undefined : v)))
}

/// A tree of blocks without ids and places.
function bare(block: SavedBlock): unknown {
  return JSON.parse(
    JSON.stringify(block, (key, v: unknown) => (["id", "x", "y"].includes(key) ? undefined : v)),
  )
}

describe("printing and reading a program of the corpus gives the same tree", () => {
  test.each(corpus.map(p => [p.name, p.text]))("%s", (_, text) => {
    const once = readProgram(text)
    expect(plain(readProgram(printProgram(once).text))).toEqual(plain(once))
  })
})

test.each(["data T a = T ((a)) !((Maybe a))", "x = show @((Int)) 1"])(
  "a type in brackets within brackets is read without them: %s",
  text => {
    const once = readProgram(text)
    const printed = printProgram(once).text
    expect(printed).not.toContain("((")
    expect(plain(readProgram(printed))).toEqual(plain(once))
  },
)

test(
  "any program prints and reads back as it was",
  async () => {
    await fc.assert(
      fc.asyncProperty(wellFormed, async program => {
        await breathe()
        const {text} = printProgram(program)
        expect(plain(readProgram(text)), text).toEqual(plain(program))
      }),
      {numRuns: runs, ...seeded},
    )
  },
  patience,
)

test(
  "any blocks go to text and come back as they were, up to their ids",
  async () => {
    await fc.assert(
      fc.asyncProperty(wellFormed, async program => {
        await breathe()
        let n = 0
        const writer = new Writer(() => `b${n++}`)
        // Some trees have no blocks of their own; what they become has.
        const declarations = program.declarations.flatMap(
          (d): readonly Declaration[] => readTree(writer.declaration(d)).declarations,
        )
        const blocks = declarations.map(d => writer.declaration(d))
        const {text} = printProgram({kind: "program", declarations})
        const back = workspaceOf(openView(reader, text)).blocks.blocks
        if (back.map(b => hashTree(b, true)).join() !== blocks.map(b => hashTree(b, true)).join())
          expect(back.map(bare), text).toEqual(blocks.map(bare))
      }),
      {numRuns: runs, ...seeded},
    )
  },
  patience,
)

test("`f$x` applies an operator, with or without spaces", () => {
  for (const text of ["a = f$x\n", "a = f $x\n", "a = f $(x)\n"])
    expect(plain(readProgram(text)), text).toEqual(plain(readProgram("a = f $ x\n")))
  for (const text of ["a = f$(g 1)\n", "a = f $(g 1)\n"])
    expect(plain(readProgram(text)), text).toEqual(plain(readProgram("a = f $ g 1\n")))
})

test("a negative number with a type is a step or a condition like any other", () => {
  const typed = plain(readProgram("a = -1 :: Int\n"))
  const [
    {
      clauses: [
        {
          right: {body},
        },
      ],
    },
  ] = (typed as {declarations: [{clauses: [{right: {body: unknown}}]}]}).declarations
  for (const text of ["do\n  -1 :: Int", "do { - 1 :: Int }"])
    expect(plain(readProgram(`a = ${text}\n`)), text).toMatchObject({
      declarations: [
        {clauses: [{right: {body: {kind: "do", statements: [{kind: "statement", expr: body}]}}}]},
      ],
    })
  expect(reader.read("a | 1e-3 :: Double = 1\n").pieces.some(p => p.broken)).toBe(false)
  expect(plain(readProgram("a | -1 :: Int = 1\n"))).toMatchObject({
    declarations: [{clauses: [{right: {body: [{guards: [{kind: "statement", expr: body}]}]}}]}],
  })
})

test("a negative number stands before any operator, at the beginning of a condition or a step, and on a line of its own in brackets", () => {
  for (const text of [
    "a\n  | -1 `elem` x, -2 `mod` y = 1",
    "a\n  | -1 : x == y = 1",
    "a = do\n  -1 `on` x\n  y",
    "a = [x | -1.5 `on` x, y]",
    "a\n  | ( -1\n    , x\n    ) == y = 1",
  ]) {
    const [piece] = reader.read(`${text}\n`).pieces
    expect(piece?.broken, text).toBe(false)
    expect(JSON.stringify(piece?.declaration), text).toMatch(/"text":"-\d/)
  }
  // In patterns it stays one.
  for (const text of ["-1 `on` x = x\n", "a | -1 `On` x <- y = 1\n", "a | x, -1 :| x <- y = 1\n"])
    expect(JSON.stringify(plain(readProgram(text))), text).toContain('"number-pattern"')
})

test("what a block begins is in brackets before what follows on its last line", () => {
  for (const text of [
    "a = case (f $ \\case\n  x -> x) of\n  y -> y\n",
    "a = if (f $ \\case\n  x -> x) then 1 else 2\n",
  ]) {
    const once = readProgram(text)
    expect(plain(readProgram(printProgram(once).text))).toEqual(plain(once))
  }
})

test("a pattern that is kept as text keeps its lines", () => {
  for (const text of [
    "f (g -- why\n   -> Just x) = x\n",
    '"one\\\n  \\two" `f` (g ->\n  x) = x\n',
    "a = case x of\n  (g\n    -> y) -> y\n",
  ]) {
    const once = readProgram(text)
    expect(plain(readProgram(printProgram(once).text)), printProgram(once).text).toEqual(plain(once))
  }
  expect(reader.read("f (x y) = 1\n").pieces[0]?.broken).toBe(true)
})
