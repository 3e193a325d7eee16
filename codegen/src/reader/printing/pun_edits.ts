/// Edits of a record's fields that stand for the variables of their names: `R {x}`.

import type {FieldPattern, FieldValue, Node} from "../../model/syntax_tree.ts"
import {partsOf} from "./model_parts.ts"
import type {Source} from "./source_fragments.ts"
import {rangeOf} from "./source_fragments.ts"
import type {Edit} from "./text_edits.ts"

type Record = Extract<Node, {readonly fields: readonly (FieldValue | FieldPattern)[]}>

export function isRecord(node: Node): node is Record {
  return node.kind === "record" || node.kind === "update" || node.kind === "record-pattern"
}

/// The edits that give such fields their names back, where each will say something else; undefined for every other difference.
export function punEdits(source: Source, old: Record, fresh: Record): readonly Edit[] | undefined {
  if (labelOf(old) !== labelOf(fresh)) return undefined
  const edits: Edit[] = []
  for (const [i, field] of old.fields.entries()) {
    const [was, is] = [field.pun === true, fresh.fields[i]?.pun === true]
    if (was === is) continue
    const span = rangeOf(source, "value" in field ? field.value : field.pattern)
    if (is || span === undefined) return undefined
    edits.push({start: span.start, end: span.start, text: `${field.name} = `})
  }
  return edits
}

/// What the record says itself, however its fields are written.
function labelOf(node: Record): string {
  const fields = node.fields.map(({pun: _, ...field}) => field)
  return partsOf({...node, fields} as Node).label
}
