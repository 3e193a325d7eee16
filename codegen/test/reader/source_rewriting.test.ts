/// Source rewriting: each replacement keeps the length, and the result parses although the source does not.

import {describe, expect, it} from "vitest"
import {grammarVariants} from "../../src/reader/module/source_rewriting.ts"

const variants = (source: string) => grammarVariants(source, [], new Set()).map(v => v.text)

describe("replacements for the grammar", () => {
  const cases: readonly (readonly [what: string, source: string, variants: readonly string[]])[] = [
    ["nothing in plain Haskell", "f x = x + 1", ["f x = x + 1"]],
    ["letters without case", "f 数 = 数", ["f a = a"]],
    ["holes", "f x = _ + x_", ["f x = a + x_"]],
    ["an operator that looks like a splice", "f = g $(h 1)", ["f = g +(h 1)"]],
    ["a negative number in brackets", "f = g (-1)", ["f = g (00)"]],
    ["a negated name in a list", "f = [-x]", ["f = [aa]"]],
    ["the first of negative numbers up to another one", "f = [-1..2]", ["f = [-1..2]"]],
    ["a negative number with a type", "f = -1 :: Int", ["f = -a :: Int"]],
    ["an escaped character", "f = '\\n'", ["f = 0000"]],
    ["a prime that belongs to a name", "f x' = x'", ["f x' = x'"]],
  ]
  it.each(cases)("%s", (_, source, expected) => {
    expect(variants(source)).toEqual(expected)
    for (const text of variants(source)) expect(text).toHaveLength(source.length)
  })

  it("offers names in place of negative numbers before an operator", () => {
    expect(variants("f | -1 `elem` x = 2")).toEqual(["f | -1 `elem` x = 2", "f | -a `elem` x = 2"])
    expect(variants("f | -1 : x = 2")).toEqual(["f | -1 : x = 2", "f | -a : x = 2"])
  })

  it("turns an operator of dashes into one that is no comment", () => {
    expect(grammarVariants("a --> b", [{start: 2, end: 5}], new Set()).map(v => v.text)).toEqual(["a +++ b"])
  })

  it("maps the offsets behind an expanded tab to those of the source", () => {
    const [variant] = grammarVariants("f\t= x", [], new Set())
    expect(variant?.text).toBe("f       = x")
    expect([0, 8, 10, 11].map(at => variant?.place(at))).toEqual([0, 2, 4, 5])
  })
})
