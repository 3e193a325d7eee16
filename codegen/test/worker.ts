/// The real worker, asked to check programs. Tests that need it are skipped where it has not been built.

import {spawn} from "node:child_process"
import {existsSync, readdirSync} from "node:fs"
import {createInterface} from "node:readline"
import type {Duplex} from "node:stream"
import {fileURLToPath} from "node:url"

export interface Checked {
  readonly id: number
  /// As `protocol/README.md` says; undefined where GHC cannot parse the program.
  readonly groups?: readonly number[]
}

const program = builtWorker()
export const hasWorker = program !== undefined

/// On a busy machine a check may wait long for the processor, seconds.
const patience = "600"

/// The answers about some programs, in their order. Descriptor 3 of the worker is a socket.
export async function checkAll(texts: readonly string[]): Promise<readonly Checked[]> {
  if (program === undefined) throw new Error("the worker has not been built")
  const child = spawn(program, ["--fd", "3", "--check-seconds", patience], {
    stdio: ["ignore", "ignore", "ignore", "pipe"],
  })
  const socket = child.stdio[3] as Duplex
  const answers: Checked[] = []
  try {
    for await (const line of createInterface({input: socket})) {
      const said = JSON.parse(line) as Checked & {op: string; message?: string}
      if (said.op === "failed") throw new Error(said.message)
      if (said.op === "checked") answers.push(said)
      const source = texts[answers.length]
      if (source === undefined) break
      socket.write(`${JSON.stringify({op: "check", id: answers.length, source})}\n`)
    }
  } finally {
    child.kill()
  }
  if (answers.length < texts.length) throw new Error("the worker has ended")
  return answers
}

function builtWorker(): string | undefined {
  const root = fileURLToPath(new URL("../../dist-newstyle/build/", import.meta.url))
  if (!existsSync(root)) return undefined
  const under = (folder: string): string[] => readdirSync(folder).map(name => `${folder}/${name}`)
  return under(root)
    .flatMap(under)
    .flatMap(under)
    .map(unit => `${unit}/x/rosy-worker/build/rosy-worker/rosy-worker`)
    .filter(path => existsSync(path))
    .at(-1)
}
