/// A program laid out as the printer does it, definition by definition. What the printer might lose stays as it is: a definition with broken text, one
/// that blocks cannot say, and one whose comments would not all come back.

import type {Declaration} from "../model/syntax_tree.ts"
import type {Module} from "./module/module_pieces.ts"
import type {Reader} from "./module/module_reader.ts"
import {commentWords} from "./printing/exact_texts.ts"
import {writeBack} from "./printing/text_patches.ts"
import {buildBlocks} from "./view/block_tree.ts"
import {hashTree} from "./view/tree_matching.ts"

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
  return same && commentWords(module.text) === commentWords(text) ? next : undefined
}
