/// What the compiler reports about the examples and about the programs of `protocol/goldens/graphs`; the tests of the worker compare the same files.

import {existsSync, readdirSync, readFileSync} from "node:fs"
import {join} from "node:path"
import {type Extent, type ProgramPart, programParts} from "../../src/program/program_graph.ts"
import type {Network} from "../../src/views/diagram/network/network.ts"
import {networkOf} from "../../src/views/diagram/network/network_builder.ts"
import {decode} from "../../src/wire/decode.ts"

const root = join(import.meta.dirname, "../../..")
const goldens = join(root, "protocol/goldens/graphs")

export function graphNames(): readonly string[] {
  return readdirSync(goldens)
    .filter(name => name.endsWith(".json"))
    .map(name => name.slice(0, -".json".length))
}

export function readParts(name: string): readonly ProgramPart[] {
  const file = join(goldens, `${name}.json`)
  const parts = decode(programParts, JSON.parse(readFileSync(file, "utf8")))
  if (parts.kind === "mismatch") throw new Error(`${file}: ${parts.message}`)
  return parts.value
}

export function readSource(name: string): string {
  const own = join(goldens, `${name}.hs`)
  return readFileSync(existsSync(own) ? own : join(root, "examples", name, "Main.hs"), "utf8")
}

export function readGraph(name: string): Network {
  const lines = readSource(name).split("\n")
  const textAt = ({line, column, endLine, endColumn}: Extent) =>
    (lines[line - 1] ?? "").slice(column - 1, line === endLine ? endColumn - 1 : undefined)
  return networkOf(readParts(name), textAt)
}
