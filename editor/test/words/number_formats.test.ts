/// Numbers and counted things in each language.

import {expect, test} from "vitest"
import {table as german} from "../../../languages/de/page/index.ts"
import {en} from "../../../languages/en/page/index.ts"
import {table as portuguese} from "../../../languages/pt/page/index.ts"
import {measuresOf} from "../../src/words/number_formats.ts"

test.each([
  ["en", en.blocks, ["0 blocks found", "1 block found", "2 blocks found"]],
  ["de", german.page.blocks, ["0 Blöcke gefunden", "1 Block gefunden", "2 Blöcke gefunden"]],
  ["pt", portuguese.page.blocks, ["0 blocos encontrados", "1 bloco encontrado", "2 blocos encontrados"]],
] as const)("none, one and two are counted in %s", (_, blocks, sentences) => {
  expect([0, 1, 2].map(n => blocks.found(n))).toEqual(sentences)
})

test("numbers have the decimal sign of the language", () => {
  expect(measuresOf("en").metres(1.5)).toBe("1.5 m")
  expect(portuguese.measures.metres(1.5)).toBe("1,5 m")
  expect(portuguese.measures.seconds(0, 2)).toBe("0,00 s")
})
