/// Rename of a symbol in the page's document, as a change set.

import {placesToRename} from "@rosy/codegen/reader"
import type {Document} from "../../program/history.ts"
import {ChangeSet} from "../../program/text_changes.ts"

export type RenameResult =
  | {readonly ok: true; readonly changes: ChangeSet}
  | {readonly ok: false; readonly why: string}

/// Renames `old` at an offset to `name` at all its occurrences in scope.
export function renameSymbol(document: Document, offset: number, old: string, name: string): RenameResult {
  const {
    program: {text, spans},
    workspace,
    view,
    dimmed,
  } = document
  const context = {text, spans, workspace, module: view?.module, isUnfinished: dimmed.length > 0}
  const outcome = placesToRename(context, offset, old, name)
  if (!outcome.ok) return outcome
  const edits = outcome.places.map(({start, end}) => ({from: start, to: end, insert: name}))
  return {ok: true, changes: ChangeSet.of(edits, text.length)}
}
