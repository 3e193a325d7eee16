/// Look inside: a ready-made task's definition comes from the library's source and makes a program that says the same.

import {readFileSync} from "node:fs"
import {beforeAll, describe, expect, test} from "vitest"
import {packageDatabase} from "../scripts/ghc.ts"
import {libraryDefinitions, motionSource} from "../scripts/library_definitions.ts"
import {readWorkspace} from "../src/blocks/block_reader.ts"
import {blockTypes} from "../src/blocks/block_registry.ts"
import {infer, lookInside, ownDefinition, rename, toHaskell} from "../src/index.ts"
import {openView, type Reader, workspaceOf} from "../src/reader/index.ts"
import type {SavedBlock, SavedWorkspace} from "../src/serialized_blocks.ts"
import {everyBlock, everyBlockIn} from "../src/workspace/inference/workspace_inference.ts"
import type {LibraryDefinition} from "../src/workspace/library_definitions.ts"
import {generated} from "../src/workspace/toolbox/library_definitions.generated.ts"
import {compileAll} from "./ghc.ts"
import {testReader} from "./reader/open.ts"

const database = packageDatabase()
let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

const open = (text: string): SavedWorkspace => workspaceOf(openView(reader, text))
const blockOf = (workspace: SavedWorkspace, wanted: (b: SavedBlock) => boolean): string =>
  [...everyBlock(workspace)].find(wanted)?.id ?? "none"

/// The workspace with what looking inside a block inserts.
function inserted(workspace: SavedWorkspace, block: string): SavedWorkspace {
  let n = 0
  const definitions = structuredClone(lookInside(workspace, block)?.definitions ?? [])
  for (const one of definitions) for (const b of everyBlockIn(one)) b.id = `in${n++}`
  return {...workspace, blocks: {...workspace.blocks, blocks: [...definitions, ...workspace.blocks.blocks]}}
}

const calls = [
  ["drive", "step_drive", "drive 50"],
  ["turn", "step_turn", "turn 90"],
  ["driveUntilBump", "step_drive_until_bump", "driveUntilBump"],
  ["driveUntil", "step_drive_until", "driveUntil (\\(Button _ _) -> Done ())"],
  ["blink", "step_blink", "blink Red"],
  ["beep", "step_beep", "beep"],
  ["penDown", "step_pen_down", "penDown"],
  ["penUp", "step_pen_up", "penUp"],
  ["penColor", "step_pen_color", "penColor RedInk"],
  ["penWidth", "step_pen_width", "penWidth 5"],
  ["driveBack", "step_drive_back", "driveBack 1"],
  ["turnBetween", "step_turn_between", "turnBetween (-90) 90"],
  ["goTo", "step_go_to", "goTo 1 (-0.5)"],
  ["curveUntilObstacle", "step_curve_until_obstacle", "curveUntilObstacle (-20)"],
  ["eitherOr", "step_either_or", "eitherOr (turn 90) (turn (-90))"],
] as const
const squared = (call: string) => `main :: IO ()\nmain = simulate $ do\n  ${call}\n  wait 1\n`

test("the generated blocks are those of the library's source", () => {
  expect(libraryDefinitions(reader, readFileSync(motionSource, "utf8"))).toEqual(generated)
})

describe.each(calls)("%s", (name, type, call) => {
  test("is a block of its own, and with its definition the program has no problem and no Haskell block", () => {
    const workspace = open(squared(call))
    const block = blockOf(workspace, b => b.type === type)
    expect(lookInside(workspace, block)?.name).toBe(name)
    const whole = inserted(workspace, block)
    expect(infer(whole).problems).toEqual([])
    expect([...everyBlock(whole)].filter(b => b.type.startsWith("raw_"))).toEqual([])
    expect(toHaskell(whole).text).toMatchSnapshot()
  })
})

test.skipIf(database === undefined)("GHC compiles the programs with the definitions in them", async () => {
  const candidates = calls.map(([name, type, call]) => {
    const workspace = open(squared(call))
    const whole = inserted(
      workspace,
      blockOf(workspace, b => b.type === type),
    )
    return {name: `Inside${name}`, program: readWorkspace(whole).program, text: toHaskell(whole).text}
  })
  expect(Object.fromEntries(await compileAll(database ?? "", candidates))).toEqual({})
})

describe("a task whose type depends on its call", () => {
  const own = `bumped :: Bumper -> Maybe (Done BumperSide)\nbumped (Bumper side _) = Just (Done side)\n\n`
  const signature = (text: string, type = "step_drive_until") => {
    const workspace = open(text)
    const found = lookInside(
      workspace,
      blockOf(workspace, b => b.type === type),
    )
    return found?.definitions.map(b => b.extraState?.signature)
  }

  test("gets the type of the call, or of the task itself", () => {
    expect(signature(`${own}${squared("driveUntil bumped")}`)).toEqual([
      "(Bumper -> Maybe (Done BumperSide)) -> Task BumperSide",
    ])
    const inSocket = open(`${own}main :: IO ()\nmain = simulate (race (driveUntil bumped) driveUntilBump)\n`)
    const block = blockOf(inSocket, b => b.extraState?.name === "driveUntil")
    expect(lookInside(inSocket, block)?.definitions[0]?.extraState?.signature).toBe(
      "(Bumper -> Maybe (Done BumperSide)) -> Task BumperSide",
    )
  })

  test("is not looked into while its type is open, or when two calls have different ones", () => {
    expect(signature(squared("driveUntil _"))).toBeUndefined()
    const two = `${own}${squared("driveUntil bumped\n  driveUntil (\\(Button _ _) -> Done ())")}`
    expect(signature(two)).toBeUndefined()
  })

  test("stays the library's where another definition needs it", () => {
    expect(signature(squared("driveUntilBump"), "step_drive_until_bump")).toEqual(["Task BumperSide"])
  })
})

test("a task in a socket is looked into as well", () => {
  const workspace = open("main :: IO ()\nmain = simulate (race (drive 50) beep)\n")
  const named = (name: string) => blockOf(workspace, b => b.extraState?.name === name)
  expect(lookInside(workspace, named("drive"))?.definitions[0]?.extraState?.name).toBe("drive")
  expect(lookInside(workspace, named("race"))).toBeUndefined()
})

test("a helper that is there already is not inserted again, and one of another meaning keeps its name", () => {
  const once = open(`${squared("drive 50")}`)
  const both = inserted(
    once,
    blockOf(once, b => b.type === "step_drive"),
  )
  const text = toHaskell(both).text.replace("drive 50", "turn 90")
  const again = open(text)
  const names = (workspace: SavedWorkspace) =>
    lookInside(
      workspace,
      blockOf(workspace, b => b.type === "step_turn"),
    )?.definitions.map(b => b.extraState?.name)
  expect(names(again)).toEqual(["turn", "startTurn", "runTurn"])
  const other = open(`approach :: Double\napproach = 2\n\n${squared("turn 90")}`)
  expect(names(other)).toEqual(["turn", "startTurn", "runTurn", "approach2"])
  const whole = inserted(
    other,
    blockOf(other, b => b.type === "step_turn"),
  )
  expect(infer(whole).problems).toEqual([])
  expect(toHaskell(whole).text).toContain("Velocity 0 (approach2 0.15")
})

test("a program's own function of the same name is called by name, is not looked into, and can be renamed", () => {
  const own = open(
    `drive :: Double -> Task ()\ndrive speed = once (Velocity speed 0)\n\n${squared("drive 0.5")}`,
  )
  expect([...everyBlock(own)].map(b => b.type)).not.toContain("step_drive")
  const reference = blockOf(own, b => b.type === "name" && b.extraState?.name === "drive")
  expect(lookInside(own, reference)).toBeUndefined()
  expect(ownDefinition(own, reference)).toBe(blockOf(own, b => b.type === "define"))
  const library = open(squared("drive 50"))
  const step = blockOf(library, b => b.type === "step_drive")
  expect(ownDefinition(library, step)).toBeUndefined()
  const whole = inserted(library, step)
  const defined = blockOf(whole, b => b.type === "define" && b.extraState?.name === "drive")
  expect(rename(whole, defined, "name", "go")).toMatchObject({
    ok: true,
    changes: expect.arrayContaining([{block: step, extra: {name: "go"}}]),
  })
  const renamed = structuredClone(whole)
  for (const b of everyBlock(renamed)) if (b.id === step) b.extraState = {name: "go"}
  expect(toHaskell(renamed).text).toContain("  go 50\n")
})

test("a step has a magnifying glass if and only if the library's source has its definition", () => {
  const defined = new Set((generated as readonly LibraryDefinition[]).map(({name}) => name))
  const steps = blockTypes.filter(view => view.calls !== undefined)
  const withGlass = steps.filter(view =>
    view
      .shape({})
      .rows.some(row => row.some(item => item.kind === "button" && item.action === "look-inside")),
  )
  expect(withGlass.map(view => view.calls)).toEqual(
    steps.flatMap(({calls}) => (calls !== undefined && defined.has(calls) ? [calls] : [])),
  )
  expect(withGlass.length).toBeGreaterThan(4)
})
