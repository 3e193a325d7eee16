/// Splitter of Haskell text into its top-level declarations, without parsing.
///
/// The reader's own cuts: a declaration starts at the margin; its comments stand above it, and equations of one name belong together with their
/// signature. Concatenating all pieces gives the text back, byte for byte.

import {lex} from "./top_level_items.ts"
import {partsOf} from "./top_level_sections.ts"

export interface Piece {
  /// The text from the end of the piece before to the end of this one, so that nothing is lost between pieces.
  readonly start: number
  readonly end: number
  /// Where the declaration itself (with the comment directly above it) begins and ends; without blank lines around.
  readonly from: number
  readonly to: number
  /// `accelerate`, `Mode`; undefined for what only passes by: imports, pragmas, loose comments.
  readonly name: string | undefined
}

export function splitDeclarations(text: string): Piece[] {
  const parts = partsOf(text, lex(text))
  let end = 0
  return parts
    .filter(p => p.kind !== "end" || parts.length === 1 || p.end > (parts[parts.length - 2]?.end ?? 0))
    .map(part => {
      const start = end
      end = part.end
      const name = part.kind === "declaration" && part.name !== "" ? part.name : undefined
      return {start, end, from: (part.remark ?? part.core).start, to: part.core.end, name}
    })
}

/// A hash of a declaration's text, to see whether it changed since its blocks were saved. How its lines end says
/// nothing. (FNV-1a, 2 × 32 bits.)
export function hashOf(text: string): string {
  let a = 0x811c9dc5
  let b = 0x01000193
  for (let i = 0; i < text.length; i++) {
    const c = text.charCodeAt(i)
    if (c === 13) continue
    a = Math.imul(a ^ c, 0x01000193)
    b = Math.imul(b ^ c, 0x85ebca6b)
  }
  return (a >>> 0).toString(16).padStart(8, "0") + (b >>> 0).toString(16).padStart(8, "0")
}
