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

export interface Mutation {
  readonly at: number
  readonly remove: number
  readonly insert: string
}

/// Up to a few small changes at random places; a place is a share of the text's length.
export const mutations: fc.Arbitrary<readonly Mutation[]> = fc.array(
  fc.record({
    at: fc.double({min: 0, max: 1, noNaN: true}),
    remove: fc.oneof({weight: 3, arbitrary: fc.constant(0)}, fc.integer({min: 1, max: 12})),
    insert: fc.oneof(
      {weight: 1, arbitrary: fc.constant("")},
      {weight: 3, arbitrary: fc.constantFrom(...snippets)},
    ),
  }),
  {minLength: 1, maxLength: 4},
)

export function mutate(text: string, all: readonly Mutation[]): string {
  return all.reduce((t, m) => {
    const at = Math.floor(m.at * t.length)
    return t.slice(0, at) + m.insert + t.slice(at + m.remove)
  }, text)
}
