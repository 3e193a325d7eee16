/// How long the page waits for codegen: a drag's check, an edit to updated Haskell, inference, by size of program.

import {existsSync, readdirSync, readFileSync} from "node:fs"
import {fileURLToPath} from "node:url"
import type {Place, SavedBlock, SavedWorkspace} from "../src/index.ts"
import {blockView, checker, infer, openProject, parseProject, session, toHaskell} from "../src/index.ts"
import {everyBlock} from "../src/workspace/inference/workspace_inference.ts"

const examples = fileURLToPath(new URL("../../examples/", import.meta.url))

/// Copies of example definitions, each with names of its own, until there are as many blocks as wanted.
function programOf(size: number): SavedWorkspace {
  const sources = readdirSync(examples).filter(n => existsSync(`${examples}${n}/program.rosy`))
  const tops: SavedBlock[] = []
  let count = 0
  for (let copy = 0; count < size; copy++) {
    const name = sources[copy % sources.length] ?? "move"
    const outcome = parseProject(readFileSync(`${examples}${name}/program.rosy`, "utf8"))
    if (!outcome.ok) throw new Error(`expected ${name} to be a project, found: ${outcome.message}`)
    const {workspace} = openProject(outcome.project)
    const own = new Set(
      workspace.blocks.blocks.flatMap(b => {
        const constructors = (b.extraState?.constructors ?? []) as readonly {name: string}[]
        return [String(b.extraState?.name ?? ""), ...constructors.map(c => c.name)]
      }),
    )
    const text = JSON.stringify(workspace.blocks.blocks.filter(b => b.type !== "main"))
    const renamed = text
      .replace(/"(?:name|con)":"([^"]+)"/g, (all, n) =>
        own.has(n) ? all.replace(`"${n}"`, `"${n}${copy}"`) : all,
      )
      .replace(/"(?:signature|type)":"([^"]+)"/g, all =>
        all.replace(/\b[A-Z]\w*\b/g, word => (own.has(word) ? `${word}${copy}` : word)),
      )
      .replace(/"id":"/g, `"id":"${copy}:`)
    tops.push(...(JSON.parse(renamed) as SavedBlock[]))
    count = [...everyBlock({blocks: {languageVersion: 0, blocks: tops}})].length
  }
  tops.push({type: "main", id: "main", extraState: {controllers: 1}})
  return {blocks: {languageVersion: 0, blocks: tops}}
}

/// Once with as little as it takes, to see that it still works.
const small = process.env.ROSY_BENCH_SMALL !== undefined

function measure(most: number, go: (i: number) => void): {p50: number; p95: number} {
  const all: number[] = []
  // The first rounds run code that is not compiled yet; a page has had those before the first edit.
  const times = small ? 2 : most
  for (let i = 0; i < (small ? 1 : 10); i++) go(i)
  for (let i = 0; i < times; i++) {
    const start = performance.now()
    go(i)
    all.push(performance.now() - start)
  }
  all.sort((a, b) => a - b)
  return {p50: all[Math.floor(times / 2)] ?? 0, p95: all[Math.floor(times * 0.95)] ?? 0}
}

function socketsOf(workspace: SavedWorkspace): Place[] {
  return [...everyBlock(workspace)].flatMap(b =>
    (blockView(b.type)?.shape(b.extraState ?? {}).rows ?? [])
      .flat()
      .flatMap(item =>
        item.kind === "socket" && b.id !== undefined ? [{block: b.id, input: item.name}] : [],
      ),
  )
}

const print = (what: string, {p50, p95}: {p50: number; p95: number}) =>
  process.stdout.write(`${what.padEnd(58)} ${p50.toFixed(2).padStart(8)} ${p95.toFixed(2).padStart(8)}\n`)

process.stdout.write(`${"milliseconds".padEnd(58)} ${"median".padStart(8)} ${"95 %".padStart(8)}\n`)
for (const size of [500, 2000]) {
  const workspace = programOf(size)
  const places = socketsOf(workspace)
  const blocks = [...everyBlock(workspace)].length
  const problems = infer(workspace).problems.filter(p => p.kind !== "hole").length
  process.stdout.write(`${blocks} blocks, ${places.length} sockets, ${problems} problems\n`)
  const led: SavedBlock = {type: "construct", id: "led", extraState: {con: "Led1", args: 1}}
  const at = (i: number): Place => places[(i * 7919) % places.length] ?? {block: "main", input: "R0"}
  print(
    "  drag: the first question",
    measure(20, i => checker(workspace).fits(at(i), led)),
  )
  const check = checker(workspace)
  print(
    "  drag: every further question",
    measure(400, i => check.fits(at(i), led)),
  )
  const moved = checker(workspace)
  const ids = [...everyBlock(workspace)].flatMap(b => b.id ?? [])
  print(
    "  drag: a block of the program itself",
    measure(200, i => moved.fits(at(i), ids[(i % 3) * 50] ?? "")),
  )
  print(
    "  edit: blocks to Haskell with types and problems",
    measure(40, () => toHaskell(structuredClone(workspace))),
  )
  // As the page asks: one definition is another, the rest are the very same values as before.
  const asked = session()
  asked.infer(workspace)
  const tops = workspace.blocks.blocks
  print(
    "  edit: types and problems, with what was remembered",
    measure(40, i => {
      const blocks = [...tops]
      const at = (i * 7) % tops.length
      blocks[at] = structuredClone(tops[at] as SavedBlock)
      asked.infer({...workspace, blocks: {...workspace.blocks, blocks}})
    }),
  )
  print(
    "  types of all blocks and sockets",
    measure(40, () => infer(structuredClone(workspace))),
  )
}
