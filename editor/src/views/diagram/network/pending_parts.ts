/// Parts of a program that the compiler has not reported: those that its text has by now, also with empty places. Pure.

import {isVariableName} from "@rosy/codegen"
import type {WrittenNetwork} from "@rosy/codegen/network-edits"
import type {ProgramPart} from "../../../program/program_graph.ts"

/// The parts of the last report, with each named function replaced by its present definition. Tasks and anonymous functions are unchanged.
export function pendingParts(
  reported: readonly ProgramPart[],
  written: WrittenNetwork,
  defined: ReadonlySet<string>,
): readonly ProgramPart[] {
  if (!written.hasSimulate) return reported
  const running = new Map(written.functions.flatMap(f => (f.runs ? [[f.name, f] as const] : [])))
  const known = new Set(written.functions.map(f => f.name))
  const kept = reported.flatMap((part): ProgramPart[] => {
    if (part.kind !== "function") return [part]
    const now = running.get(part.name)
    if (now !== undefined) return [{...part, inputs: now.inputs, output: now.output}]
    // A name that is gone from the text, or no longer run; the name of something else stays.
    const isGone = isVariableName(part.name) && (known.has(part.name) || !defined.has(part.name))
    return isGone ? [] : [part]
  })
  const shown = new Set(kept.map(part => part.name))
  const added = [...running.values()].filter(f => !shown.has(f.name))
  return [
    ...kept,
    ...added.map(
      ({name, inputs, output}): ProgramPart => ({kind: "function", name, at: null, inputs, output}),
    ),
  ]
}
