/// Everything that fits compiles: random programs, built only by moves that the checker allows, are accepted by GHC. And what is
/// refused, GHC refuses too.
///
/// Needs the built library; `./rosy test` builds it first. A longer run: `npm run soundness -w codegen -- 20000`.

import {readdirSync, readFileSync} from "node:fs"
import {describe, expect, test} from "vitest"
import {packageDatabase} from "../scripts/ghc.ts"
import {blockTypes} from "../src/blocks/block_registry.ts"
import {openView, workspaceOf} from "../src/reader/index.ts"
import {inferWorkspace, problemsOf} from "../src/workspace/inference/workspace_inference.ts"
import {completeness} from "./completeness.ts"
import {cases as extent, isNightly, rerun, seed} from "./extent.ts"
import {compileAll} from "./ghc.ts"
import {testReader} from "./reader/open.ts"
import {cases, keep} from "./shrink.ts"
import {candidate, sizesOf, soundness} from "./soundness.ts"

const database = packageDatabase()

/// Of what a raw block holds GHC alone is the judge.
const kinds = blockTypes.map(b => b.type).filter(t => !t.startsWith("raw_"))

const sum = (of: {readonly [sort: string]: number}) => Object.values(of).reduce((a, b) => a + b, 0)

test.skipIf(database === undefined)("what fits compiles", async () => {
  const wanted = extent(50)
  const found = await soundness(database ?? "", seed, wanted)
  console.log(
    `soundness: ${found.whole} programs of ${found.blocks} blocks, ${found.refused.length} refused by GHC. Blocks a program: ${sizesOf(found)}`,
  )
  expect(await Promise.all(found.refused.map(r => keep(database ?? "", r))), rerun).toEqual([])
  expect(found.whole).toBe(wanted)
  if (!isNightly) return
  // Nearly all programs must get finished, be of all sizes and have every kind of block, or the test would show little.
  expect(found.programs).toBeLessThan(550)
  expect(found.sizes.filter(n => n === 0)).toEqual([])
  expect(kinds.filter(k => !found.kinds.has(k))).toEqual([])
})

test.skipIf(database === undefined)("what does not fit does not compile", async () => {
  const {moves, allowed, refused, needless, moved, tried} = await completeness(
    database ?? "",
    seed,
    extent(10),
  )
  console.log(
    `completeness: ${sum(moves)} random moves, ${sum(allowed)} allowed, ${needless.length} refused and GHC takes them`,
  )
  expect(needless, rerun).toEqual([])
  expect(refused, rerun).toEqual([])
  if (!isNightly) return
  expect(sum(moves) - sum(allowed)).toBeGreaterThan(200)
  expect(Math.min(...Object.values(allowed))).toBeGreaterThan(5)
  expect(kinds.filter(k => !moved.has(k)).length).toBeLessThan(15)
  expect(kinds.filter(k => !tried.has(k)).length).toBeLessThan(20)
})

describe("programs that inference once accepted and GHC refused", async () => {
  const reader = await testReader()
  const names = readdirSync(cases)
  const workspaces = names.map(n => workspaceOf(openView(reader, readFileSync(new URL(n, cases), "utf8"))))
  const whole = workspaces.map(w => problemsOf(inferWorkspace(w)).every(p => p.severity !== "error"))
  test.skipIf(database === undefined)("compile now, or are refused", async () => {
    const complaints = await compileAll(
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
