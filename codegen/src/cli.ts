/// The command line of codegen: `to-haskell FILE.rosy` prints the program, `to-blocks FILE.hs -o FILE.rosy` makes a project of it, and `text-service` answers
/// questions of the language server, line by line, until its input ends.
///
/// With `atomic_file.ts` the only file here that reads and writes files; the only one that ends the process.

import {readFileSync} from "node:fs"
import {basename} from "node:path"
import {replaceFile} from "./atomic_file.ts"
import type {Outcome} from "./commands.ts"
import {argumentsOf, commands, toBlocks} from "./commands.ts"
import {openReader, type Reader} from "./reader/index.ts"
import {speakAsTerminal} from "./terminal_language.ts"
import {neutralize} from "./terminal_text.ts"
import {answerLine, greeting, linesOf} from "./text_service.ts"
import {words} from "./words/index.ts"

speakAsTerminal(process.env)
const [command = "", ...args] = process.argv.slice(2)
if (command === "text-service") await serveText()
const outcome =
  command === "to-blocks" ? await blocks(args) : commands(command, args, path => readFileSync(path))
process.stdout.on("error", failure => {
  // A reader that has left is told nothing.
  if ((failure as NodeJS.ErrnoException).code !== "EPIPE")
    process.stderr.write(`${words.commandLine.outputCannotBeWritten}\n`)
  process.exitCode = 1
})
// A file keeps every character; a terminal would obey some.
if (outcome.out !== "") process.stdout.write(process.stdout.isTTY ? neutralize(outcome.out) : outcome.out)
if (outcome.err !== "") process.stderr.write(`${neutralize(outcome.err)}\n`)
process.exitCode = outcome.status

/// Ends with its input.
async function serveText(): Promise<never> {
  const reader = await parser()
  process.stdout.write(`${greeting()}\n`)
  for await (const line of linesOf(process.stdin)) process.stdout.write(`${answerLine(reader, line)}\n`)
  process.exit(0)
}

function parser(): Promise<Reader> {
  const wasm = (file: string) => readFileSync(new URL(file, import.meta.url))
  return openReader({runtime: wasm("web-tree-sitter.wasm"), grammar: wasm("tree-sitter-haskell.wasm")})
}

async function blocks(given: readonly string[]): Promise<Outcome> {
  const understood = argumentsOf(given)
  if (understood === undefined) return {out: "", err: words.commandLine.usage, status: 2}
  const {path, to, readsOlder} = understood
  let bytes: Uint8Array
  try {
    bytes = readFileSync(path)
  } catch {
    return {out: "", err: words.commandLine.cannotRead(path), status: 1}
  }
  const made = toBlocks(basename(path), bytes, await parser(), readsOlder)
  if (to === undefined || made.status !== 0) return made
  try {
    replaceFile(to, made.out)
  } catch (failure) {
    return {out: "", err: refusalOf(to, failure), status: 1}
  }
  return {...made, out: ""}
}

function refusalOf(path: string, failure: unknown): string {
  const code = (failure as NodeJS.ErrnoException).code
  if (code === "ENOSPC" || code === "EDQUOT" || code === "EFBIG") return words.commandLine.diskIsFull(path)
  if (code === "EACCES" || code === "EPERM" || code === "EROFS")
    return words.commandLine.writingIsNotAllowed(path)
  return words.commandLine.cannotWrite(path)
}
