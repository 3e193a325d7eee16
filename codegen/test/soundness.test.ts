/// Everything that fits compiles: random programs, built only by moves that the checker allows, are accepted by GHC. And what is
/// refused, GHC refuses too.
///
/// Needs the built library; `./rosy test` builds it first. A longer run: `npm run soundness -w codegen -- 20000`.

import {readdirSync, readFileSync} from "node:fs"
import {describe, expect, test} from "vitest"
import {packageDatabase} from "../scripts/ghc.ts"
import {openView, workspaceOf} from "../src/reader/index.ts"
import {problemsOf, solve} from "../src/workspace/infer.ts"
import {compileAll} from "./ghc.ts"
import {testReader} from "./reader/open.ts"
import {candidate, completeness, soundness} from "./soundness.ts"

const database = packageDatabase()

test.skipIf(database === undefined)("what fits compiles", {timeout: 300_000}, async () => {
  const {programs, whole, refused, kinds} = await soundness(database ?? "", 0, 500)
  expect(refused.map(r => `seed ${r.seed}\n${candidate("", r.workspace).text}\n${r.complaint}`)).toEqual([])
  expect(programs).toBe(500)
  // Nearly all programs must be finished ones, and of all sorts, or the test would show little.
  expect(whole).toBeGreaterThan(450)
  expect(kinds.size).toBeGreaterThan(40)
})

test.skipIf(database === undefined)("what does not fit does not compile", {timeout: 300_000}, async () => {
  const {moves, allowed, needless} = await completeness(database ?? "", 300, 100)
  expect(needless).toEqual([])
  expect(moves - allowed).toBeGreaterThan(100)
  expect(allowed).toBeGreaterThan(50)
})

describe("programs that inference once accepted and GHC refused", async () => {
  const reader = await testReader()
  const folder = new URL("cases/", import.meta.url)
  const names = readdirSync(folder)
  const workspaces = names.map(n => workspaceOf(openView(reader, readFileSync(new URL(n, folder), "utf8"))))
  const whole = workspaces.map(w => problemsOf(solve(w)).every(p => p.severity !== "error"))
  test.skipIf(database === undefined)("compile now, or are refused", {timeout: 60_000}, () => {
    const complaints = compileAll(
      database ?? "",
      workspaces.map((w, i) => candidate(`Case${i}`, w)),
    )
    names.forEach((name, i) => {
      expect(complaints.get(`Case${i}`) === undefined, `${name}: ${complaints.get(`Case${i}`)}`).toBe(
        whole[i],
      )
    })
  })
})
