/// A file keeps the line ends it came with.

import fc from "fast-check"
import {expect, test} from "vitest"
import {asInFile, oneKindOfLine} from "../../src/desk/lines.ts"

const line = fc.string({unit: fc.constantFrom("a", "=", " ", "x"), maxLength: 4})
const file = fc
  .tuple(fc.boolean(), fc.array(fc.tuple(line, fc.constantFrom("\n", "\r\n", "\r\n", "\r"))), line)
  .map(([bom, lines, last]) => (bom ? "\uFEFF" : "") + lines.map(([l, end]) => l + end).join("") + last)
  // A lone `\r` before a `\n` is one end, not two; such a file is another file.
  .filter(text => !text.includes("\r\r\n"))

test("what nobody changed is saved byte for byte", () => {
  fc.assert(
    fc.property(file, text => {
      expect(asInFile(text, oneKindOfLine(text))).toBe(text)
    }),
  )
})

test("the page never sees a foreign line end", () => {
  fc.assert(
    fc.property(file, text => {
      expect(oneKindOfLine(text)).not.toMatch(/\r|^\uFEFF/)
    }),
  )
})

test("an edit changes the words and nothing else", () => {
  fc.assert(
    fc.property(file, fc.array(line, {maxLength: 9}), (text, lines) => {
      const now = lines.join("\n")
      expect(oneKindOfLine(asInFile(text, now))).toBe(now)
    }),
  )
  expect(asInFile("a = 1\r\nb = 2\r\n", "a = 1\nnew\nb = 2\n")).toBe("a = 1\r\nnew\r\nb = 2\r\n")
  expect(oneKindOfLine(asInFile("\ra\n\n", "\n\n"))).toBe("\n\n")
  expect(asInFile("a\r\nb\nc\r\nd\r\n", "a\nB\nc\nd\n")).toBe("a\r\nB\r\nc\r\nd\r\n")
})
