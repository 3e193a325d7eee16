/// Words on blocks for values that are chosen from a menu: shown in the language of the page, found by the search, never written into the program.

import {afterEach, expect, test} from "vitest"
import {table as de} from "../../languages/de/blocks/index.ts"
import {en} from "../../languages/en/blocks/index.ts"
import {table as es} from "../../languages/es/blocks/index.ts"
import {table as fr} from "../../languages/fr/blocks/index.ts"
import {table as pt} from "../../languages/pt/blocks/index.ts"
import {blockView} from "../src/blocks/block_registry.ts"
import {choices, valueLabel} from "../src/blocks/spec/constructor_labels.ts"
import {speak} from "../src/words/index.ts"
import {toolbox} from "../src/workspace/toolbox/toolbox.ts"
import {wordsByLanguage} from "./translations.ts"

afterEach(() => speak(en))

const plain = new Set(["Bool", "Ordering"])
const labelled = Object.entries(choices).filter(([type]) => !plain.has(type))

test.each(wordsByLanguage)(
  "each value of the robot has a word of its own on blocks in %s, and its name in the tooltip",
  (_, table) => {
    speak(table)
    for (const [of, {options}] of labelled)
      for (const block of ["choice", "pattern_choice"])
        for (const value of options) {
          const shape = blockView(block)?.shape({of, value})
          const menu = shape?.rows.flat().find(item => item.kind === "menu")
          expect(menu?.value).toBe(value)
          const shown = menu?.options.find(([, name]) => name === value)?.[0] ?? ""
          expect([value, options.includes(shown)]).toEqual([value, false])
          expect(shape?.aria).toContain(shown)
          expect(shape?.tooltip).toContain(value)
        }
  },
)

test("a value without a label is shown by its name", () => {
  expect(valueLabel("Bool", "True")).toBe("True")
  expect(valueLabel("ButtonStatus", "Pressed")).toBe("pressed")
})

test.each([
  [en, ["released", "switched off", "green"]],
  [de, ["losgelassen", "ausgeschaltet", "grün"]],
  [pt, ["solto", "desligado", "verde"]],
  [es, ["suelto", "apagado", "verde"]],
  [fr, ["relâché", "extinction", "vert"]],
] as const)("the words and the names of all values of a menu find its blocks", (table, wanted) => {
  speak(table)
  const also = toolbox("haskell").flatMap(category => category.items.map(item => item.also ?? ""))
  for (const word of [...wanted, "Released", "OffSound", "Green", "Button2"])
    expect([word, also.some(words => words.includes(word))]).toEqual([word, true])
})
