/// Words of Haskell, told apart; and how little of the text is replaced.

import {tokens, tokensAfter} from "@rosy/codegen"
import fc from "fast-check"
import {describe, expect, it} from "vitest"

const kinds = (text: string) => tokens(text).map(t => `${t.kind} ${text.slice(t.start, t.end)}`)

describe("the lexer", () => {
  it("tells the words of a program apart", () => {
    expect(kinds('play (Bumper _ x\') = Just "a\\"b" -- if\n  where _speed = 0.5e3')).toEqual([
      "name play",
      "type Bumper",
      "name _",
      "name x'",
      "operator =",
      "type Just",
      'string "a\\"b"',
      "comment -- if",
      "keyword where",
      "hole _speed",
      "operator =",
      "number 0.5e3",
    ])
  })

  it("nests block comments, knows that --> is an operator, and never runs past a line in a text without a gap", () => {
    expect(kinds("{- a {- b -} c -} x --> y")).toEqual([
      "comment {- a {- b -} c -}",
      "name x",
      "operator -->",
      "name y",
    ])
    expect(kinds('"open\nx')).toEqual(['string "open', "name x"])
  })

  it("goes on with a text behind a gap", () => {
    expect(kinds('"one\\\n  \\two" x')).toEqual(['string "one\\\n  \\two"', "name x"])
    expect(kinds('"one\\\n  two')).toEqual(['string "one', "operator \\", "name two"])
  })

  it("answers for any text, in order and without overlap", () => {
    fc.assert(
      fc.property(fc.string({unit: "grapheme"}), text => {
        let at = 0
        for (const token of tokens(text)) {
          expect(token.start).toBeGreaterThanOrEqual(at)
          expect(token.end).toBeGreaterThan(token.start)
          at = token.end
        }
        expect(at).toBeLessThanOrEqual(text.length)
      }),
    )
  })
})

describe("the lexer after a change", () => {
  const piece = fc.constantFrom(
    "{-",
    "-}",
    "{-#",
    "#-}",
    "--",
    "-->",
    '"',
    "'",
    "\\",
    "\n",
    " ",
    "a",
    "Bc",
    "0x1",
    "1.5e",
    "3",
    "_d",
    "::",
    "(",
    "=",
    "where",
  )
  const source = fc.array(piece, {maxLength: 40}).map(all => all.join(""))
  const share = fc.double({min: 0, max: 1, noNaN: true})

  it("finds what it finds in the whole text", () => {
    fc.assert(
      fc.property(source, source, share, share, (text, put, one, other) => {
        const [from, until] = [Math.round(one * text.length), Math.round(other * text.length)].sort(
          (a, b) => a - b,
        )
        const [start, end] = [from ?? 0, until ?? 0]
        const now = text.slice(0, start) + put + text.slice(end)
        const change = {from: start, to: start + put.length, shift: now.length - text.length}
        expect(tokensAfter(tokens(text), now, change)).toEqual(tokens(now))
      }),
      {numRuns: 2000},
    )
  })
})
