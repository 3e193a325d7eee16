/// The definitions of a program as texts, and another text for one of them: what the wires of a network do not say is written in its equations.

import type {Reader} from "../reader/module/module_reader.ts"
import {syncText} from "../reader/view/text_synchronization.ts"
import {pieceText, type View} from "../reader/view/view.ts"
import type {NetworkEdit} from "./network_action.ts"

export interface DefinitionText {
  /// The first name that it defines.
  readonly name: string
  /// With the comment above it.
  readonly text: string
}

/// In the order of the text.
export const definitionTexts = ({declarations, module}: View): readonly DefinitionText[] =>
  declarations.flatMap(({name, piece}) => {
    const found = module.pieces[piece]
    return found === undefined ? [] : [{name, text: pieceText(found)}]
  })

/// The program with another text for a definition, or with what is new before `main` when `name` is null. Without a text the definition is deleted.
/// A text that is unfinished Haskell is refused: nothing else shows it where only the diagram is open.
export function definitionEdit(reader: Reader, view: View, name: string | null, text: string): NetworkEdit {
  const written = text.replace(/[^\S\n]+$/gm, "").replace(/^\n+|\s+$/g, "")
  const shown = view.declarations.find(one => one.name === (name ?? "main"))
  const piece = view.module.pieces[shown?.piece ?? -1]
  if (name !== null && piece === undefined)
    return {ok: false, refusal: {kind: "no-such-function", function: name}}
  const start = piece === undefined ? view.text.length : (piece.remark ?? piece.core).start
  const end = name === null ? start : (piece?.core.end ?? start)
  const [before, after] = [view.text.slice(0, start), view.text.slice(end)]
  const changed = joined(before, written, after, name === null)
  const next = syncText(reader, view, changed)
  const wasBroken = view.module.pieces.filter(({broken}) => broken).length
  if (next.module.pieces.filter(({broken}) => broken).length > wasBroken)
    return {ok: false, refusal: {kind: "unfinished-text"}}
  const known = new Set(view.declarations.map(one => one.name))
  const selects = next.declarations.find(one => !known.has(one.name))?.name ?? name ?? undefined
  return {ok: true, text: changed, selects}
}

/// A program with a text between its parts. A new definition stands apart, and nothing remains of one that is deleted.
function joined(before: string, written: string, after: string, isNew: boolean): string {
  if (written === "") return before + after.replace(/^\s*\n/, "")
  if (!isNew) return before + written + after
  return separated(before) + written + (after === "" ? "\n" : `\n\n${after}`)
}

/// A text with an empty line at its end, so that a definition can follow.
const separated = (text: string): string => (text.trim() === "" ? text : `${text.replace(/\n+$/, "")}\n\n`)
