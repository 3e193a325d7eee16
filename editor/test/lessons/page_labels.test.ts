/// A lesson names what the page shows by the page's own words, in every language: a pupil looks for “Knopf 0”, not for “Button 0”.

import {readdirSync, readFileSync} from "node:fs"
import {expect, test} from "vitest"
import type {Table} from "../../src/words/language_table.ts"
import {translations} from "../translations.ts"

const lessons = new URL("../../../examples/lessons/", import.meta.url)
const names = readdirSync(lessons, {withFileTypes: true}).flatMap(entry =>
  entry.isDirectory() ? [entry.name] : [],
)

/// What lessons name: as English texts write it, and where it is in the table of a language.
const named: readonly (readonly [RegExp, (words: Table) => string])[] = [
  [/\bPress Run\b/, ({page}) => page.run],
  [/\bconsole\b/i, ({page}) => page.tabs.console],
  [/\bCharts\b/, ({page}) => page.tabs.charts],
  [/\bDiagram\b/, ({page}) => page.views.diagram],
  [/\bLift in the room\b/, ({page}) => page.lift],
  [/\bButton 0\b/, ({blocks}) => blocks.charts.button0],
]

/// Texts in English and in another language, side by side.
function* pairs(one: unknown, other: unknown): Generator<readonly [string, string]> {
  if (typeof one === "string") yield [one, String(other)]
  else if (typeof one === "object" && one !== null)
    for (const [key, value] of Object.entries(one))
      yield* pairs(value, (other as Record<string, unknown>)?.[key])
}

const read = (name: string, tag: string): unknown =>
  JSON.parse(readFileSync(new URL(`${name}/texts/${tag}.json`, lessons), "utf8"))

test.each(translations)("in $tag", words => {
  const otherwise: string[] = []
  let count = 0
  for (const name of names)
    for (const [english, text] of pairs(read(name, "en"), read(name, words.tag)))
      for (const [pattern, labelOf] of named) {
        if (!pattern.test(english)) continue
        count += 1
        const label = labelOf(words)
        if (!text.toLowerCase().includes(label.toLowerCase()))
          otherwise.push(`${name}: “${text}” without “${label}”`)
      }
  expect(count).toBeGreaterThan(30)
  expect(otherwise).toEqual([])
})
