/// Ways to spoil a program, as typing does.

import fc from "fast-check"

const snippets = [
  "(",
  ")",
  "[",
  "]",
  "{",
  "}",
  ",",
  ";",
  "=",
  "|",
  "->",
  "<-",
  "\\",
  '"',
  "'",
  "`",
  "--",
  "{-",
  "-}",
  "where",
  "do",
  "of",
  "let ",
  "in ",
  "if ",
  "then ",
  "case ",
  "data ",
  "x",
  "X",
  "1",
  " ",
  "\n",
  "\n  ",
  "\n\n",
  "\t",
  "\r\n",
  "::",
  "=>",
  "$",
  "@",
  "_",
  "é",
  "名",
  "🤖",
  "\u0000",
  "\uFEFF",
  "\uD800",
  "#",
  "{-#",
  "#-}",
  "$(",
  "[|",
] // prettier-ignore

/// More of the same, in forms and places that are not typed by accident.
const rare = [
  // Comments of every kind.
  "{- a {- nested -} one -}",
  "{- over\n   two lines -}",
  " -- | for Haddock\n",
  "\n-- ^ behind\n",
  "{-| haddock -}",
  "{-# INLINE f #-}",
  "\n{-# ANN f () #-}\n",
  "\n  -- indented\n",
  // Layout by hand, and what may stand on one line.
  "{ ",
  " }",
  " ; ",
  "\n  ;",
  "where { a = 1; b = 2 }",
  "do { x <- y; if x then z else w }",
  "\n    ; then 1\n    ; else 2",
  "\n  then",
  "if | a -> 1\n     | otherwise -> 2",
  "\\case { 1 -> 2; _ -> 3 }",
  // Sections, text over several lines, other alphabets.
  "(subtract 1)",
  "(`f` 2)",
  "(+ -1)",
  '"one\\\n   \\two"',
  "\n\t\t",
  "→",
  "∷",
  "∀",
  "⊕",
  "a ⊕ b",
  "\u00A0",
  "\r",
  "\f",
  "\n> a = 1\n",
  "\n\\begin{code}\n",
  "\n#if 1\n",
  "\ninstance Show A where\n",
  "\nclass C a where\n  m :: a\n",
] // prettier-ignore

export interface Mutation {
  readonly at: number
  readonly remove: number
  readonly insert: string
}

/// Up to a few small changes at random places; a place is a share of the text's length.
const mutationsWith = (all: readonly string[]): fc.Arbitrary<readonly Mutation[]> =>
  fc.array(
    fc.record({
      at: fc.double({min: 0, max: 1, noNaN: true}),
      remove: fc.oneof({weight: 3, arbitrary: fc.constant(0)}, fc.integer({min: 1, max: 12})),
      insert: fc.oneof(
        {weight: 1, arbitrary: fc.constant("")},
        {weight: 3, arbitrary: fc.constantFrom(...all)},
      ),
    }),
    {minLength: 1, maxLength: 4},
  )

export const mutations = mutationsWith(snippets)
export const rareMutations = mutationsWith([...snippets, ...rare])

export function mutate(text: string, all: readonly Mutation[]): string {
  return all.reduce((t, m) => {
    const at = Math.floor(m.at * t.length)
    return t.slice(0, at) + m.insert + t.slice(at + m.remove)
  }, text)
}
