/// What a language brings.

import type {Words as WordsOnBlocks} from "@rosy/codegen/words"
import type {Words} from "./index.ts"
import type {Measures} from "./measures.ts"

export interface Table {
  /// As `<html lang>` and Intl call it (BCP 47).
  readonly tag: string
  readonly direction: "ltr" | "rtl"
  readonly page: Words
  readonly measures: Measures
  readonly blocks: WordsOnBlocks
}
