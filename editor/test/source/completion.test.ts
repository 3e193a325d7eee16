/// The order in which completion offers what fits.

import {describe, expect, it} from "vitest"
import {ranked} from "../../src/views/source/completion.ts"
import type {Suggestion} from "../../src/wire/worker.generated.ts"

/// As CodeMirror shows them before a letter is typed.
const shown = (names: readonly Suggestion[]) =>
  [...ranked(names)]
    .sort((a, b) => (b.boost ?? 0) - (a.boost ?? 0) || ((a.sortText ?? "") < (b.sortText ?? "") ? -1 : 1))
    .map(option => option.label)

describe("what completion offers first", () => {
  it.each([
    [
      "where a Double is wanted",
      [
        {name: "x", type: "Double", takes: 0},
        {name: "angle", type: "Vec -> Radians", takes: 1},
        {name: "atan2", type: "RealFloat a => a -> a -> a", takes: 2},
        {name: "pi", type: "Floating a => a", takes: 0},
        {name: "abs", type: "Num a => a -> a", takes: 1},
      ],
      ["x", "pi", "angle", "abs", "atan2"],
    ],
    [
      "where one of the program's own constructors is",
      [
        {name: "Wild", type: "Mode", takes: 0},
        {name: "Calm", type: "Mode", takes: 0},
        {name: "id", type: "a -> a", takes: 1},
      ],
      ["Wild", "Calm", "id"],
    ],
    [
      "where anything fits: what hardly anybody wants is last",
      [
        {name: "errorWithoutStackTrace", type: "[Char] -> a", takes: 1},
        {name: "undefined", type: "a", takes: 0},
        {name: "head", type: "[a] -> a", takes: 1},
        {name: "foldr", type: "(a -> b -> b) -> b -> t a -> b", takes: 3},
      ],
      ["head", "foldr", "errorWithoutStackTrace", "undefined"],
    ],
    ["where nothing fits", [], []],
  ] as const)("%s", (_, names, expected) => {
    expect(shown(names)).toEqual(expected)
  })
})
