/// Example projects for tests: their files, and the blocks that their Haskell is read into, as a page shows them.

import {existsSync, readdirSync, readFileSync} from "node:fs"
import {type Project, parseProject, type SavedWorkspace} from "../src/index.ts"
import {openView, workspaceOf} from "../src/reader/index.ts"
import {testReader} from "./reader/open.ts"

export const examplesFolder = new URL("../../examples/", import.meta.url)

/// A folder without a program is a page of its own.
export const exampleNames: readonly string[] = readdirSync(examplesFolder)
  .filter(name => existsSync(new URL(`${name}/program.rosy`, examplesFolder)))
  .sort()

export function exampleProject(name: string): Project {
  const outcome = parseProject(readFileSync(new URL(`${name}/program.rosy`, examplesFolder), "utf8"))
  if (!outcome.ok)
    throw new Error(`expected ${name} to be a project, found: ${outcome.message} ${outcome.hint}`)
  return outcome.project
}

const reader = await testReader()

export function exampleWorkspace(name: string): SavedWorkspace {
  return workspaceOf(openView(reader, exampleProject(name).haskell))
}
