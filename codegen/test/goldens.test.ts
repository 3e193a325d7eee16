/// Programs built from blocks: a folder each in `programs/`, and every example.
///
/// `workspace.json` is what Blockly saves; `haskell.txt` what codegen prints; `problems.txt` what a learner is told.
/// `UPDATE_GOLDENS=1` rewrites the two last.

import {existsSync, readdirSync, readFileSync, writeFileSync} from "node:fs"
import {fileURLToPath} from "node:url"
import {describe, expect, test} from "vitest"
import {blockTypes} from "../src/blocks/block_registry.ts"
import type {SavedWorkspace} from "../src/index.ts"
import {closeProject, infer, openProject, parseProject, saveProject, toHaskell} from "../src/index.ts"
import {everyBlock} from "../src/workspace/inference/workspace_inference.ts"

const programs = fileURLToPath(new URL("programs/", import.meta.url))
const examples = fileURLToPath(new URL("../../examples/", import.meta.url))
const folders = (path: string) =>
  readdirSync(path, {withFileTypes: true})
    .filter(entry => entry.isDirectory())
    .map(entry => entry.name)

function golden(path: string, text: string): void {
  if (process.env.UPDATE_GOLDENS === "1") writeFileSync(path, text)
  expect(text).toBe(existsSync(path) ? readFileSync(path, "utf8") : "")
}

const loadProgram = (name: string): SavedWorkspace =>
  JSON.parse(readFileSync(`${programs}${name}/workspace.json`, "utf8"))
const loadExample = (name: string) => {
  const outcome = parseProject(readFileSync(`${examples}${name}/program.rosy`, "utf8"))
  if (!outcome.ok)
    throw new Error(`expected ${name} to be a project, found: ${outcome.message} ${outcome.hint}`)
  return outcome.project
}

describe.each(folders(programs))("program %s", name => {
  const workspace = loadProgram(name)
  test("prints as expected", () => golden(`${programs}${name}/haskell.txt`, toHaskell(workspace).text))
  test("says what is wrong with it", () => {
    const said = infer(workspace).problems.map(
      p =>
        `${p.block ?? "-"}${p.input === undefined ? "" : `/${p.input}`} ${p.kind}: ${p.message} ${p.hint}\n`,
    )
    golden(`${programs}${name}/problems.txt`, said.join(""))
  })
})

// A folder without a program is a page of its own.
const projects = folders(examples).filter(name => existsSync(`${examples}${name}/program.rosy`))

describe.each(projects)("example %s", name => {
  const project = loadExample(name)
  test("has blocks that say exactly what its text says", () =>
    expect(openProject(project).changed).toEqual([]))
  test("prints exactly its Main.hs", () => {
    const {workspace} = openProject(project)
    golden(`${examples}${name}/Main.hs`, toHaskell(workspace).text)
    expect(project.haskell).toBe(toHaskell(workspace).text)
  })
  test("has no problem and no raw block", () => {
    const {workspace} = openProject(project)
    expect(infer(workspace).problems).toEqual([])
    expect([...everyBlock(workspace)].map(b => b.type).filter(t => t.startsWith("raw_"))).toEqual([])
  })
  test("stays the same when it is saved", () => {
    const again = closeProject(project, openProject(project).workspace)
    expect(saveProject(again)).toBe(readFileSync(`${examples}${name}/program.rosy`, "utf8"))
  })
  test("says in three sentences what it teaches", () => {
    // What stands below them is for those who want to know more.
    const [title, sentences = ""] = readFileSync(`${examples}${name}/README.md`, "utf8").split("\n\n")
    expect(title).toBe(`# ${name}`)
    expect(sentences.trim().split("\n").length).toBe(3)
  })
})

test("block types have different names", () => {
  expect(new Set(blockTypes.map(s => s.type)).size).toBe(blockTypes.length)
})

test("every block type stands in some program", () => {
  const used = new Set(folders(programs).flatMap(name => [...everyBlock(loadProgram(name))].map(b => b.type)))
  expect(blockTypes.map(s => s.type).filter(t => !used.has(t))).toEqual([])
})
