/// Types that double with each level of a short program: inference stays finite, leaves them to GHC, and says nothing wrong about the rest.

import {beforeAll, expect, test} from "vitest"
import type {Reader} from "../../src/reader/index.ts"
import {openView, workspaceOf} from "../../src/reader/index.ts"
import {infer} from "../../src/workspace/inference/workspace_inference.ts"
import {testReader} from "../reader/open.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

const around = (open: string, close: string, depth: number, inner: string) =>
  `${open.repeat(depth)}${inner}${close.repeat(depth)}`
const counted = (depth: number, part: (i: number) => string) => Array.from({length: depth}, (_, i) => part(i))

const doubling: readonly (readonly [what: string, text: (depth: number) => string])[] = [
  ["sections of sections", n => `f = ${around("(+ ", ")", n, "7")}`],
  ["sections of sections to the left", n => `f = ${around("(", " +)", n, "7")}`],
  ["sections around an empty socket", n => `f = ${around("(+ ", ")", n, "_")}`],
  ["a function of a function of itself", n => `f = ${around("(subtract ", ")", n, "7")}`],
  ["pairs by a local function", n => `f = let p x = (x, x) in ${around("p (", ")", n, "7")}`],
  ["pairs that are shown", n => `f = let p x = (x, x) in show (${around("p (", ")", n, "True")})`],
  ["pairs beside text for GHC", n => `f = let p x = (x, x) in asTypeOf ?q (${around("p (", ")", n, "7")})`],
  [
    "pairs that are compared",
    n => `f = let p x = (x, x) in ${around("p (", ")", n, "1")} == ${around("p (", ")", n, "2")}`,
  ],
  [
    "pairs of definitions",
    n => `f x0 = ${counted(n, i => `let x${i + 1} = (x${i}, x${i}) in `).join("")}x${n}`,
  ],
  [
    "pairs of steps",
    n => `f x0 = do\n${counted(n, i => `  x${i + 1} <- return (x${i}, x${i})\n`).join("")}  return x${n}`,
  ],
  [
    "pairs of local definitions",
    n => `f x0 = x${n}\n  where\n${counted(n, i => `    x${i + 1} = (x${i}, x${i})\n`).join("")}`,
  ],
  [
    "pairs of alternatives",
    n => `f x0 = ${counted(n, i => `case (x${i}, x${i}) of { x${i + 1} -> `).join("")}x${n}${" }".repeat(n)}`,
  ],
  [
    "two values whose types grow alike",
    n =>
      `f ${counted(n + 1, i => `a${i} b${i}`).join(" ")} = [${counted(n, i => `a${i} == (a${i + 1}, a${i + 1}), b${i} == (b${i + 1}, b${i + 1})`).join(", ")}, a0 == b0]`,
  ],
  [
    "pairs in a memory",
    n => `f (Memory x0) = ${counted(n, i => `let x${i + 1} = Memory (x${i}, x${i}) in `).join("")}x${n}`,
  ],
]

/// Of the two definitions; those inside them are left out.
const typesOf = (definitions: ReadonlyMap<string, {readonly name: string; readonly type: string}>) =>
  ["f", "g"].map(name => [...definitions.values()].find(d => d.name === name)?.type)

/// Behind the doubling definition, one whose problem must be found all the same.
const other = "\ng :: Bool\ng = 'c'\n"

test.each(doubling)("%s", (_, text) => {
  const {problems, definitions} = infer(workspaceOf(openView(reader, text(60) + other)))
  expect(problems.filter(p => p.kind === "type-mismatch")).toHaveLength(1)
  expect(typesOf(definitions)).toEqual(["?", "Bool"])
})

test.each(doubling.slice(0, 2))("few %s have a type", (_, text) => {
  const {definitions} = infer(workspaceOf(openView(reader, text(3) + other)))
  expect(typesOf(definitions)[0]).toBe(
    "((Double -> Double) -> Double -> Double) -> (Double -> Double) -> Double -> Double",
  )
})
