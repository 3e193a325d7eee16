/// A program in which `simulate` runs nothing: what the page says in place of an empty socket, and the fix that runs a function of the program, if it has one. Pure.

import {referenceTo} from "@rosy/codegen"
import type {Document} from "../program/history.ts"
import type {Finding, Fix} from "../program/program.ts"
import {words} from "../words/index.ts"

export interface NothingRuns {
  readonly message: string
  readonly fixes: readonly Fix[]
}

/// For a finding about the empty place of a `simulate` that runs nothing else, with something to run or without.
export function nothingRuns(
  {workspace, program}: Pick<Document, "workspace" | "program">,
  finding: Pick<Finding, "kind" | "range" | "block">,
): NothingRuns | undefined {
  if (finding.kind !== "hole") return undefined
  const main = program.definitions.find(definition => definition.name === "main")
  if (main === undefined) return undefined
  const isInMain =
    finding.block === main.block ||
    (finding.range !== null && finding.range.start >= main.start && finding.range.end <= main.end)
  const text = program.text.slice(main.start, main.end)
  const hole = /^[\s\S]*\bsimulate\s+(?=_\w*\s*$)/.exec(text)
  if (!isInMain || hole === null) return undefined
  const runnable = program.definitions.find(
    ({name, block}) =>
      name !== "main" && referenceTo(workspace, {block: main.block, input: "R0"}, block).fits,
  )
  if (runnable === undefined) return {message: words.nothingToRun, fixes: []}
  const {name} = runnable
  const start = main.start + hole[0].length
  return {
    message: words.nothingRuns(name),
    fixes: [
      {title: words.runIt(name), edits: [{start, end: main.start + text.trimEnd().length, text: name}]},
    ],
  }
}
