/// Languages of the page: the list, the choice for a reader, and loading.
///
/// English is part of the page. Another language is a separate file, loaded only when it is used.

import {speak as speakOnBlocks} from "@rosy/codegen/words"
import registered from "../../../languages/languages.json"
import {setLanguage} from "./index.ts"
import type {Table} from "./language_table.ts"
import {chooseSentences, formsOf, type SentenceForms, type SentenceTable} from "./worker_sentences.ts"

/// Those that the menu offers, as their readers call them.
export const languages: Readonly<Record<string, string>> = registered

/// English with accents, a third longer, and the same from right to left: what still reads as English in them is not
/// in a table. They are for tests and have no place in the menu (Unicode CLDR's names for pseudo-locales).
const pseudo: Readonly<Record<string, () => Promise<Table>>> = {
  "en-XA": async () => (await import("./pseudo_locales.ts")).accented,
  "ar-XB": async () => (await import("./pseudo_locales.ts")).mirrored,
}

/// The tables of the page in other languages, each a file of its own.
const pageTables = import.meta.glob<Table>(
  ["../../../languages/*/page/index.ts", "!../../../languages/en/**"],
  {
    import: "table",
  },
)

/// The sentences of the worker in other languages, each a file of its own.
const sentenceTables = import.meta.glob<SentenceTable>("../../../languages/*/sentences.json", {
  import: "default",
})

/// `null` where the language has no table.
export const sentencesOf = async (language: string): Promise<SentenceForms | null> => {
  const table = await sentenceTables[`../../../languages/${language}/sentences.json`]?.()
  return table === undefined ? null : formsOf(table)
}

const tableOf = (language: string) =>
  pseudo[language] ?? pageTables[`../../../languages/${language}/page/index.ts`]

const isOffered = (name: string) => Object.hasOwn(languages, name)
const isSpoken = (name: string) => isOffered(name) || Object.hasOwn(pseudo, name)

/// The language for a page: the address says (`?lang=de`), else what was chosen before, else the first that the
/// browser's owner reads, else English.
export function languageFor(search: string, chosen: string | null, read: readonly string[]): string {
  const asked = new URLSearchParams(search).get("lang")
  if (asked !== null && isSpoken(asked)) return asked
  if (chosen !== null && isOffered(chosen)) return chosen
  return read.map(tag => tag.toLowerCase().split("-")[0] ?? "").find(isOffered) ?? "en"
}

/// Speaks a language, before anything is shown. English needs no waiting.
export function loadLanguage(language: string): Promise<void> | undefined {
  const table = tableOf(language)
  if (table === undefined) return undefined
  return Promise.all([table(), sentencesOf(language)]).then(([table, sentences]) => {
    setLanguage(table.page, table.measures)
    speakOnBlocks(table.blocks)
    chooseSentences(table.sentences ?? sentences)
    document.documentElement.lang = table.tag
    document.documentElement.dir = table.direction
  })
}
