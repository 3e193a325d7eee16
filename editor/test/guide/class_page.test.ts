/// "Your first class": what it calls a button or a line in italics stands on the pages with exactly this name.

import {existsSync, readFileSync} from "node:fs"
import {describe, expect, test} from "vitest"
import {en} from "../../../languages/en/page/index.ts"
import {translations} from "../translations.ts"

const docs = new URL("../../../docs/", import.meta.url)

/// What the guide puts into a sentence that has a part.
const part = "10:42"

/// Spaces that do not break and typographic apostrophes make no other name.
const plain = (text: string) => text.replaceAll(/[\u00A0\u202F]/g, " ").replaceAll("’", "'")

/// None when the part is a time in seconds, which is written by the browser, or has parts of its own.
function sentenceOf(words: (part: unknown) => unknown): readonly string[] {
  try {
    return [String(words(part))]
  } catch (fault) {
    if (fault instanceof RangeError || fault instanceof TypeError) return []
    throw fault
  }
}

/// All sentences of a table of words.
function sentences(words: unknown): readonly string[] {
  if (typeof words === "string") return [words]
  if (typeof words === "function" && words.length === 1)
    return sentenceOf(words as (part: unknown) => unknown)
  if (typeof words !== "object" || words === null) return []
  return Object.values(words).flatMap(sentences)
}

const namesIn = (page: string) =>
  [...readFileSync(new URL(page, docs), "utf8").matchAll(/(?<![*\w])\*(?!\*)([^*\n]+)\*(?!\*)/g)].map(
    ([, name = ""]) => name,
  )

const classPages: readonly (readonly [page: string, words: object])[] = [
  ["class.md", en],
  ...translations
    .map(table => [`${table.tag}/class.md`, table] as const)
    .filter(([file]) => existsSync(new URL(file, docs))),
]

describe.each(classPages)("%s", (page, words) => {
  const names = namesIn(page)
  test.each([...new Set(names)])("the name *%s* is on a page", name => {
    expect(sentences(words).map(plain)).toContain(plain(name))
  })

  test("names what the English page names", () => {
    expect(names.length).toBe(namesIn("class.md").length)
    expect(names.length).toBeGreaterThan(25)
  })
})
