/// New text for the definitions that were changed in blocks; every other character stays.

import {printDeclarationAlone} from "../haskell/print.ts"
import type {Declaration} from "../model/tree.ts"
import type {Module, Piece} from "./module.ts"

/// What happened to the definitions of a module, by the number of their piece.
export interface Edits {
  /// The new definition for a piece, or `undefined` when it was deleted.
  readonly pieces: ReadonlyMap<number, Declaration | undefined>
  /// New definitions; they go before `main` when that comes last, else to the end.
  readonly added: readonly Declaration[]
}

export function writeBack(module: Module, edits: Edits): string {
  const {pieces} = module
  const newline = /\r\n/.test(module.text) ? "\r\n" : "\n"
  const print = (d: Declaration): string => inLines(printDeclarationAlone(d, module.fixities), newline)
  const before = addedBefore(pieces, edits)
  const margin = pieces
    .filter(p => p.kind === "declaration")
    .map(indentation)
    .reduce((least, own) => (own.length < least.length ? own : least), " ".repeat(80))
  let out = ""
  pieces.forEach((piece, i) => {
    if (i === before) out = withAdded(out, edits.added.map(print), newline, !/^[ \t]*\r?\n/.test(piece.slice))
    if (!edits.pieces.has(i)) out += piece.slice
    else {
      const edited = edits.pieces.get(i)
      out += edited === undefined ? removed(piece, newline) : replaced(piece, edited, print, newline, margin)
    }
  })
  return before === pieces.length ? withAdded(out, edits.added.map(print), newline, false) : out
}

function inLines(text: string, newline: string): string {
  const trimmed = text.replace(/\n+$/, "")
  return newline === "\n" ? trimmed : trimmed.replaceAll("\n", newline)
}

/// The piece in front of which new definitions go.
function addedBefore(pieces: readonly Piece[], edits: Edits): number {
  if (edits.added.length === 0) return -1
  const last = pieces.findLastIndex(
    (p, i) => p.kind === "declaration" && !(edits.pieces.has(i) && edits.pieces.get(i) === undefined),
  )
  if (last !== -1 && pieces[last]?.names[0] === "main") return last
  const end = pieces.findIndex(p => p.kind === "end")
  return end === -1 ? pieces.length : end
}

function withAdded(before: string, printed: readonly string[], newline: string, more: boolean): string {
  if (printed.length === 0) return before
  const ends = before === "" || before.endsWith("\n") ? before : before + newline
  const blank = ends === "" || /\n\r?\n$/.test(ends) ? "" : newline
  return `${ends}${blank}${printed.join(newline + newline)}${newline}${more ? newline : ""}`
}

/// Comments that stand above with an empty line between are no part of the definition, and neither is one behind it.
function replaced(
  piece: Piece,
  edited: Declaration,
  print: (d: Declaration) => string,
  newline: string,
  margin: string,
): string {
  const same = piece.remarkText === (edited.comment ?? "")
  const start = (same || piece.remark === undefined ? piece.core.start : piece.remark.start) - piece.start
  const {comment: _, ...bare} = edited
  const above = piece.slice.slice(0, start)
  const behind = piece.slice.slice(piece.core.end - piece.start)
  const printed = print(same ? (bare as Declaration) : edited)
  // Haskell kept as text has its margin already.
  if (edited.kind === "raw-declaration") return above + printed + behind
  // In a file with a margin every line keeps it. A definition that stands to the right of others is put in line.
  const own = indentation(piece)
  const indent = own.length > margin.length ? margin : own
  const line = /(?:^|\n|\uFEFF)[ \t]*$/.test(above) ? above.replace(/[ \t]*$/, indent) : above
  return line + printed.replaceAll(newline, newline + indent) + behind
}

/// The blanks before a definition.
function indentation(piece: Piece): string {
  return /(?<=^|\n|\uFEFF)[ \t]*$/.exec(piece.slice.slice(0, piece.core.start - piece.start))?.[0] ?? ""
}

/// What stood around it stays: comments with an empty line between, and one behind it.
function removed(piece: Piece, newline: string): string {
  const above = piece.slice.slice(0, (piece.remark ?? piece.core).start - piece.start)
  const behind = piece.slice.slice(piece.core.end - piece.start)
  const kept = above.trim() === "" ? "" : above.trimEnd() + newline
  return behind.trim() === "" ? kept : kept + behind.trimStart()
}
