/// Inference does not contradict GHC: no problem where GHC compiles, and a problem of the stated kind where GHC refuses.

import {spawnSync} from "node:child_process"
import {mkdtempSync, rmSync, writeFileSync} from "node:fs"
import {tmpdir} from "node:os"
import {join} from "node:path"
import {beforeAll, describe, expect, test} from "vitest"
import type {Reader} from "../../src/reader/index.ts"
import {openView, workspaceOf} from "../../src/reader/index.ts"
import {inferWorkspace} from "../../src/workspace/inference/workspace_inference.ts"
import {run} from "../process.ts"
import {testReader} from "../reader/open.ts"
import {accepted, refused} from "./agreement.ts"

const ghc = spawnSync("ghc", ["--numeric-version"], {encoding: "utf8"})
const missing = ghc.error !== undefined || ghc.status !== 0
if (missing) console.warn("ghc is not installed: the agreement of inference with GHC is not tested.")
const flags = "--make -fno-code -v0 -w -fkeep-going -XDeriveTraversable".split(" ")

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

/// The kinds of the problems that inference reports for a program.
function problemsIn(text: string): string[] {
  const {inference} = inferWorkspace(workspaceOf(openView(reader, text)))
  return inference.problems.map(p => p.kind)
}

describe("no problem is reported for", () => {
  test.each(Object.entries(accepted))("%s", (_, text) => {
    expect(problemsIn(text)).toEqual([])
  })
})

describe("a problem is reported for", () => {
  test.each(Object.entries(refused).map(([name, [kind, text]]) => [name, kind, text]))(
    "%s",
    (_, kind, text) => {
      expect(problemsIn(text)).toContain(kind)
    },
  )
})

test("a type with the name of a Prelude type is no problem in a program that qualifies it with its own module", () => {
  const text = `module Own.Types where
data Maybe a = Nothing | Just a
instance Functor Own.Types.Maybe where
  fmap _ Own.Types.Nothing = Own.Types.Nothing
  fmap f (Own.Types.Just a) = Own.Types.Just (f a)
`
  expect(problemsIn(text)).toEqual([])
  expect(problemsIn(text.replaceAll("Own.Types.", ""))).toContain("taken")
})

test.skipIf(missing)("GHC compiles the accepted programs and refuses the others", async () => {
  const programs = [
    ...Object.entries(accepted),
    ...Object.entries(refused).map(([name, [, text]]) => [name, text] as const),
  ]
  const folder = mkdtempSync(join(tmpdir(), "agreement-"))
  try {
    for (const [i, [, text]] of programs.entries()) {
      const pragma = /^(?:\{-#.*#-\}\n)*/.exec(text)?.[0] ?? ""
      const body = text.slice(pragma.length)
      writeFileSync(join(folder, `P${i}.hs`), `${pragma}module P${i} where\n${body}\n`)
    }
    const {stdout, stderr} = await run("ghc", [...flags, ...programs.map((_, i) => `P${i}.hs`)], folder)
    const complaints = `${stdout}\n${stderr}`
    const compiled = programs.filter((_, i) => !new RegExp(`^P${i}\\.hs:`, "m").test(complaints))
    expect(
      compiled.map(([name]) => name),
      complaints,
    ).toEqual(Object.keys(accepted))
  } finally {
    rmSync(folder, {recursive: true})
  }
})
