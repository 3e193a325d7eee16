/// Reading Haskell: a whole file of 1,000 lines into blocks, and a keystroke in it, beside the parser alone.
///
/// In: the corpus, its programs put behind each other with names of their own. Out: a table of medians and 95th percentiles.

import {readFileSync} from "node:fs"
import {createRequire} from "node:module"
import {performance} from "node:perf_hooks"
import {Language, Parser} from "web-tree-sitter"
import type {Reader} from "../src/reader/index.ts"
import {openReader, openView, spansOf, syncBlocks, syncText, workspaceOf} from "../src/reader/index.ts"
import {corpus} from "../test/reader/open.ts"

const resolve = createRequire(import.meta.url).resolve
const runtime = readFileSync(resolve("web-tree-sitter/web-tree-sitter.wasm"))
const grammar = readFileSync(resolve("tree-sitter-haskell/tree-sitter-haskell.wasm"))

const lines = 1000
const repeats = process.env.ROSY_BENCH_SMALL === undefined ? 40 : 2

/// The corpus as one program, every name of a program marked with its number.
function longProgram(reader: Reader): string {
  let text = ""
  for (const [i, program] of corpus.entries()) {
    const pieces = reader.read(program.text).pieces.filter(p => p.kind === "declaration" && !p.broken)
    const names = new Set(pieces.flatMap(p => p.names).filter(n => /^\w/.test(n)))
    for (const p of pieces)
      text += p.slice
        .replaceAll("\r\n", "\n")
        .replace(/[\p{L}_][\p{L}\p{N}_']*/gu, w => (names.has(w) ? `${w}${i}` : w))
    text += "\n"
    if (text.split("\n").length > lines) break
  }
  return text.split("\n").slice(0, lines).join("\n")
}

function row(what: string, times: number[]): void {
  const sorted = [...times].sort((a, b) => a - b)
  const at = (share: number) =>
    (sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] ?? 0).toFixed(1)
  console.log(`${what.padEnd(58)} ${at(0.5).padStart(8)} ms ${at(0.95).padStart(8)} ms`)
}

function timed(go: () => void): number {
  const start = performance.now()
  go()
  return performance.now() - start
}

const reader = await openReader({runtime, grammar})
const text = longProgram(reader)
const parser = new Parser().setLanguage(await Language.load(grammar))
const fresh: Reader[] = []
for (let i = 0; i < repeats; i++) fresh.push(await openReader({runtime, grammar}))

console.log(
  `${text.split("\n").length} lines, ${text.length} characters`.padEnd(58),
  "  median".padStart(11),
  "p95".padStart(11),
)
row(
  "the parser alone, the whole file",
  fresh.map(() => timed(() => parser.parse(text)?.delete())),
)
row(
  "text to program model, the whole file",
  fresh.map(r => timed(() => r.read(text))),
)
row(
  "text to blocks, the whole file, model known",
  fresh.map(r => timed(() => openView(r, text))),
)
const again = await Promise.all(fresh.map(() => openReader({runtime, grammar})))
row(
  "text to blocks, the whole file, from nothing",
  again.map(r => timed(() => openView(r, text))),
)

let view = openView(reader, text)
const strokes: number[] = []
const places: number[] = []
for (let i = 0; i < repeats * 3; i++) {
  // A digit typed behind a number, and taken away again.
  const numbers = [...view.text.matchAll(/\d\b/g)]
  const at = (numbers[(i * 37) % numbers.length]?.index ?? 0) + 1
  const typed = `${view.text.slice(0, at)}7${view.text.slice(at)}`
  const before = view.text
  strokes.push(
    timed(() => {
      view = syncText(reader, view, typed)
    }),
  )
  places.push(timed(() => spansOf(view)))
  strokes.push(
    timed(() => {
      view = syncText(reader, view, before)
    }),
  )
}
row("a keystroke: text to blocks", strokes)
row("the places of all blocks in the text", places)

const edits: number[] = []
for (let i = 0; i < repeats; i++) {
  const workspace = workspaceOf(view)
  const blocks = [...workspace.blocks.blocks]
  const at = (i * 7) % blocks.length
  // One block is another; the rest are the very same values, as the page keeps them.
  const block = structuredClone(blocks[at])
  if (block === undefined) continue
  block.icons = {comment: {text: `note ${i}`}}
  blocks[at] = block
  edits.push(
    timed(() => {
      view = syncBlocks(reader, view, {...workspace, blocks: {...workspace.blocks, blocks}})
    }),
  )
}
row("an edit of a block: blocks to text", edits)
