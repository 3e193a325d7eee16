/// What the files of the diagram need: colours that every program knows, and the fonts of the characters in it.

import {describe, expect, it} from "vitest"
import {covers} from "../../src/views/diagram/drawing/font_faces.ts"
import {plainColour} from "../../src/views/diagram/drawing/picture.ts"

describe("a colour in a file", () => {
  it.each([
    ["color(srgb 0.9 0.95 1)", "#e6f2ff"],
    ["color(srgb 0 1e-7 1.0001)", "#0000ff"],
    ["rgb(28, 34, 48)", "rgb(28, 34, 48)"],
    ["none", "none"],
  ])("%s is %s", (mixed, plain) => {
    expect(plainColour(mixed)).toBe(plain)
  })
})

describe("a font is needed", () => {
  const characters = (text: string) => new Set([...text].map(one => one.codePointAt(0) ?? 0))
  it.each([
    ["U+0-FF, U+131", "bump", true],
    ["U+0-FF, U+131", "ы", false],
    ["U+4??", "ы", true],
    ["U+2192", "a → b", true],
    ["", "a", true],
    ["", "", false],
  ])("with the range %j for %j: %s", (range, text, isNeeded) => {
    expect(covers(range, characters(text))).toBe(isNeeded)
  })
})
