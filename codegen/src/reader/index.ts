/// Haskell text to program model, and back into the text it came from.
///
/// ```ts
/// const reader = await openReader({runtime, grammar})   // the bytes of two .wasm files, fetched or read by the caller
/// const module = reader.read(text)                      // never throws, whatever the text
/// ```
///
/// `module.pieces` holds the file in order; their slices joined are the file. A definition has its model (`declaration`), or a raw
/// one with its exact text and the reason why blocks cannot say it. Nothing here touches the DOM, the network or a clock.

import {Language, Parser} from "web-tree-sitter"
import {Reader} from "./module.ts"

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

export type {Range} from "./lexer.ts"
export type {Module, Piece} from "./module.ts"
export {Reader} from "./module.ts"
export type {Cause} from "./reasons.ts"
export {causeOf, reasons} from "./reasons.ts"
