/// The languages of the page: which there are, which one somebody reads, and how its words are fetched.
///
/// English comes with the page. Another language is a file of its own, which only those who read it load.

import {speak as speakOnBlocks} from "@rosy/codegen/words"
import {speak} from "./index.ts"
import type {Table} from "./table.ts"

/// Those that the menu offers, as their readers call them.
export const languages = {en: "English", de: "Deutsch"} as const

export type Language = keyof typeof languages

/// English with accents, a third longer, and the same from right to left: what still reads as English in them is not
/// in a table. They are for tests and have no place in the menu (Unicode CLDR's names for pseudo-locales).
const pseudo = ["en-XA", "ar-XB"] as const

export type Spoken = Language | (typeof pseudo)[number]

const fetched: Readonly<Record<Exclude<Spoken, "en">, () => Promise<Table>>> = {
  de: async () => (await import("./de/index.ts")).german,
  "en-XA": async () => (await import("./pseudo.ts")).accented,
  "ar-XB": async () => (await import("./pseudo.ts")).mirrored,
}

const isSpoken = (name: string): name is Spoken => name === "en" || Object.hasOwn(fetched, name)
const isOffered = (name: string): name is Language => Object.hasOwn(languages, name)

/// The language for a page: the address says (`?lang=de`), else what was chosen before, else the first that the
/// browser's owner reads, else English.
export function languageFor(search: string, chosen: string | null, read: readonly string[]): Spoken {
  const asked = new URLSearchParams(search).get("lang")
  if (asked !== null && isSpoken(asked)) return asked
  if (chosen !== null && isOffered(chosen)) return chosen
  return read.map(tag => tag.toLowerCase().split("-")[0] ?? "").find(isOffered) ?? "en"
}

/// Speaks a language, before anything is shown. English needs no waiting.
export function use(language: Spoken): Promise<void> | undefined {
  if (language === "en") return undefined
  return fetched[language]().then(table => {
    speak(table.page, table.measures)
    speakOnBlocks(table.blocks)
    document.documentElement.lang = table.tag
    document.documentElement.dir = table.direction
  })
}
