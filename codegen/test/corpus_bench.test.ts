/// The measurement of foreign Haskell (`./rosy bench corpus DIR`), on programs of a few lines.

import {beforeAll, expect, test} from "vitest"
import type {ForeignProgram} from "../bench/corpus_ghc.ts"
import {unreadableByGhc, verdictsOfGhc} from "../bench/corpus_ghc.ts"
import {measureProgram, wordsIn} from "../bench/corpus_measurement.ts"
import {reportOf, summaryOf} from "../bench/corpus_report.ts"
import type {Reader} from "../src/reader/index.ts"
import {testReader} from "./reader/open.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

const programs: readonly ForeignProgram[] = [
  {
    name: "Double.hs",
    text: "module Double (twice) where\n\n-- twice\ntwice :: Int -> Int\ntwice n = n + n\n",
  },
  {name: "Family.hs", text: "{-# LANGUAGE TypeFamilies #-}\ntype family Item a\none = 1\n"},
  {name: "Wrong.hs", text: "f :: Int\nf = True\n"},
  {name: "Unfinished.hs", text: "f = (1 +\n"},
  {name: "Elsewhere.hs", text: "import Not.Installed\nf = g 1\n"},
  {name: "Running.hs", text: "{-# LANGUAGE TemplateHaskell #-}\nf = $(undefined)\n"},
]

const measured = () => {
  let now = 0
  return programs.map(({name, text}) => measureProgram(reader, name, text, () => now++))
}

test("words are tokens without comments and pragmas", () => {
  expect(wordsIn('f x = x + 1 -- one\n{-# INLINE f #-} "two words"')).toBe(7)
})

test("what stays text is counted by cause, and files that are not Haskell do not count for the share", () => {
  const summary = summaryOf(measured(), undefined, new Set(["Unfinished.hs"]))
  expect(summary.lossy).toEqual([])
  expect(summary.unreadable).toEqual(["Unfinished.hs"])
  expect(summary.causes.find(c => c.cause === "family")).toMatchObject({times: 1, words: 4})
  expect(summary.causes.map(c => c.cause)).not.toContain("broken")
  expect(reportOf(measured(), summary, false).join("\n")).toContain("lossless: 6 of 6")
})

test("a problem in a program that GHC accepts is a false alarm", () => {
  const accepted = new Map([["Wrong.hs", {complaint: ""}]])
  const {falseAlarms, missed} = summaryOf(measured(), accepted)
  expect(falseAlarms.map(a => a.program)).toEqual(["Wrong.hs"])
  expect(missed).toEqual([])
  const refused = new Map([["Double.hs", {complaint: "P1.hs:2:8: error:\n    Not in scope: ‘x’\n"}]])
  const missing = [{program: "Double.hs", complaint: "Not in scope: ‘x’"}]
  expect(summaryOf(measured(), refused)).toMatchObject({
    falseAlarms: [],
    missed: missing,
    accepted: 0,
    refused: 1,
  })
})

test("a broken definition is told, so its program is none that GHC refuses in silence", () => {
  const refused = new Map([["Unfinished.hs", {complaint: "P0.hs:1:7: error: parse error"}]])
  expect(summaryOf(measured(), refused)).toMatchObject({missed: [], refused: 1})
})

test("a program that imports a file of its own project is not judged by GHC, and one that names its own module is", async () => {
  const verdicts = await verdictsOfGhc([
    {name: "one/app/Main.hs", text: "import Data.List\nmain = print (total [1])\n"},
    {
      name: "one/src/Data/List.hs",
      text: "module Data.List where\ntotal = Data.List.add [1]\nadd ns = sum ns\n",
    },
    {
      name: "two/Main.hs",
      text: "#!/usr/bin/env runghc\nimport Data.List\nmain = print (Main.total [1])\ntotal ns = sum ns\n",
    },
  ])
  if (verdicts === undefined) return
  expect([...verdicts]).toEqual([
    ["one/src/Data/List.hs", {complaint: ""}],
    ["two/Main.hs", {complaint: ""}],
  ])
})

test("GHC is asked about programs whose imports are installed and that run no code", async () => {
  const verdicts = await verdictsOfGhc(programs)
  if (verdicts === undefined) return
  expect([...verdicts].map(([name, {complaint}]) => [name, complaint === ""])).toEqual(
    expect.arrayContaining([
      ["Double.hs", true],
      ["Family.hs", true],
      ["Wrong.hs", false],
      ["Unfinished.hs", false],
    ]),
  )
  expect(verdicts.size).toBe(4)
  expect([...(await unreadableByGhc(programs))]).toEqual(["Unfinished.hs"])
})

test("a program is accepted only when GHC has nothing to say once the wrong ones are gone", async () => {
  const texts = [
    "main = print missing\n",
    "import Data.List (noSuchName)\nmain = print 1\n",
    'import Data.Char (toUpper)\nmain = putStrLn (map toUpper 1)\nprogram = drawingOf (lettering "a")\n',
    "{- no module header -}\nprogram = drawingOf(blank)\n",
    "f = 1 +\n",
    "{-# LANGUAGE NoSuchExtension #-}\nmain = print 1\n",
    "main = print 1\n",
  ]
  const verdicts = await verdictsOfGhc(texts.map((text, i) => ({name: `${i}.hs`, text})))
  if (verdicts === undefined) return
  expect([...verdicts].filter(([, {complaint}]) => complaint === "").map(([name]) => name)).toEqual(["6.hs"])
  expect(verdicts.size).toBe(texts.length)
})
