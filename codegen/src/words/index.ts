/// The words of blocks, types and refusals in the language that was chosen at the start.

import {en} from "../../../languages/en/blocks/index.ts"

/// A table of words in another language: the same names, other words; functions take the same pieces.
export type Translated<T> = T extends string
  ? string
  : T extends (...pieces: infer Pieces) => infer Said
    ? (...pieces: Pieces) => Translated<Said>
    : {readonly [Name in keyof T]: Translated<T[Name]>}

/// What a language says: all that English says, under the same names. One that is missing does not compile.
export type Words = Translated<typeof en>

/// In the chosen language. Read it when something is shown, not when a module is loaded.
export let words: Words = en

/// Chooses the language, once, before anything is shown.
export function speak(table: Words): void {
  words = table
}

/// A value made of words, made again when the language is another.
export function perLanguage<T>(make: () => T): () => T {
  let made: {readonly of: Words; readonly value: T} | undefined
  return () => {
    if (made?.of !== words) made = {of: words, value: make()}
    return made.value
  }
}
