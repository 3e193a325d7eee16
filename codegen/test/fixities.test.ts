/// The table of fixities against GHC's interpreter; the table was made from GHC's interface files.

import {expect, test} from "vitest"
import {moduleFixities} from "../src/haskell/module_fixities.generated.ts"
import {run} from "./process.ts"

/// One module of each group; the others of a group export the same operators.
const operators = moduleFixities.flatMap(({modules, fixities}) =>
  [...fixities.matchAll(/(infix[lr]? \d) ([^\s,]+|,)/g)].map(([, fixity = "", name = ""]) => {
    const qualified = `${modules.split(" ")[0]}.${name}`
    return {fixity, name, asked: /^[\p{L}_]/u.test(name) ? qualified : `(${qualified})`}
  }),
)

test("operators have the fixities that GHC tells of them", async () => {
  const {stdout} = await run("ghc", [
    "-ignore-dot-ghci",
    "-e",
    `:info ${operators.map(o => o.asked).join(" ")}`,
  ])
  // A name of letters stands in backquotes, and the package and module that define it before the name.
  const answers = [...stdout.matchAll(/^(infix[lr]? \d) `?(?:[a-z][\w.-]*:)?(?:[A-Z][\w']*\.)*(\S+?)`?$/gm)]
  expect(operators.length).toBeGreaterThan(200)
  expect(answers.map(([, fixity, name]) => `${fixity} ${name}`)).toEqual(
    operators.map(({fixity, name}) => `${fixity} ${name}`),
  )
}, 600_000)
