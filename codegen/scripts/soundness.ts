/// The long run of the soundness test: `npm run soundness -w codegen -- 20000`. Prints what it found.

import {blockTypes} from "../src/blocks/block_registry.ts"
import {completeness, sorts} from "../test/completeness.ts"
import {keep} from "../test/shrink.ts"
import {sizesOf, soundness} from "../test/soundness.ts"
import {packageDatabase} from "./ghc.ts"

const [count = "2000", from = "100000"] = process.argv.slice(2).filter(a => /^\d+$/.test(a))
const database = packageDatabase()
const say = (line: string) => process.stdout.write(`${line}\n`)
const percent = (part: number, all: number) => `${((100 * part) / Math.max(1, all)).toFixed(3)} %`
const kinds = blockTypes.map(b => b.type).filter(t => !t.startsWith("raw_"))
const missing = (found: {has(kind: string): boolean}) => {
  const without = kinds.filter(k => !found.has(k))
  return `${kinds.length - without.length} of ${kinds.length} kinds of block${without.length === 0 ? "" : `, not ${without.join(", ")}`}`
}

if (database === undefined) {
  process.stderr.write("Build the library first: cabal build lib:rosy\n")
  process.exitCode = 1
} else {
  const found = await soundness(database, Number(from), Number(count))
  for (const r of found.refused) say(await keep(database, r))
  say(`blocks a program: ${sizesOf(found)}`)
  say(
    `kinds of block: ${[...found.kinds]
      .sort((a, b) => b[1] - a[1])
      .map(([kind, n]) => `${kind} ${n}`)
      .join(", ")}`,
  )
  say(missing(found.kinds))
  say(
    `${found.programs} programs generated, ${found.whole} finished ones with ${found.blocks} blocks, ${found.refused.length} refused by GHC`,
  )
  say(`soundness: ${percent(found.whole - found.refused.length, found.whole)} of finished programs compile`)
  const moves = await completeness(database, Number(from), Math.ceil(Number(count) / 20))
  for (const n of [...moves.needless, ...moves.refused]) say(n)
  say(`moved: ${missing(moves.moved)}; into: ${missing(moves.tried)}`)
  say(`${moves.unusable} refused moves make a function that nothing can call`)
  for (const sort of sorts) say(`${sort}: ${moves.moves[sort]} random moves, ${moves.allowed[sort]} allowed`)
  const allowed = sorts.reduce((n, sort) => n + moves.allowed[sort], 0)
  say(`${moves.needless.length} refused needlessly, ${moves.refused.length} allowed that GHC refuses`)
  say(
    `completeness: ${percent(allowed, allowed + moves.needless.length)} of the moves whose program GHC takes are allowed`,
  )
  process.exitCode = found.refused.length + moves.needless.length + moves.refused.length === 0 ? 0 : 1
}
