/// "Your first class": what it calls a button or a line in italics stands on the pages with exactly this name.

import {readFileSync} from "node:fs"
import {expect, test} from "vitest"
import {en} from "../../src/words/en/index.ts"

const docs = new URL("../../../docs/", import.meta.url)
const guide = readFileSync(new URL("class.md", docs), "utf8")

/// What the guide puts into a sentence that has a part.
const part = "10:42"

/// All sentences of a table of words.
function sentences(words: unknown): readonly string[] {
  if (typeof words === "string") return [words]
  if (typeof words === "function" && words.length === 1) return [String(words(part))]
  if (typeof words !== "object" || words === null) return []
  return Object.values(words).flatMap(sentences)
}

const italics = [...guide.matchAll(/(?<![*\w])\*(?!\*)([^*\n]+)\*(?!\*)/g)].map(([, name = ""]) => name)

test.each([...new Set(italics)])("the name *%s* is on a page", name => {
  expect(sentences(en)).toContain(name)
})

test("the names are found", () => {
  expect(italics).toContain("Hand in")
  expect(italics.length).toBeGreaterThan(25)
})
