/// The examples' Haskell is what an experienced Haskeller would write: no warning of `-Wall`, no hint of hlint.

import {spawnSync} from "node:child_process"
import {fileURLToPath} from "node:url"
import {expect, test} from "vitest"
import {packageDatabase} from "../scripts/ghc.ts"
import {inferWorkspace} from "../src/workspace/workspace_inference.ts"
import {exampleNames, exampleProject, examplesFolder, exampleWorkspace} from "./example_programs.ts"
import {compileAll} from "./ghc.ts"
import {run} from "./process.ts"

const database = packageDatabase()
const hlint = spawnSync("hlint", ["--version"]).status === 0

test.skipIf(database === undefined)("no example has a warning", async () => {
  const candidates = exampleNames.map(name => ({
    name: `E${name}`,
    text: exampleProject(name).haskell,
    program: inferWorkspace(exampleWorkspace(name)).read.program,
  }))
  // The instances that Rosy adds are not the learner's: what they are warned of does not count.
  const options = [
    "-Wall",
    "-Werror",
    "-Wno-orphans",
    "-Wno-simplifiable-class-constraints",
    "-Wno-dodgy-imports",
    "-Wno-unused-imports",
  ]
  expect(Object.fromEntries(await compileAll(database ?? "", candidates, options))).toEqual({})
})

test.skipIf(!hlint)("no example has a hint", async () => {
  const {stdout} = await run(
    "hlint",
    exampleNames.map(n => fileURLToPath(new URL(`${n}/Main.hs`, examplesFolder))),
  )
  expect(stdout.trim()).toBe("No hints")
})
