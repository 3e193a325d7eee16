/// Words of Haskell, told apart; and how little of the text is replaced.

import fc from "fast-check"
import {describe, expect, it} from "vitest"
import {difference} from "../../src/source/difference.ts"
import {tokens} from "../../src/source/lexer.ts"

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

  it("nests block comments, knows that --> is an operator, and never runs past a line in a text", () => {
    expect(kinds("{- a {- b -} c -} x --> y")).toEqual([
      "comment {- a {- b -} c -}",
      "name x",
      "operator -->",
      "name y",
    ])
    expect(kinds('"open\nx')).toEqual(['string "open', "name x"])
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

describe("the difference of two texts", () => {
  it("turns the one into the other", () => {
    fc.assert(
      fc.property(fc.string(), fc.string(), fc.string(), (a, b, c) => {
        const [old, now] = [a + b + a, a + c + a]
        const change = difference(old, now)
        const made = change === null ? old : old.slice(0, change.from) + change.insert + old.slice(change.to)
        expect(made).toBe(now)
      }),
    )
  })
})
