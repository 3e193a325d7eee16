/// Haskell that GHC reads and the grammar does not: blocks show it as far as they can, and call none of it wrong.

import {beforeAll, expect, test} from "vitest"
import type {Cause, Reader} from "../../src/reader/index.ts"
import {causeOf} from "../../src/reader/index.ts"
import {testReader} from "./open.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

const th = "{-# LANGUAGE TemplateHaskell, QuasiQuotes #-}\n"
const arrows = "{-# LANGUAGE Arrows #-}\n"
const programs: readonly (readonly [what: string, text: string, kept: Cause | "blocks"])[] = [
  ["an index in a guard", "go i j\n  | s!i == p!j = 1\n  | otherwise = 2\n", "blocks"],
  ["an index of an index", "f x y z = x!y!(z!0)\n", "blocks"],
  ["no alternatives", "f x = case x of {}\n", "blocks"],
  ["no alternatives, in lines", "f x = g (case x of\n  {\n  })\n", "blocks"],
  ["a function without alternatives", "f = \\case {}\n", "blocks"],
  ["an arrow", `${arrows}f = proc x -> g -< x\n`, "arrow"],
  ["an arrow of a pattern", `${arrows}f :: A\nf = proc (a, _) -> g -<< a + 1\n`, "arrow"],
  [
    "an arrow of steps",
    `${arrows}f = proc x -> do\n  y <- g -< x\n  rec z <- h -< (y, z)\n  returnA -< z\n`,
    "arrow",
  ],
  ["an arrow of conditions", `${arrows}f = proc x -> if x then g -< x else h -< 1\n`, "arrow"],
  [
    "an arrow of alternatives",
    `${arrows}f = proc x -> case x of\n  Just y -> g -< y\n  Nothing -> h -< 1\n`,
    "arrow",
  ],
  [
    "an arrow with an operator on commands",
    `${arrows}f g = proc x -> (| untilA (g -< x) (h -< 1) |)\n`,
    "arrow",
  ],
  ["fields of an operator", "data V = (:+) {re :: Int, im :: Int}\n", "data"],
  ["fields of an operator beside a name", "data V a = N | (:>>) { hd :: a, tl :: V a }\n", "data"],
  ["a splice without a sign", `${th}makeLenses ''Foo\n`, "template"],
  ["declarations of another language", `${th}[lq| type Nat = Int |]\n`, "template"],
]

test.each(programs)("%s is not called wrong", (_, text, kept) => {
  const found = reader.read(text).pieces.find(p => p.declaration !== undefined)
  expect(found?.broken).toBe(false)
  const declaration = found?.declaration
  expect(declaration?.kind === "raw-declaration" ? causeOf(declaration.reason) : "blocks").toBe(kept)
})

const broken: readonly (readonly [what: string, text: string])[] = [
  ["alternatives that are missing", "f x = case x of\n"],
  ["an equals sign behind no alternatives", "f x = case x of {} =\n"],
  ["an equals sign in an arrow", `${arrows}f = proc x -> (g -< x) = 1\n`],
  ["a bracket that fields of an operator lack", "data V = (:+) {re :: Int, im :: Int\n"],
  ["an expression at the margin of a plain program", "print 1\n"],
  ["a quotation at the margin of a plain program", "[lq| type Nat = Int |]\n"],
]

test.each(broken)("but %s: that is", (_, text) => {
  expect(reader.read(text).pieces.some(p => p.broken)).toBe(true)
})
