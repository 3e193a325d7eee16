/// The examples' Haskell is what an experienced Haskeller would write: no warning of `-Wall`, no hint of hlint. Each is called like its folder.

import {spawnSync} from "node:child_process"
import {existsSync, readdirSync, readFileSync} from "node:fs"
import {fileURLToPath} from "node:url"
import {expect, test} from "vitest"
import {packageDatabase} from "../scripts/ghc.ts"
import {openProject, parseProject} from "../src/index.ts"
import {inferWorkspace} from "../src/workspace/inference/workspace_inference.ts"
import {compileAll} from "./ghc.ts"
import {run} from "./process.ts"

const examples = fileURLToPath(new URL("../../examples/", import.meta.url))
const names = readdirSync(examples).filter(n => existsSync(`${examples}${n}/program.rosy`))
const database = packageDatabase()
const hlint = spawnSync("hlint", ["--version"]).status === 0

test.each(names)("the program of the example %s has its name", name => {
  const outcome = parseProject(readFileSync(`${examples}${name}/program.rosy`, "utf8"))
  expect(outcome.ok && outcome.project.name).toBe(name)
})

test.skipIf(database === undefined)("no example has a warning", async () => {
  const candidates = names.map(name => {
    const outcome = parseProject(readFileSync(`${examples}${name}/program.rosy`, "utf8"))
    if (!outcome.ok) throw new Error(outcome.message)
    return {
      name: `E${name}`,
      text: outcome.project.haskell,
      program: inferWorkspace(openProject(outcome.project).workspace).read.program,
    }
  })
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
    names.map(n => `${examples}${n}/Main.hs`),
  )
  expect(stdout.trim()).toBe("No hints")
})
