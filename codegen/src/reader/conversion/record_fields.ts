/// Fields of a record, as a pattern and an expression have them: names with or without values, and two dots for all others.

import {isVariableName} from "../../haskell/lexemes.ts"
import type {Cause} from "../../model/raw_reasons.ts"
import type {Context} from "./conversion_context.ts"
import type {Syntax} from "./parse_tree.ts"
import {child, childrenIn, namedChildren} from "./parse_tree.ts"

export interface WrittenField {
  readonly name: string
  readonly label: Syntax
  /// Undefined where the name stands for the value as well.
  readonly value: Syntax | undefined
}

/// The fields of a record whose values are of a kind, and whether two dots follow them.
export function writtenFields(
  record: Syntax,
  kind: "expression" | "pattern",
  context: Context,
): {readonly fields: readonly WrittenField[]; readonly rest: boolean} | Cause {
  const fields: WrittenField[] = []
  let rest = false
  for (const field of childrenIn(record, "field")) {
    if (rest) return "wildcards"
    if (namedChildren(field).some(c => c.type === "wildcard" && c.field === undefined)) {
      rest = true
      continue
    }
    const label = child(field, "field")
    if (label === undefined || label.type === "field_path" || !isVariableName(context.of(label)))
      return "name"
    const name = context.of(label)
    const value = child(field, kind)
    if (value === undefined && name.includes(".")) return "puns"
    fields.push({name, label, value})
  }
  return {fields, rest}
}
