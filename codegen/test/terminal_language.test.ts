/// The language of `to-haskell` and `to-blocks`: the locale's, and nothing in them bypasses the tables.

import {afterEach, describe, expect, test} from "vitest"
import {en} from "../../languages/en/blocks/index.ts"
import registered from "../../languages/languages.json"
import {commands, toBlocks} from "../src/commands.ts"
import {speakAsTerminal, terminalLanguage} from "../src/terminal_language.ts"
import {speak, words} from "../src/words/index.ts"
import {testReader} from "./reader/open.ts"

afterEach(() => speak(en))

describe("the language of a terminal", () => {
  test.each([
    [{LC_ALL: "de_DE.UTF-8"}, "de"],
    [{LC_ALL: "", LANG: "pt_BR"}, "pt"],
    [{ROSY_LOCALE: "fr_FR@euro", LC_ALL: "C.UTF-8"}, "fr"],
    [{LC_ALL: "C.UTF-8"}, "c"],
    [{}, ""],
  ])("is that of %j", (environment, language) => {
    expect(terminalLanguage(environment)).toBe(language)
  })

  test.each([
    ["de_DE", "p.rosy lässt sich nicht lesen."],
    ["es_ES", "No se puede leer p.rosy."],
    ["fr_FR", "Impossible de lire p.rosy."],
    ["pt_BR", "Não dá para ler p.rosy."],
    ["C", "Cannot read p.rosy."],
    ["xx", "Cannot read p.rosy."],
  ])("in %s words what a command says", (locale, said) => {
    speakAsTerminal({LC_ALL: locale})
    const fail = () => {
      throw new Error("gone")
    }
    expect(commands("to-haskell", ["p.rosy"], fail).err).toBe(said)
  })
})

test("every language of the words has its table in a terminal", () => {
  for (const name of Object.keys(registered)) {
    speak(en)
    speakAsTerminal({LC_ALL: name})
    expect(words === en, name).toBe(name === "en")
  }
})

test("what stays as text is named with its reason in the language", async () => {
  const reader = await testReader()
  speakAsTerminal({LC_ALL: "de_DE"})
  const made = toBlocks("p", Buffer.from("type family A a\n"), reader)
  expect(made.err).toContain("bleibt Text. Typen, die aus Typen berechnet werden.")
})
