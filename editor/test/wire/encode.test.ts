/// Requests with any text are JSON of whole characters.

import {expect, test} from "vitest"
import {encodeRequest} from "../../src/wire/encode.ts"

const texts: {readonly [what: string]: readonly [text: string, sent: string]} = {
  letters: ["åß😀", "åß😀"],
  "a written escape": ["\\ud800", "\\ud800"],
  "a first half alone": ["a\ud83d b", "a\ufffd b"],
  "a second half alone": ["\ude00", "\ufffd"],
  "halves in the wrong order": ["\ude00\ud83d", "\ufffd\ufffd"],
  "a pair between halves": ["\ud800😀\udfff", "\ufffd😀\ufffd"],
}

for (const [what, [text, sent]] of Object.entries(texts))
  test(`${what}: the service gets characters only, at the same places`, () => {
    const json = encodeRequest({op: "check", parts: [{source: text}]})
    expect(JSON.parse(json)).toEqual({op: "check", parts: [{source: sent}]})
    // What no decoder of UTF-8 or JSON refuses.
    expect(new TextDecoder().decode(new TextEncoder().encode(json))).toBe(json)
    expect(json.replaceAll("\\\\", "")).not.toMatch(/\\ud[89a-f]/)
  })
