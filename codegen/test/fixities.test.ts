/// The table of fixities against GHC's interpreter; the table was made from GHC's interface files.

import {expect, test} from "vitest"
import {moduleFixities} from "../src/haskell/module_fixities.generated.ts"
import {run} from "./process.ts"

/// One module of each group; the others of a group export the same operators.
const operators = moduleFixities.flatMap(({modules, fixities}) =>
  [...fixities.matchAll(/(infix[lr]? \d) ([^\s,]+|,)/g)].map(([, fixity = "", name = ""]) => {
    const qualified = `${modules.split(" ")[0]}.${name}`
    return {fixity, qualified, asked: /^[\p{L}_]/u.test(name) ? qualified : `(${qualified})`}
  }),
)

test("operators have the fixities that GHC tells of them", async () => {
  const questions = operators.flatMap(({asked}, i) => ["-e", `:!echo @${i}`, "-e", `:info ${asked}`])
  const {stdout} = await run("ghc", ["-ignore-dot-ghci", ...questions])
  const answers = stdout.split(/^@\d+$/m).slice(1)
  const told = answers.map((answer, i) => {
    const fixity = /^(infix[lr]? \d) /m.exec(answer)?.[1]
    return `${operators[i]?.qualified}: ${fixity}`
  })
  expect(operators.length).toBeGreaterThan(200)
  expect(told).toEqual(operators.map(({qualified, fixity}) => `${qualified}: ${fixity}`))
}, 240_000)
