/// Fixes of a conflict between two functions: text edits that add the definitions of a way out and change what `simulate` runs. Pure.

import {conflictResolutions} from "@rosy/codegen"
import type {Document} from "../state/history.ts"
import type {Finding, Fix} from "../state/program.ts"
import {words} from "../words/index.ts"

export function conflictFixes(
  {workspace, program}: Pick<Document, "workspace" | "program">,
  {conflict}: Pick<Finding, "conflict">,
): readonly Fix[] {
  const main = program.definitions.find(definition => definition.name === "main")
  if (conflict === undefined || main === undefined) return []
  const text = program.text.slice(main.start, main.end)
  // All that follows `simulate` is its argument: no other program has conflicts.
  const argument = /\bsimulate\b\s*(?:\$\s*)?(?=[^\s$])(?![\s\S]*\bsimulate\b)/.exec(text)
  if (argument === null) return []
  const start = main.start + argument.index + argument[0].length
  const end = main.start + text.trimEnd().length
  return conflictResolutions(workspace, conflict).map(way => ({
    title: words.waysOut[way.kind](conflict),
    edits: [
      {start: main.start, end: main.start, text: `${way.definitions}\n\n`},
      {start, end, text: way.rewrite(program.text.slice(start, end))},
    ],
  }))
}
