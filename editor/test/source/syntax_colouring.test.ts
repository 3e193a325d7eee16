/// The colour of every word: by the syntax tree and the blocks once they have read the text, and the same during typing elsewhere.

import {readFileSync} from "node:fs"
import {createRequire} from "node:module"
import {tokens} from "@rosy/codegen"
import {openReader} from "@rosy/codegen/reader"
import {describe, expect, it} from "vitest"
import {readHaskell} from "../../src/controller/document/document_conversion.ts"
import {classOf, paletteOf} from "../../src/views/source/syntax_colouring.ts"

const require = createRequire(import.meta.url)
const reader = await openReader({
  runtime: readFileSync(require.resolve("web-tree-sitter/web-tree-sitter.wasm")),
  grammar: readFileSync(require.resolve("tree-sitter-haskell/tree-sitter-haskell.wasm")),
})

/// Each word that has a colour, with it.
function colours(text: string): readonly string[] {
  const palette = paletteOf(readHaskell(reader, "", text).document.program)
  return tokens(text).flatMap(token => {
    const word = text.slice(token.start, token.end)
    const name = classOf(token, word, palette.at(token.start, word))
    return ["comment", "keyword", "operator"].includes(token.kind) || name === null
      ? []
      : [`${word} ${name.replaceAll("hs-", "")}`]
  })
}

describe("the colour of a word", () => {
  it("is that of its block: definitions, binders and uses too", () => {
    expect(
      colours(
        "accelerate :: Velocity -> Velocity\naccelerate (Velocity vl va) = Velocity (vl + 0.5) va\n\nmain = simulate accelerate\n",
      ),
    ).toEqual([
      "accelerate defined state",
      "Velocity state",
      "Velocity state",
      "accelerate defined state",
      "Velocity state",
      "vl number",
      "va number",
      "Velocity command",
      "vl number",
      "0.5 number",
      "va number",
      "main defined task",
      "simulate task",
      "accelerate state",
    ])
  })

  it("tells types, their variables, constructors and fields apart, on as many lines as they take", () => {
    expect(
      colours(
        "data Pair a = Pair {left :: a, right :: Int}\n\nboth\n  :: Pair a\n  -> a\nboth (Pair {left = x}) = x\n",
      ),
    ).toEqual([
      "Pair own",
      "a variable",
      "Pair own",
      "left own",
      "a variable",
      "right own",
      "Int number",
      "both defined own",
      "Pair own",
      "a variable",
      "a variable",
      "both defined own",
      "Pair own",
      "left own",
      "x own",
      "x own",
    ])
  })

  it("is there in a definition that is broken", () => {
    const broken = colours("play :: Bumper -> Maybe Sound\nplay (Bumper _ Pressed = Just ErrorSound\n")
    expect(broken.slice(0, 4)).toEqual(["play defined", "Bumper event", "Maybe memory", "Sound command"])
    expect(broken.slice(-2)).toEqual(["Just memory", "ErrorSound command"])
  })
})
