/// The command line of codegen: `to-haskell FILE.rosy` prints the program, `to-blocks FILE.hs -o FILE.rosy` makes a project of it.
///
/// The only file here that reads and writes files and ends the process.

import {readFileSync, writeFileSync} from "node:fs"
import {basename} from "node:path"
import type {Outcome} from "./commands.ts"
import {commands, toBlocks} from "./commands.ts"
import {openReader} from "./reader/index.ts"

const [command = "", ...args] = process.argv.slice(2)
const outcome =
  command === "to-blocks" ? await blocks(args) : commands(command, args, path => readFileSync(path, "utf8"))
if (outcome.out !== "") process.stdout.write(outcome.out)
if (outcome.err !== "") process.stderr.write(`${outcome.err}\n`)
process.exitCode = outcome.status

async function blocks(words: readonly string[]): Promise<Outcome> {
  const at = words.indexOf("-o")
  const to = at === -1 ? undefined : words[at + 1]
  const [path, ...others] = at === -1 ? words : words.filter((_, i) => i !== at && i !== at + 1)
  if (path === undefined || others.length > 0 || (at !== -1 && to === undefined))
    return {out: "", err: "Usage: to-blocks FILE.hs -o FILE.rosy", status: 2}
  let bytes: Uint8Array
  try {
    bytes = readFileSync(path)
  } catch {
    return {out: "", err: `Cannot read ${path}.`, status: 1}
  }
  const wasm = (file: string) => readFileSync(new URL(file, import.meta.url))
  const reader = await openReader({
    runtime: wasm("web-tree-sitter.wasm"),
    grammar: wasm("tree-sitter-haskell.wasm"),
  })
  const made = toBlocks(basename(path).replace(/\.hs$/, ""), bytes, reader)
  if (to === undefined) return made
  try {
    writeFileSync(to, made.out)
  } catch {
    return {out: "", err: `Cannot write ${to}.`, status: 1}
  }
  return {...made, out: ""}
}
