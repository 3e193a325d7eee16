/// Sentences of explanations, as the page words them: in English the same as in the terminal.

import {readFileSync} from "node:fs"
import {describe, expect, it} from "vitest"
import {table as german} from "../../../languages/de/page/index.ts"
import {en} from "../../../languages/en/page/index.ts"
import {table as spanish} from "../../../languages/es/page/index.ts"
import {table as portuguese} from "../../../languages/pt/page/index.ts"
import {asText, pieces, shortFractions} from "../../src/values/sentence_words.ts"
import {sentence} from "../../src/wire/explanation.generated.ts"
import {measuresOf} from "../../src/words/number_formats.ts"
import {translations} from "../translations.ts"

const golden = new URL("../../../protocol/goldens/explanations.jsonl", import.meta.url)
const lines = readFileSync(golden, "utf8")
  .trim()
  .split("\n")
  .map(line => JSON.parse(line) as {said: object; english: string})

describe("a sentence of an explanation", () => {
  it.each(lines)("$english", line => {
    const shown = pieces(sentence(line.said, ""), en.why, measuresOf("en"))
    expect(asText(shown)).toBe(line.english)
  })

  it("leads to the firing that is its cause", () => {
    const shown = pieces(
      sentence(
        {id: "remembered", type: "Memory Bool", value: "True", since: 3.42, other: "bump", cause: 1},
        "",
      ),
      en.why,
      measuresOf("en"),
    )
    expect(shown).toContainEqual({kind: "cause", text: "bump", firing: 1})
  })

  it.each(translations)("has no empty place in $tag", table => {
    for (const line of lines) {
      const text = asText(pieces(sentence(line.said, ""), table.page.why, table.measures))
      expect(text).not.toMatch(/%\{|``|\*\*\*\*|undefined| {2}/)
    }
  })

  it.each([
    ["Velocity (-0.8200000000000001) 0.0", "Velocity (-0.82) 0.0"],
    ["Seconds 1.2999999999999998", "Seconds 1.3"],
    ["Seconds 1.9999999999999998", "Seconds 2.0"],
    ["Velocity 0.25 1.0e-2", "Velocity 0.25 0.01"],
    ["3.0000000000000004e-2", "0.03"],
    ["Position (-6.1e-5) (-6.1e-6)", "Position (-0.0001) 0.0"],
    ["1.0e7", "1.0e7"],
  ])("shortens %s to %s", (value, short) => {
    expect(shortFractions(value)).toBe(short)
  })

  it.each([
    [german, "Bei 1,02 s: die Stoßstange in der Mitte wurde gedrückt."],
    [portuguese, "Aos 1,02 s, o para-choque do meio foi pressionado."],
    [spanish, "A los 1,02 s: el parachoques central se pulsó."],
  ])("writes numbers as the language does", (table, worded) => {
    const shown = pieces(
      sentence({id: "sensed", time: 1.02, value: "Bumper CenterBumper Pressed"}, ""),
      table.page.why,
      table.measures,
    )
    expect(asText(shown)).toBe(worded)
  })
})
