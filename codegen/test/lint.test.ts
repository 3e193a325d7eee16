/// Generated programs are written as hlint and `-Wall` would have them. A longer run: `npm run lint:programs -w codegen -- 2000`.

import {spawnSync} from "node:child_process"
import {expect, test} from "vitest"
import {packageDatabase} from "../scripts/ghc.ts"
import {cases, rerun, seed} from "./extent.ts"
import {lint} from "./lint.ts"

const database = packageDatabase()
const hlint = spawnSync("hlint", ["--version"]).status === 0

test.skipIf(database === undefined || !hlint)(
  "no hint and no warning about how a program is written",
  async () => {
    const {programs, hints, warnings} = await lint(database ?? "", seed, cases(4))
    expect(hints, rerun).toEqual([])
    expect(warnings, rerun).toEqual([])
    expect(programs).toBeGreaterThan(0.7 * cases(4))
  },
)
