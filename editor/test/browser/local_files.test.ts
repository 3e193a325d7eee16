/// What a file from the learner's disk is: text, or something else.

import {expect, it} from "vitest"
import {textIn} from "../../src/browser/local_files.ts"

const bytes = (text: string) => new TextEncoder().encode(text).buffer as ArrayBuffer

it("text is UTF-8 with whatever letters it has", () => {
  expect(textIn(bytes('\uFEFFgrüße = "→"\r\n'))).toBe('\uFEFFgrüße = "→"\r\n')
})

it("what is no UTF-8 or holds a NUL is no text", () => {
  expect(textIn(new Uint8Array([0x6d, 0xff, 0x6e]).buffer)).toBeNull()
  expect(textIn(bytes("main = \0\0simulate\n"))).toBeNull()
})
