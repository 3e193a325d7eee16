/// Views: a program as text and as blocks, at one moment. A view is a value.

import type {LaidOut, PrintedProgram} from "../../api.ts"
import type {SavedBlock, SavedWorkspace} from "../../serialized_blocks.ts"
import {hashOf} from "../../source/declaration_splitter.ts"
import {words} from "../../words/index.ts"
import type {Module, Piece} from "../module/module_pieces.ts"
import type {Size} from "./block_placement.ts"
import type {BlockSpan} from "./block_tree.ts"

/// One definition, as text and as blocks.
export interface Shown {
  /// What the layout calls it: the first name it defines, or `_`.
  readonly name: string
  /// Its number in `module.pieces`.
  readonly piece: number
  readonly block: SavedBlock
  /// Its text is broken; these are the blocks it had before.
  readonly dimmed: boolean
  /// Which text each block stands for, counted from the definition's start. Empty while dimmed.
  readonly spans: readonly BlockSpan[]
}

export interface View {
  readonly text: string
  readonly module: Module
  /// In the order of the text.
  readonly declarations: readonly Shown[]
  /// Blocks that belong to no definition.
  readonly loose: readonly SavedBlock[]
  /// Definitions that left the text lately; their blocks come back if they do.
  readonly gone: readonly Shown[]
  /// Views before the last edits of the blocks, the latest first, as long as the text was not edited otherwise: blocks that are put back bring back its
  /// every character.
  readonly earlier?: readonly View[]
  /// The next new block is called `t` and this number.
  readonly nextId: number
  /// Definitions whose saved blocks said something else than the text, although their hash was that of the text. The text has won.
  readonly contradicted?: readonly string[]
  /// Definitions whose unfinished text the last edit of the blocks would have lost, so that it was not made.
  readonly refused?: readonly string[]
  /// The edit was refused although the text is finished: read again, the new text is another tree than that of the blocks.
  readonly inexpressible?: true
  /// The last edit of the blocks has changed more blocks than it showed: those of the view are to be drawn.
  readonly remade?: true
}

export interface ViewOptions {
  /// How large a block is on the page; without it, sizes are guessed.
  readonly size?: (block: SavedBlock) => Size
}

/// The definition with the comment above it, as the layout's hash counts it.
export function pieceText(piece: Piece): string {
  return piece.slice.slice((piece.remark ?? piece.core).start - piece.start, piece.core.end - piece.start)
}

/// The names that a program defines at its top level.
export function definedIn(module: Module): ReadonlySet<string> {
  return new Set(module.pieces.flatMap(piece => piece.names))
}

/// What to tell about definitions whose saved blocks contradicted the text.
export function contradictionNotice(
  view: View,
): {readonly message: string; readonly hint: string} | undefined {
  if (view.contradicted === undefined) return undefined
  const names = view.contradicted.slice(0, 5).join(", ")
  return {
    message: words.projects.someBlocksSaidSomethingElse,
    hint: words.projects.theyAre(view.contradicted.length > 5 ? `${names}, …` : names),
  }
}

/// All blocks, as Blockly loads them.
export function workspaceOf(view: View): SavedWorkspace {
  const header = headerOf(view)
  return {
    ...(header === "" ? {} : {header}),
    blocks: {languageVersion: 0, blocks: [...view.declarations.map(s => s.block), ...view.loose]},
  }
}

/// What the text says above its definitions.
export function headerOf(view: View): string {
  return view.module.pieces
    .flatMap(p => (p.kind === "header" ? [p.slice] : []))
    .join("")
    .trim()
}

/// The layout to save beside the text.
export function layoutOf(view: View): {declarations: LaidOut[]; loose: readonly SavedBlock[]} {
  return {
    declarations: view.declarations.map(s => {
      const piece = view.module.pieces[s.piece]
      // Blocks of a broken text do not say what it says.
      const hash = piece === undefined || s.dimmed ? "" : hashOf(pieceText(piece))
      return {name: s.name, hash, blocks: s.block}
    }),
    loose: view.loose,
  }
}

/// The text with the place of each block in it, for `blockAt`, `spanOf` and `spanOfSocket`.
export function spansOf(view: View): PrintedProgram {
  const spans = view.declarations.flatMap(s => {
    const start = view.module.pieces[s.piece]?.core.start ?? 0
    return s.spans.map(x => ({start: start + x.start, end: start + x.end, block: x.block, input: x.input}))
  })
  return {text: view.text, spans}
}
