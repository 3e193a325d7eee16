/// A program laid out as the printer does it, definition by definition. What the printer might lose stays as it is: a definition with broken text, one
/// that blocks cannot say, and one whose comments would not all come back.

import type {Declaration} from "../model/tree.ts"
import {buildBlocks} from "./blocks.ts"
import {lex, wordsOf} from "./lexer.ts"
import type {Module, Reader} from "./module.ts"
import {hashTree} from "./trees.ts"
import {writeBack} from "./writeback.ts"

export interface Formatted {
  readonly text: string
  /// How many definitions were left as they are.
  readonly left: number
}

export function formatted(reader: Reader, text: string): Formatted {
  let module = reader.read(text)
  let left = 0
  // From the end, so that the numbers of the pieces before stay what they are.
  for (let i = module.pieces.length - 1; i >= 0; i--) {
    const piece = module.pieces[i]
    if (piece?.declaration === undefined) continue
    const next =
      piece.broken || piece.declaration.kind === "raw-declaration"
        ? undefined
        : printedAnew(reader, module, i, piece.declaration)
    if (next === undefined) left++
    else module = next
  }
  return {text: module.text, left}
}

/// The module with one definition printed; undefined when that would say something else or lose a comment.
function printedAnew(
  reader: Reader,
  module: Module,
  i: number,
  declaration: Declaration,
): Module | undefined {
  const text = writeBack(module, {pieces: new Map([[i, declaration]]), added: []})
  if (text === module.text) return module
  const next = reader.read(text)
  const [before, after] = [module.pieces[i], next.pieces[i]]
  if (before === undefined || after === undefined || next.pieces.length !== module.pieces.length)
    return undefined
  const id = () => "_"
  const [old, fresh] = [buildBlocks(before, id), buildBlocks(after, id)]
  const same = old !== undefined && fresh !== undefined && hashTree(old.block) === hashTree(fresh.block)
  return same && commentsIn(module.text) === commentsIn(text) ? next : undefined
}

/// All words of all comments, in no order: the printer may put a comment above what it stood beside.
function commentsIn(text: string): string {
  return lex(text)
    .comments.flatMap(c => wordsOf(text.slice(c.start, c.end), c.kind))
    .flatMap(line => line.split(/\s+/))
    .sort()
    .join(" ")
    .trim()
}
