/// New text for the definitions that were changed in blocks; every other character stays.

import {printDeclarationAlone} from "../../haskell/printer.ts"
import type {Declaration} from "../../model/syntax_tree.ts"
import {expandTabs} from "../../source/tab_expansion.ts"
import type {Module, Piece} from "../module/module_pieces.ts"

/// What happened to the definitions of a module, by the number of their piece.
export interface Edits {
  /// The new definition for a piece, or `undefined` when it was deleted.
  readonly pieces: ReadonlyMap<number, Declaration | undefined>
  /// Texts that already say what the new definition says, by the number of its piece; without the comment above.
  readonly exact?: ReadonlyMap<number, string>
  /// New definitions; they go before `main` when that comes last, else to the end.
  readonly added: readonly Declaration[]
}

export function writeBack(module: Module, edits: Edits): string {
  const {pieces} = module
  const newline = /\r\n/.test(module.text) ? "\r\n" : "\n"
  const print = (d: Declaration): string => inLines(printDeclarationAlone(d, module.fixities), newline)
  const before = addedBefore(pieces, edits)
  const margin = marginOf(module)
  const hasDefinitions = pieces.some(p => p.kind === "declaration")
  const indented = (text: string) => (hasDefinitions ? text.replace(/^(?=[^\r\n])/gm, margin) : text)
  const added = edits.added.map(d => indented(print(d)))
  let out = ""
  pieces.forEach((piece, i) => {
    if (i === before) out = withAdded(out, added, newline, !/^[ \t]*\r?\n/.test(piece.slice))
    if (!edits.pieces.has(i)) out += piece.slice
    else {
      const edited = edits.pieces.get(i)
      out +=
        edited === undefined
          ? removed(piece, newline, startsLine(piece, module.text))
          : replaced(piece, module.text, edited, edits.exact?.get(i), print, newline, margin)
    }
  })
  return before === pieces.length ? withAdded(out, added, newline, false) : out
}

/// The smallest indentation of a definition.
function marginOf({pieces, text}: Module): string {
  let least = " ".repeat(80)
  for (const piece of pieces) {
    if (least === "") break
    if (piece.kind !== "declaration") continue
    const own = indentation(piece, text)
    if (own.length < least.length) least = own
  }
  return least
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
  text: string,
  edited: Declaration,
  exact: string | undefined,
  print: (d: Declaration) => string,
  newline: string,
  margin: string,
): string {
  const same = piece.remarkText === (edited.comment ?? "")
  const start = (same || piece.remark === undefined ? piece.core.start : piece.remark.start) - piece.start
  if (exact !== undefined) return withExactText(piece, text, edited, exact, newline)
  const {comment: _, ...bare} = edited
  const above = piece.slice.slice(0, start)
  const behind = piece.slice.slice(piece.core.end - piece.start)
  const printed = print(same ? (bare as Declaration) : edited)
  // Haskell kept as text has its margin already.
  if (edited.kind === "raw-declaration") return above + printed + behind
  // In a file with a margin every line keeps it. A definition that stands to the right of others is put in line.
  const own = indentation(piece, text)
  const indent = own.length > margin.length ? margin : own
  const isFirst = startsLine(piece, text)
  const line = isFirst ? above.replace(/[ \t]*$/, indent) : same ? above : above.trimEnd() + newline + indent
  return line + printed.replaceAll(newline, newline + indent) + behind
}

/// The definition's own text as it is given; the comment above is written only where it says something else.
function withExactText(
  piece: Piece,
  text: string,
  edited: Declaration,
  exact: string,
  newline: string,
): string {
  const core = piece.core.start - piece.start
  const behind = piece.slice.slice(piece.core.end - piece.start)
  if ((piece.declaration?.comment ?? "") === (edited.comment ?? ""))
    return piece.slice.slice(0, core) + exact + behind
  const start = piece.remark === undefined ? core : piece.remark.start - piece.start
  const remark = (edited.comment ?? "")
    .split("\n")
    .map(l => (l.trim() === "" ? "--" : `-- ${l.trimEnd()}`) + newline + indentation(piece, text))
  const written = (edited.comment ?? "").trim() === "" ? "" : remark.join("")
  const above = piece.slice.slice(0, start)
  // A comment cannot stand between `where` and the first definition on one line: the definition would lose its column.
  return written === "" || startsLine(piece, text)
    ? above + written + exact + behind
    : above.trimEnd() + newline + indentation(piece, text) + written + exact + behind
}

/// Whether nothing but blanks stands before a definition on its line.
function startsLine(piece: Piece, text: string): boolean {
  return /^\uFEFF?[ \t]*$/.test(
    text.slice(text.lastIndexOf("\n", piece.core.start - 1) + 1, piece.core.start),
  )
}

/// The blanks before a definition; as many as its column where something else stands before it on its line.
function indentation(piece: Piece, text: string): string {
  const before = text
    .slice(text.lastIndexOf("\n", piece.core.start - 1) + 1, piece.core.start)
    .replace("\uFEFF", "")
  return /^[ \t]*$/.test(before) ? before : " ".repeat(expandTabs(before).length)
}

/// What stood around it stays: comments with an empty line between, one behind it, and the end of a line that something before it is on.
function removed(piece: Piece, newline: string, isFirst: boolean): string {
  const above = piece.slice.slice(0, (piece.remark ?? piece.core).start - piece.start)
  const behind = piece.slice.slice(piece.core.end - piece.start)
  const kept = above.trim() === "" ? "" : above.trimEnd() + newline
  if (!isFirst && kept === "" && /^[ \t]*\r?\n/.test(behind))
    return behind.trimStart() === "" ? newline : behind
  return behind.trim() === "" ? kept : kept + behind.trimStart()
}
