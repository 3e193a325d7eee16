/// Languages of the page: the list, the choice for a reader, and loading.
///
/// English is part of the page. Another language is a separate file, loaded only when it is used.

import {speak as speakOnBlocks} from "@rosy/codegen/words"
import {setLanguage} from "./index.ts"
import type {Table} from "./language_table.ts"
import {chooseSentences, formsOf, type SentenceForms, type SentenceTable} from "./worker_sentences.ts"

/// Those that the menu offers, as their readers call them.
export const languages = {
  en: "English",
  de: "Deutsch",
  pt: "Português (Brasil)",
  es: "Español",
  fr: "Français",
} as const

export type Language = keyof typeof languages

/// English with accents, a third longer, and the same from right to left: what still reads as English in them is not
/// in a table. They are for tests and have no place in the menu (Unicode CLDR's names for pseudo-locales).
const pseudo = ["en-XA", "ar-XB"] as const

export type LocaleTag = Language | (typeof pseudo)[number]

const fetched: Readonly<Record<Exclude<LocaleTag, "en">, () => Promise<Table>>> = {
  de: async () => (await import("./de/index.ts")).german,
  pt: async () => (await import("./pt/index.ts")).portuguese,
  es: async () => (await import("./es/index.ts")).spanish,
  fr: async () => (await import("./fr/index.ts")).french,
  "en-XA": async () => (await import("./pseudo_locales.ts")).accented,
  "ar-XB": async () => (await import("./pseudo_locales.ts")).mirrored,
}

/// The sentences of the worker in other languages, each a file of its own.
const sentenceTables = import.meta.glob<SentenceTable>("../../../protocol/sentences/*.json", {
  import: "default",
})

/// `null` where the language has no table.
export const sentencesOf = async (language: string): Promise<SentenceForms | null> => {
  const table = await sentenceTables[`../../../protocol/sentences/${language}.json`]?.()
  return table === undefined ? null : formsOf(table)
}

const isSpoken = (name: string): name is LocaleTag => name === "en" || Object.hasOwn(fetched, name)
const isOffered = (name: string): name is Language => Object.hasOwn(languages, name)

/// The language for a page: the address says (`?lang=de`), else what was chosen before, else the first that the
/// browser's owner reads, else English.
export function languageFor(search: string, chosen: string | null, read: readonly string[]): LocaleTag {
  const asked = new URLSearchParams(search).get("lang")
  if (asked !== null && isSpoken(asked)) return asked
  if (chosen !== null && isOffered(chosen)) return chosen
  return read.map(tag => tag.toLowerCase().split("-")[0] ?? "").find(isOffered) ?? "en"
}

/// Speaks a language, before anything is shown. English needs no waiting.
export function loadLanguage(language: LocaleTag): Promise<void> | undefined {
  if (language === "en") return undefined
  return Promise.all([fetched[language](), sentencesOf(language)]).then(([table, sentences]) => {
    setLanguage(table.page, table.measures)
    speakOnBlocks(table.blocks)
    chooseSentences(table.sentences ?? sentences)
    document.documentElement.lang = table.tag
    document.documentElement.dir = table.direction
  })
}
