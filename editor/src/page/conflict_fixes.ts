/// Fixes of a conflict between two functions: a text edit of what `simulate` runs. Pure.

import {conflictFix, conflictMerge} from "@rosy/codegen"
import type {Document} from "../program/history.ts"
import type {Finding, Fix} from "../program/program.ts"

export function conflictFixes(
  {workspace, program}: Pick<Document, "workspace" | "program">,
  {conflict}: Pick<Finding, "conflict">,
): readonly Fix[] {
  const main = program.definitions.find(definition => definition.name === "main")
  if (conflict === undefined || main === undefined) return []
  const fix = conflictFix(workspace, conflict, program.text, main)
  if (fix === undefined) return []
  const merge = conflictMerge(workspace, conflict, program.text, main)
  return [{title: fix.title, edits: [fix]}, ...(merge === undefined ? [] : [merge])]
}
