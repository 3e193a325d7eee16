/// Words of the page in the language that was selected at its start.

import type {Translated} from "@rosy/codegen/words"
import {en} from "../../../languages/en/page/index.ts"
import {type Measures, measuresOf} from "./number_formats.ts"

/// What a language says: all that English says, under the same names. One that is missing does not compile.
export type Words = Translated<typeof en>

/// In the chosen language. Read it when something is shown, not when a module is loaded.
export let words: Words = en

/// How the chosen language writes numbers: whoever shows one to a learner asks here. (Haskell has its own way.)
export let measures: Measures = measuresOf("en")

/// Chooses the language, once, before anything is shown.
export function setLanguage(table: Words, numbers: Measures): void {
  words = table
  measures = numbers
}
