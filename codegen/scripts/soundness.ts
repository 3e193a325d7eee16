/// The long run of the soundness test: `npm run soundness -w codegen -- COUNT [FROM]`.

import {completeness, soundness} from "../test/soundness.ts"
import {packageDatabase} from "./ghc.ts"

const [count = "2000", from = "100000"] = process.argv.slice(2).filter(a => /^\d+$/.test(a))
const database = packageDatabase()
if (database === undefined) {
  process.stderr.write("Build the library first: cabal build lib:rosy\n")
  process.exitCode = 1
} else {
  const {programs, whole, blocks, refused} = soundness(database, Number(from), Number(count))
  for (const r of refused) process.stdout.write(`${r}\n`)
  process.stdout.write(
    `${programs} programs, ${blocks} blocks, ${whole} finished, ${refused.length} refused by GHC\n`,
  )
  const {refusals, needless} = completeness(database, Number(from), Math.ceil(Number(count) / 10))
  for (const n of needless) process.stdout.write(`${n}\n`)
  process.stdout.write(`${refusals} refusals by the checker, ${needless.length} of programs that GHC takes\n`)
  process.exitCode = refused.length === 0 ? 0 : 1
}
