/// Every ready-made piece works as it is: with its name in `simulate` it is a whole program that GHC and hlint have
/// nothing to say about, and it is found by the words that somebody would look for.

import {spawnSync} from "node:child_process"
import {mkdtempSync, rmSync, writeFileSync} from "node:fs"
import {tmpdir} from "node:os"
import {join} from "node:path"
import {expect, test} from "vitest"
import {packageDatabase} from "../scripts/ghc.ts"
import {readWorkspace} from "../src/blocks/read.ts"
import {toHaskell} from "../src/workspace/haskell.ts"
import {plug} from "../src/workspace/plug.ts"
import {newWorkspace} from "../src/workspace/project.ts"
import {readyReactions, readyTasks} from "../src/workspace/readymade.ts"
import {libraryItems, toolbox} from "../src/workspace/toolbox.ts"
import {compileAll} from "./ghc.ts"
import {run} from "./process.ts"

const database = packageDatabase()
const hlint = spawnSync("hlint", ["--version"]).status === 0

/// The piece on a fresh workspace, with its name in `simulate`.
const programs = [...readyReactions(), ...readyTasks()].map(({label, block}) => {
  const name = String(block.extraState?.name)
  const fresh = newWorkspace()
  const [main] = fresh.blocks.blocks
  const reference = {type: "name", id: "used", extraState: {name, args: 0}}
  const whole = plug(fresh, {block: main?.id ?? "", input: "R0"}, reference)
  const piece = {...block, id: "piece"}
  const workspace = {...whole, blocks: {...whole.blocks, blocks: [piece, ...whole.blocks.blocks]}}
  return {label, name, program: readWorkspace(workspace).program, ...toHaskell(workspace)}
})

test("pieces have names and labels of their own", () => {
  expect(new Set(programs.map(p => p.name)).size).toBe(programs.length)
  expect(new Set(programs.map(p => p.label)).size).toBe(programs.length)
})

test.each(programs)("$label has no problem, and reads so", ({problems, text, name}) => {
  expect(problems).toEqual([])
  expect(text).toContain(`main = simulate ${name}`)
  expect(text).toMatchSnapshot()
})

// What the test itself writes above a program is not what is looked at.
test.skipIf(database === undefined)("GHC compiles them all, without a warning", async () => {
  const candidates = programs.map(({name, program, text}) => ({
    name: `Ready${name}`,
    program,
    text,
  }))
  expect(
    Object.fromEntries(
      await compileAll(database ?? "", candidates, [
        "-Wall",
        "-Werror",
        "-Wno-dodgy-imports",
        "-Wno-unused-imports",
      ]),
    ),
  ).toEqual({})
})

test.skipIf(!hlint)("hlint has no hint about them", async () => {
  const folder = mkdtempSync(join(tmpdir(), "rosy-ready-"))
  try {
    for (const {name, text} of programs) writeFileSync(join(folder, `${name}.hs`), text)
    expect((await run("hlint", [folder])).stdout.trim()).toBe("No hints")
  } finally {
    rmSync(folder, {recursive: true, force: true})
  }
})

test("every level offers them first or last, and none hides one", () => {
  const labels = programs.map(p => p.label).sort()
  for (const level of ["tasks", "reactions", "haskell"] as const) {
    const found = toolbox(level).flatMap(category => category.items.map(item => item.label))
    expect(found.filter(label => labels.includes(label)).sort()).toEqual(labels)
  }
})

/// What somebody types, and a block that must be among what is found.
const looked = [
  ["speed", "Velocity"],
  ["light", "Led1"],
  ["forever", "step_forever"],
  ["wall", "Bumper"],
  ["loop", "step_repeat"],
  ["colour", "LedColor"],
  ["time", "Clock"],
  ["variable", "Memory"],
  ["noise", "Sound"],
] as const

test.each(looked)("%s finds %s", (word, about) => {
  const items = [...toolbox("haskell").flatMap(category => category.items), ...libraryItems()]
  const found = items.filter(({label, also}) => `${label} ${also ?? ""}`.toLowerCase().includes(word))
  expect(JSON.stringify(found.map(item => item.block))).toContain(`"${about}"`)
})
