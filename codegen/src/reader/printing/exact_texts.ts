/// Exact texts of edited definitions, each one read again before it is used.
///
/// The pretty-printer's text says what the workspace says, so it is the measure: an exact text is taken only when reading it gives the same
/// model and the same words in comments. Otherwise larger nodes are replaced, up to the whole definition.

import type {Declaration} from "../../model/syntax_tree.ts"
import {lex, wordsOf} from "../../source/top_level_items.ts"
import type {Module, Piece} from "../module/module_pieces.ts"
import type {Reader} from "../module/module_reader.ts"
import {editedText} from "./exact_printing.ts"
import {meaningOf} from "./model_parts.ts"
import type {MovedTexts} from "./moved_texts.ts"
import {movedTexts} from "./moved_texts.ts"
import type {Source} from "./source_fragments.ts"
import {sourceOf} from "./source_fragments.ts"
import {writeBack} from "./text_patches.ts"

const nothingMoved: MovedTexts = new Map()

/// How the definitions of edits were written, for tests and measurements.
export interface ExactCount {
  /// Only changed nodes were written.
  exact: number
  /// A node around the changed one was written.
  larger: number
  /// The whole definition was printed.
  printed: number
}

/// The new text of each edited definition, without the comment above; of those that have to be printed as a whole there is none.
export function exactTexts(
  reader: Reader,
  module: Module,
  edits: ReadonlyMap<number, Declaration | undefined>,
  count: ExactCount = {exact: 0, larger: 0, printed: 0},
): ReadonlyMap<number, string> {
  const kept = new Map([...edits].filter(([, d]) => d !== undefined))
  const found = new Map<number, string>()
  if (kept.size === 0) return found
  const printed = reader.read(writeBack(module, {pieces: kept, added: []}))
  if (printed.pieces.length !== module.pieces.length) return found
  const sources = new Map(
    [...edits.keys()].flatMap((i): [number, Source][] => {
      const piece = module.pieces[i]
      return piece?.declaration === undefined || piece.declaration.kind === "raw-declaration"
        ? []
        : [[i, sourceOf(piece)]]
    }),
  )
  const moved = movedTexts(
    [...sources].flatMap(([i, source]) => {
      const root = module.pieces[i]?.declaration
      return root === undefined ? [] : [{root, source}]
    }),
  )
  for (const i of kept.keys()) {
    const [piece, target] = [module.pieces[i], printed.pieces[i]]
    if (piece === undefined || target === undefined) continue
    const result = exactText(reader, module, kept, i, sources.get(i) ?? sourceOf(piece), target, moved)
    if (result === undefined) count.printed++
    else {
      if (result.tries === 1) count.exact++
      else count.larger++
      found.set(i, result.text)
    }
  }
  return found
}

function exactText(
  reader: Reader,
  module: Module,
  edits: ReadonlyMap<number, Declaration | undefined>,
  i: number,
  source: Source,
  target: Piece,
  moved: MovedTexts,
): {text: string; tries: number} | undefined {
  const [piece, edited] = [module.pieces[i], edits.get(i)]
  if (edited === undefined || piece?.declaration === undefined || target.declaration === undefined)
    return undefined
  if (piece.declaration.kind !== target.declaration.kind) return undefined
  if (piece.broken && piece.declaration.kind === "raw-declaration") return undefined
  // A comment that changes and stood inside of the definition has no place of its own.
  const remark = piece.declaration.comment ?? ""
  if (remark !== (edited.comment ?? "") && remark !== piece.remarkText) return undefined
  const before = {root: piece.declaration, source}
  const now = {root: target.declaration, source: sourceOf(target)}
  if (
    meaningOf(before.root) === meaningOf(now.root) &&
    innerComments(before.root) === innerComments(now.root)
  )
    return {text: before.source.text, tries: 1}
  if (piece.declaration.kind === "raw-declaration") return undefined
  const meaning = meaningOf(target.declaration)
  const words = commentWords(target.slice)
  // Text that is moved may need brackets in its new place; then the pretty-printer's text stands there.
  for (const texts of [moved, nothingMoved]) {
    let depth = Number.MAX_SAFE_INTEGER
    let last: string | undefined
    for (let tries = 1; tries <= 8 && depth >= 0; tries++) {
      let deepest = -1
      // Items that changed places bring their comments along; where that is not possible, each place keeps the comments around it.
      for (const pairing of ["moved", "in place"] as const) {
        const made = editedText(before, now, texts, depth, pairing)
        if (made === undefined) continue
        deepest = Math.max(deepest, made.deepest)
        if (made.text === last) continue
        last = made.text
        const again = reader.read(
          writeBack(module, {
            pieces: new Map([[i, edited]]),
            exact: new Map([[i, made.text]]),
            added: [],
          }),
        )
        const read = again.pieces[i]
        if (
          again.pieces.length === module.pieces.length &&
          read?.declaration !== undefined &&
          meaningOf(read.declaration) === meaning &&
          commentWords(read.slice) === words
        )
          return {text: made.text, tries: texts === moved ? tries : tries + 8}
      }
      if (deepest < 0) break
      depth = Math.min(deepest, depth) - 1
    }
  }
  return undefined
}

/// The comments inside of a definition, in order.
function innerComments(root: Declaration): string {
  const found: string[] = []
  JSON.stringify(root, (property, value: unknown) => {
    if (property === "comment" && value !== root.comment) found.push(String(value))
    return value
  })
  return found.join("\n")
}

/// All words of all comments, sorted: the pretty-printer may put a comment above the line that it stood beside.
export function commentWords(text: string): string {
  return lex(text)
    .comments.flatMap(c => wordsOf(text.slice(c.start, c.end), c.kind))
    .flatMap(line => line.split(/\s+/))
    .filter(word => word !== "")
    .sort()
    .join(" ")
}
