/// How much of the corpus becomes native blocks: printed, with what does not, by construct.

import {beforeAll, expect, test} from "vitest"
import {everyNode} from "../../src/model/child_nodes.ts"
import type {Reader} from "../../src/reader/index.ts"
import {causeOf, openView, type View} from "../../src/reader/index.ts"
import type {SavedBlock} from "../../src/serialized_blocks.ts"
import {corpus, testReader} from "./open.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

/// Each program is read once for all tables that count it.
const views = new Map<string, View>()
function viewOf(text: string): View {
  const view = views.get(text) ?? openView(reader, text)
  views.set(text, view)
  return view
}

/// Words, literals and operators: a measure of how many expressions a piece of text holds.
function stringsIn(text: string): number {
  return (text.match(/"(?:[^"\\]|\\.)*"|[\p{L}_][\p{L}\p{N}_'.]*|\d[\w.]*|[!#$%&*+/<>?^|~:.-]+/gu) ?? [])
    .length
}

function rawBlocks(block: SavedBlock): SavedBlock[] {
  const below = [...Object.values(block.inputs ?? {}).map(i => i.block), block.next?.block]
  return [
    ...(block.type.startsWith("raw_") ? [block] : []),
    ...below.flatMap(b => (b === undefined ? [] : rawBlocks(b))),
  ]
}

const pieceOfExpression = new Set(
  "variable constructor-name number string character apply infix negate section lambda if branches case lambda-case let do tuple list range comprehension typed record update hole".split(
    " ",
  ),
)

/// Programs in the manner of experienced authors, `style-*.hs`, are there for what the reader might stumble over: half of them show
/// just what blocks leave out. They are counted apart, too.
test.each([
  ["programs as learners write them", corpus.filter(p => !p.name.startsWith("style-")), 0.97],
  ["programs in every style", corpus.filter(p => p.name.startsWith("style-")), 0.9],
  ["programs, all of the corpus", corpus, 0.97],
] as const)("the share of expressions that become native blocks: %s", (what, programs, least) => {
  let native = 0
  let kept = 0
  const byCause = new Map<string, {times: number; words: number}>()
  for (const program of programs) {
    const view = viewOf(program.text)
    for (const shown of view.declarations) {
      const d = view.module.pieces[shown.piece]?.declaration
      const inside = d === undefined ? 0 : [...everyNode(d)].filter(n => pieceOfExpression.has(n.kind)).length
      let lost = 0
      for (const raw of rawBlocks(shown.block)) {
        const cause = causeOf(String(raw.extraState?.reason)) ?? "unknown"
        // Instructions to the compiler and types hold no expressions.
        const words = [
          "directive",
          "fixity",
          "names",
          "lonely",
          "data",
          "strict",
          "deriving",
          "synonym",
        ].includes(cause)
          ? 0
          : stringsIn(String(raw.extraState?.text))
        const before = byCause.get(cause) ?? {times: 0, words: 0}
        byCause.set(cause, {times: before.times + 1, words: before.words + words})
        lost += words
      }
      kept += lost
      native += Math.max(0, shown.block.type === "raw_definition" ? 0 : inside - lost)
    }
  }
  const share = native / (native + kept)
  const table = [...byCause].sort((a, b) => b[1].words - a[1].words)
  console.log(
    [
      `${programs.length} ${what}: ${(100 * share).toFixed(1)} % of ${native + kept} expressions become native blocks. The rest, by construct:`,
      ...table.map(([cause, {times, words}]) => `  ${cause}: ${times} times, ${words} expressions`),
    ].join("\n"),
  )
  expect(share).toBeGreaterThan(least)
  expect(byCause.has("unknown")).toBe(false)
})
