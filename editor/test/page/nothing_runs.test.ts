/// What the page says of a program in which nothing is simulated, and the fix.

import {readFileSync} from "node:fs"
import {createRequire} from "node:module"
import {openReader, type Reader} from "@rosy/codegen/reader"
import {beforeAll, expect, it} from "vitest"
import {readHaskell} from "../../src/controller/document/document_conversion.ts"
import {nothingRuns} from "../../src/page/nothing_runs.ts"
import {fixChanges} from "../../src/program/program.ts"
import {applyChanges} from "../../src/program/text_changes.ts"

const {resolve} = createRequire(import.meta.url)
let reader: Reader
beforeAll(async () => {
  reader = await openReader({
    runtime: readFileSync(resolve("web-tree-sitter/web-tree-sitter.wasm")),
    grammar: readFileSync(resolve("tree-sitter-haskell/tree-sitter-haskell.wasm")),
  })
})

const double = "double :: Double -> Double\ndouble x = 2 * x\n\n"
const driveOn = "driveOn :: Velocity\ndriveOn = Velocity 0.2 0\n\n"
const backOff = "backOff :: Bumper -> Velocity\nbackOff _ = Velocity (-0.2) 0\n\n"
const square = "square :: Task ()\nsquare = drive 50 >> turn 90\n\n"
const main = "main :: IO ()\nmain = simulate _\n"

function offered(text: string) {
  const {document} = readHaskell(reader, "x", text)
  const hole = document.findings.find(f => f.kind === "hole")
  const found = hole === undefined ? undefined : nothingRuns(document, hole)
  const fix = found?.fixes[0]
  return found && {...found, fix, after: fix && applyChanges(text, fixChanges(fix, text.length))}
}

it.each([
  [driveOn + main, "driveOn"],
  [double + driveOn + backOff + main, "driveOn"],
  [double + square + main, "square"],
  [`${backOff}-- what runs\n${main}`, "backOff"],
])("%s", (text, name) => {
  const found = offered(text)
  expect(found?.message).toBe(`Nothing runs yet. Run \`${name}\`?`)
  expect(found?.fix?.title).toBe(`Run ${name}`)
  expect(found?.after).toBe(text.replace(/simulate _\w*/, `simulate ${name}`))
})

it.each([main, double + main])("a program without anything that could run is told to get it: %s", text => {
  const found = offered(text)
  expect(found?.message).toBe("Nothing runs yet. Choose a block for `simulate`, then press Run.")
  expect(found?.fixes).toEqual([])
})

it.each([
  ["something runs", driveOn + main.replace("_", "driveOn")],
  ["something else runs beside the empty place", driveOn + backOff + main.replace("_", "(driveOn, _)")],
  [
    "the empty place is elsewhere",
    `turnOn :: Bumper -> Led1\nturnOn _ = _\n\n${driveOn}${main.replace("_", "driveOn")}`,
  ],
])("none when %s", (_, text) => {
  expect(offered(text)).toBeUndefined()
})
