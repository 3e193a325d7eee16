/// Operators that are symbols of Unicode, and the signs of the extension UnicodeSyntax: read as GHC reads them.

import {beforeAll, expect, test} from "vitest"
import {reasons} from "../../src/model/raw_reasons.ts"
import type {Reader} from "../../src/reader/index.ts"
import {openView} from "../../src/reader/index.ts"
import {testReader} from "./open.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

const blocksOf = (text: string) => JSON.stringify(openView(reader, text).declarations.map(d => d.block))
const using = (o: string) => `a ${o} b = a\n\nx = 1 ${o} 2\n\ny = (${o} 2)\n\n(z) = (${o})\n`

// One of each kind of symbol, and each sign that the grammar reserves.
const operators = [..."★→←⇒∷∀⤙⤚⤛⤜", ..."⊕∘≤×÷·…−€¬✓√∈‼♥⟵¤°–", "★★", "+★", "★+", "→→", "∷∷", "-→"]

test.each(operators)("%s is an operator", o => {
  const blocks = blocksOf(using(o))
  expect(blocks).not.toContain(reasons.broken)
  expect(blocks).not.toContain(reasons.lonely)
})

test.each([...operators.filter(o => !/^[∷⇒→←★∀⤙⤚⤛⤜]$/.test(o))])("%s is an operator in blocks", o => {
  expect(blocksOf(`a ${o} b = a\n\nx = 1 ${o} 2\n`)).not.toContain("raw_")
})

test("each sign of UnicodeSyntax makes the blocks of what it stands for", () => {
  const ascii = [
    "f :: forall a. Show a => a -> String",
    "f x = g (\\y -> show y) x",
    "",
    "h :: Task ()",
    "h = do",
    "  n <- pure (1 :: Int)",
    "  say (show n)",
  ].join("\n")
  const signs: [RegExp, string][] = [
    [/::/g, "∷"],
    [/forall/g, "∀"],
    [/=>/g, "⇒"],
    [/->/g, "→"],
    [/<-/g, "←"],
  ]
  const unicode = signs.reduce((text, [sign, by]) => text.replace(sign, by), ascii)
  const head = "{-# LANGUAGE UnicodeSyntax, ExplicitForAll #-}\n\n"
  const withoutIds = (blocks: string) => blocks.replace(/"(?:id|x|y)":[^,}]*,?/g, "")
  expect(withoutIds(blocksOf(head + unicode))).toBe(withoutIds(blocksOf(head + ascii)))
})

// Mathematical letters are surrogate pairs in UTF-16.
test.each(["𝛼 = 1\n", "f𝛼 = g 𝛼\n", "data 𝐀 = 𝐁 Int | B𝐜\n", "f (𝐀 x𝐲) = 𝓍\n", "x𠀀 = 𠀀\n", "x𝟏𝟐y = x𝟏\n"])(
  "letters beyond the first 65,536 characters are letters: %s",
  text => {
    const {pieces} = reader.read(text)
    expect(pieces.some(p => p.broken)).toBe(false)
    expect(pieces.map(p => p.slice).join("")).toBe(text)
    expect(JSON.stringify(pieces.map(p => p.declaration))).not.toContain('"raw')
  },
)

test("a star of one's own is an operator where UnicodeSyntax is on", () => {
  const head = "{-# LANGUAGE UnicodeSyntax #-}\n"
  for (const text of ["a ★ b = a\n\nx ∷ Int → Int\nx y = y ★ 2\n", "x = (★ 2)\n", "(★) = f\n"])
    expect(
      reader
        .read(head + text)
        .pieces.filter(p => p.broken)
        .map(p => p.slice),
      text,
    ).toEqual([])
})

test("one type for several operators is called so, also above the first one's equation", () => {
  for (const [one, other] of ["⊕⊗", ["+++", "***"]] as const) {
    const {pieces} = reader.read(
      `(${one}), (${other}) :: Int -> Int -> Int\na ${one} b = a\na ${other} b = b\n`,
    )
    const declarations = pieces.flatMap(p => p.declaration ?? [])
    expect(declarations.map(d => d.kind)).toEqual(["raw-declaration", "function", "function"])
    expect(declarations[0]).toMatchObject({reason: reasons.names})
  }
})

test("switching UnicodeSyntax on and off reads the unchanged definitions again", () => {
  const body = "f ∷ Int → Int\nf x = x\n"
  const head = "{-# LANGUAGE UnicodeSyntax #-}\n"
  const on = () =>
    reader
      .read(head + body)
      .pieces.filter(p => p.kind === "declaration")
      .map(p => p.broken)
  const first = on()
  reader.read(body)
  expect(on()).toEqual(first)
})
