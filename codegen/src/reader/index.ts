/// Haskell text to program model and blocks, and back into the text it came from.
///
/// ```ts
/// const reader = await openReader({runtime, grammar})   // the bytes of two .wasm files, fetched or read by the caller
/// reader.read(text).pieces                              // never throws, whatever the text; the slices joined are the text
///
/// let view = openView(reader, project.haskell, project.layout)   // a value: text, blocks, and what belongs to what
/// view = syncText(reader, view, newText)                // the text was edited: blocks follow
/// view = syncBlocks(reader, view, workspace)            // blocks were edited: the text follows
/// workspaceOf(view), view.text, layoutOf(view)          // for Blockly, for the editor, for the file
/// blockAt(spansOf(view), offset)                        // which block stands for this place in the text
/// ```
///
/// A definition has its model (`declaration`), or a raw one with its exact text and the reason why blocks cannot say it. Broken text
/// keeps the last good blocks (`dimmed`). Give every edit of the page to one of the two `sync` functions, in order, with one
/// reader for a program: it remembers the last text, so that a keystroke costs only the definition that changed.
/// Nothing here touches the DOM, the network or a clock.

import {Language, Parser} from "web-tree-sitter"
import {Reader} from "./module/module_reader.ts"

/// The two WebAssembly files, as npm delivers them: `web-tree-sitter/web-tree-sitter.wasm` and
/// `tree-sitter-haskell/tree-sitter-haskell.wasm`.
export interface ReaderWasm {
  readonly runtime: Uint8Array
  readonly grammar: Uint8Array
}

/// Loads the parser; takes some 20 ms. Any number of readers may be open; they share the runtime of the first.
export async function openReader(wasm: ReaderWasm): Promise<Reader> {
  await Parser.init({wasmBinary: wasm.runtime})
  const language = await Language.load(wasm.grammar)
  return new Reader(new Parser().setLanguage(language), language)
}

export type {Cause} from "../model/raw_reasons.ts"
export {causeOf, reasons} from "../model/raw_reasons.ts"
export {characterOffsets} from "../source/character_offsets.ts"
export type {Range} from "../source/lexer.ts"
export type {Clip, ClipMerge} from "./clips.ts"
export {clipOf, mergeClip} from "./clips.ts"
export type {Formatted} from "./formatter.ts"
export {formatted} from "./formatter.ts"
export type {Module, Piece} from "./module/module_pieces.ts"
export {sameFixities} from "./module/module_pieces.ts"
export {Reader} from "./module/module_reader.ts"
export type {Word, WordRole} from "./module/semantic_tokens.ts"
export type {Edits} from "./printing/text_patches.ts"
export {writeBack} from "./printing/text_patches.ts"
export type {RenameContext, RenameOutcome} from "./symbol_rename.ts"
export {placesToRename, renameContext} from "./symbol_rename.ts"
export type {Size} from "./view/block_placement.ts"
export {guessSize} from "./view/block_placement.ts"
export {syncBlocks} from "./view/block_synchronization.ts"
export type {BlockSpan} from "./view/block_tree.ts"
export {areSameGroups, placesOfGroups, syntaxGroups} from "./view/syntax_groups.ts"
export {openView, syncText} from "./view/text_synchronization.ts"
export type {Shown, View, ViewOptions} from "./view/view.ts"
export {contradictionNotice, layoutOf, spansOf, workspaceOf} from "./view/view.ts"
