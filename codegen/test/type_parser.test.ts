/// Types that nobody writes: they are unknown, and reading them needs a bounded stack.

import {expect, test} from "vitest"
import {parseSignature, parseType} from "../src/types/type_parser.ts"

const nested = (levels: number) => `${"[".repeat(levels)}A${"]".repeat(levels)}`
const arrows = (levels: number) => `${"a -> ".repeat(levels)}a`

test.each([
  ["100 brackets", nested(100)],
  ["1,000 arguments", arrows(1000)],
])("a type with %s is read", (_, text) => expect(parseType(text)).toBeDefined())

test.each([
  ["100,000 brackets", nested(100_000)],
  ["100,000 open brackets", "[".repeat(100_000)],
  ["100,000 parentheses", "(".repeat(100_000)],
  ["100,000 arguments", arrows(100_000)],
])("a type with %s is unknown", (_, text) => {
  expect(parseType(text)).toBeUndefined()
  expect(parseSignature(text)).toBeUndefined()
})
