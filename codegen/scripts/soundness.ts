/// The long run of the soundness test: `npm run soundness -w codegen -- 20000`. Prints what it found.

import {shrink} from "../test/shrink.ts"
import {completeness, soundness} from "../test/soundness.ts"
import {packageDatabase} from "./ghc.ts"

const [count = "2000", from = "100000"] = process.argv.slice(2).filter(a => /^\d+$/.test(a))
const database = packageDatabase()
const say = (line: string) => process.stdout.write(`${line}\n`)
const percent = (part: number, all: number) => `${((100 * part) / Math.max(1, all)).toFixed(3)} %`

if (database === undefined) {
  process.stderr.write("Build the library first: cabal build lib:rosy\n")
  process.exitCode = 1
} else {
  const {programs, whole, blocks, sizes, kinds, refused} = await soundness(
    database,
    Number(from),
    Number(count),
  )
  for (const r of refused) say(`seed ${r.seed}, shrunk:\n${shrink(database, r.workspace)}\n${r.complaint}`)
  say(
    `blocks a program: ${sizes.map((n, i) => `${i === 0 ? 5 : i * 10 + 1}-${i * 10 + 10}: ${n}`).join(", ")}`,
  )
  say(
    `kinds of block: ${[...kinds]
      .sort((a, b) => b[1] - a[1])
      .map(([kind, n]) => `${kind} ${n}`)
      .join(", ")}`,
  )
  say(`${programs} programs, ${whole} finished ones with ${blocks} blocks, ${refused.length} refused by GHC`)
  say(`soundness: ${percent(whole - refused.length, whole)} of finished programs compile`)
  const {moves, allowed, unusable, needless} = await completeness(
    database,
    Number(from),
    Math.ceil(Number(count) / 10),
  )
  for (const n of needless) say(n)
  say(`${unusable} refused moves make a function that nothing can call`)
  const right = allowed + needless.length
  say(
    `${moves} random moves: ${allowed} allowed, ${moves - allowed} refused, ${needless.length} of these needlessly`,
  )
  say(`completeness: ${percent(allowed, right)} of the moves whose program GHC takes are allowed`)
  process.exitCode = refused.length === 0 && needless.length === 0 ? 0 : 1
}
