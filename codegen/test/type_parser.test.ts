/// Very large types: reading them needs a bounded stack, and inference leaves them to GHC without an error of its own.

import {expect, test} from "vitest"
import {infer} from "../src/index.ts"
import {openView, workspaceOf} from "../src/reader/index.ts"
import {parseSignature, parseType} from "../src/types/syntax/type_parser.ts"
import {testReader} from "./reader/open.ts"

const reader = await testReader()
const nested = (levels: number) => `${"[".repeat(levels)}A${"]".repeat(levels)}`
const arrows = (levels: number) => `${"a -> ".repeat(levels)}a`
/// Each function applies the one before it twice.
const doubled = (n: number) => Array.from({length: n}, (_, i) => `f${i + 1} x = f${i} (f${i} x)\n\n`).join("")
const synonyms = (n: number) =>
  Array.from({length: n}, (_, i) => `type T${i} = (T${i + 1}, T${i + 1})\n\n`).join("") +
  `type T${n} = Int\n\n`
const steps = (n: number) => Array.from({length: n}, (_, i) => `      a${i + 1} = (a${i}, a${i})\n`).join("")

test.each([
  ["100 brackets", nested(100)],
  ["400 arguments", arrows(400)],
])("a type with %s is read", (_, text) => expect(parseType(text)).toBeDefined())

test.each([
  ["100,000 brackets", nested(100_000)],
  ["100,000 open brackets", "[".repeat(100_000)],
  ["100,000 parentheses", "(".repeat(100_000)],
  ["100,000 arguments", arrows(100_000)],
])("a type with %s is unknown", (_, text) => {
  expect(parseType(text)).toBeUndefined()
  expect(parseSignature(text)).toBeUndefined()
})

test.each([
  ["signature of 10,000 arguments", `f :: ${arrows(10_000)}\nf = _\n\nmain = simulate f\n`],
  ["signature of 500 nested brackets", `f :: ${nested(501)}\nf = _\n`],
  ["function of 10,000 parameters", `f ${"a ".repeat(10_000)}= 1\n\nmain = simulate f\n`],
  ["argument list of 10,000", `f = g ${"1 ".repeat(10_000)}\n\ng = f\n`],
  ["lambda of 10,000 parameters", `f = \\${"a ".repeat(10_000)}-> 1\n`],
  ["constructor of 10,000 fields", `data T = T ${"Int ".repeat(10_000)}\n\nf = T 1\n`],
  ["pattern of 10,000 fields", `data T = T ${"Int ".repeat(10_000)}\n\nf (T ${"a ".repeat(10_000)}) = 1\n`],
  ["type of 2^64 parts", `f0 x = (x, x)\n\n${doubled(6)}`],
  ["type of 2^64 levels", `f0 x = [x]\n\n${doubled(64)}`],
  ["type of 2^64 parts by steps", `f = do\n  let a0 = (1, 1)\n${steps(64)}  return a64\n`],
  ["synonym of 2^64 parts", `${synonyms(64)}f :: T0\nf = _\n\ng :: T64 -> T0\ng x = x\n`],
  ["field of a synonym of 2^64 parts", `${synonyms(64)}data D = D T0 deriving (Eq, Show)\n\nf (D x) = x\n`],
  [
    "method whose type has 2^64 parts",
    `f0 x = (x, x)\n\n${doubled(5)}instance Show A where\n  show a = show (f5 (f5 a))\n`,
  ],
  ["tuple of 10,000", `f = (${"1, ".repeat(10_000)}1)\n`],
])("a program with a %s is shown without a type error", (_, text) => {
  const problems = infer(workspaceOf(openView(reader, text))).problems
  expect(problems.filter(({kind}) => kind === "type" || kind === "bad-signature")).toEqual([])
})
