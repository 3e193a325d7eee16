/// A file keeps the line ends it came with.

import fc from "fast-check"
import {expect, test} from "vitest"
import {normalizeLineEndings, withLineEndingsOf} from "../../src/controller/document/line_endings.ts"

const line = fc.string({unit: fc.constantFrom("a", "=", " ", "x"), maxLength: 4})
const file = fc
  .tuple(fc.boolean(), fc.array(fc.tuple(line, fc.constantFrom("\n", "\r\n", "\r\n", "\r"))), line)
  .map(([bom, lines, last]) => (bom ? "\uFEFF" : "") + lines.map(([l, end]) => l + end).join("") + last)
  // A lone `\r` before a `\n` is one end, not two; such a file is another file.
  .filter(text => !text.includes("\r\r\n"))

test("what was not changed is saved byte for byte", () => {
  fc.assert(
    fc.property(file, text => {
      expect(withLineEndingsOf(text, normalizeLineEndings(text))).toBe(text)
    }),
  )
})

test("the page never sees a foreign line end", () => {
  fc.assert(
    fc.property(file, text => {
      expect(normalizeLineEndings(text)).not.toMatch(/\r|^\uFEFF/)
    }),
  )
})

test("an edit changes the words and nothing else", () => {
  fc.assert(
    fc.property(file, fc.array(line, {maxLength: 9}), (text, lines) => {
      const now = lines.join("\n")
      expect(normalizeLineEndings(withLineEndingsOf(text, now))).toBe(now)
    }),
  )
  expect(withLineEndingsOf("a = 1\r\nb = 2\r\n", "a = 1\nnew\nb = 2\n")).toBe("a = 1\r\nnew\r\nb = 2\r\n")
  expect(normalizeLineEndings(withLineEndingsOf("\ra\n\n", "\n\n"))).toBe("\n\n")
  expect(withLineEndingsOf("a\r\nb\nc\r\nd\r\n", "a\nB\nc\nd\n")).toBe("a\r\nB\r\nc\r\nd\r\n")
})
