/// The long run of the lint test: `npm run lint:programs -w codegen -- 2000`. Prints what hlint and `-Wall` say.

import {lint} from "../test/lint.ts"
import {packageDatabase} from "./ghc.ts"

const [count = "2000", from = "300000"] = process.argv.slice(2).filter(a => /^\d+$/.test(a))
const database = packageDatabase()
const say = (line: string) => process.stdout.write(`${line}\n`)

if (database === undefined) {
  process.stderr.write("Build the library first: cabal build lib:rosy\n")
  process.exitCode = 1
} else {
  const {programs, hints, warnings, content} = await lint(database, Number(from), Number(count))
  for (const said of [...hints, ...warnings]) say(said)
  const known = [...content].sort((a, b) => b[1] - a[1]).map(([hint, n]) => `${hint} ${n}`)
  say(`by rules that ask for another program: ${known.join(", ")}`)
  say(
    `${programs} programs: ${hints.length} hints and ${warnings.length} warnings about how they are written`,
  )
  process.exitCode = hints.length + warnings.length === 0 ? 0 : 1
}
