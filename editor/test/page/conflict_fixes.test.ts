/// Fixes of a conflict, and the one card that a conflict has.

import {readFileSync} from "node:fs"
import {createRequire} from "node:module"
import {openReader, type Reader} from "@rosy/codegen/reader"
import {beforeAll, expect, it} from "vitest"
import {readHaskell} from "../../src/controller/document/document_conversion.ts"
import {conflictFixes} from "../../src/page/conflict_fixes.ts"
import {allFindings} from "../../src/page/panels/problems.tsx"
import {fixChanges} from "../../src/program/program.ts"
import {applyChanges} from "../../src/program/text_changes.ts"
import {reduce} from "../../src/reducers/reducer.ts"
import {initialState, type PageState} from "../../src/state/page_state.ts"

const {resolve} = createRequire(import.meta.url)
let reader: Reader
beforeAll(async () => {
  reader = await openReader({
    runtime: readFileSync(resolve("web-tree-sitter/web-tree-sitter.wasm")),
    grammar: readFileSync(resolve("tree-sitter-haskell/tree-sitter-haskell.wasm")),
  })
})

const opened = (text: string): PageState => ({
  ...initialState,
  link: "open",
  run: {kind: "running", run: 1},
  room: {...initialState.room, run: 1},
  document: readHaskell(reader, "x", text).document,
})

const functions = `drive :: Velocity
drive = Velocity 0.2 0

backOff :: Bumper -> Maybe Velocity
backOff (Bumper _ Pressed) = Just (Velocity (-0.2) 0)
backOff _ = Nothing
`
const conflicting = (main: string) => `${functions}\n-- what runs\nmain :: IO ()\n${main}\n\n-- the end\n`

it.each([
  "main = simulate (drive, backOff)",
  "main = simulate $ (drive, backOff)",
  "main =\n  simulate\n    (drive, backOff)",
])("the rewritten program has no conflict, and keeps its comments: %s", main => {
  const state = opened(conflicting(main))
  const [card, ...others] = allFindings(state)
  expect(others).toEqual([])
  expect(card).toMatchObject({kind: "conflict", severity: "warning"})
  const fixes = conflictFixes(state.document, card!)
  expect(fixes.map(fix => fix.title)).toEqual(["Let backOff go first, for 1 s"])
  for (const fix of fixes) {
    const {text} = state.document.program
    const after = applyChanges(text, fixChanges(fix, text.length))
    expect(after.startsWith(functions)).toBe(true)
    expect(after).toContain("-- what runs\n")
    expect(after.endsWith("\n\n-- the end\n")).toBe(true)
    expect(allFindings(opened(after)), after).toEqual([])
  }
})

it("a run shows a conflict that the types cannot tell, once, on both blocks", () => {
  const sometimes = functions.replace(
    "drive :: Velocity\ndrive = Velocity 0.2 0",
    "drive :: Seconds -> Maybe Velocity\ndrive now = Just (Velocity 0.2 0)",
  )
  let state = opened(`${sometimes}\nmain = simulate (drive, backOff)\n`)
  expect(allFindings(state)).toEqual([])
  const message = {
    op: "conflict",
    run: 1,
    time: 3,
    command: "Velocity",
    winner: "drive",
    loser: "backOff",
  } as const
  for (const _ of "twice") state = reduce(state, {kind: "heard", message}).state
  expect(state.findings.run.map(f => f.block).filter(block => block !== null)).toHaveLength(2)
  expect(allFindings(state)).toMatchObject([
    {
      severity: "warning",
      message: "`backOff` and `drive` both set the velocity, and `drive` keeps winning.",
      time: 3,
    },
  ])
  expect(conflictFixes(state.document, allFindings(state)[0]!)).not.toEqual([])
})

it("a conflict of an earlier run is not shown", () => {
  const state = opened(conflicting("main = simulate (drive, backOff)"))
  const message = {
    op: "conflict",
    run: 0,
    time: 3,
    command: "Velocity",
    winner: "drive",
    loser: "backOff",
  } as const
  expect(reduce(state, {kind: "heard", message}).state.findings.run).toEqual([])
})
