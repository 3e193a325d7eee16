/// Type of a language's table.

import type {Words as WordsOnBlocks} from "@rosy/codegen/words"
import type {Words} from "./index.ts"
import type {Measures} from "./number_formats.ts"
import type {SentenceForms} from "./worker_sentences.ts"

export interface Table {
  /// As `<html lang>` and Intl call it (BCP 47).
  readonly tag: string
  readonly direction: "ltr" | "rtl"
  readonly page: Words
  readonly measures: Measures
  readonly blocks: WordsOnBlocks
  /// The sentences of the worker, where they are not in `languages/<tag>/sentences.json`.
  readonly sentences?: SentenceForms
}
