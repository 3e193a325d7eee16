/// Files from the learner's disk: text in each encoding, and what the page reports about anything else.

import {expect, it} from "vitest"
import {contentOf, noticeOf} from "../../src/browser/local_files.ts"
import {noticeText} from "../../src/ui/descriptions.ts"

const file = (...bytes: number[]) => new File([Uint8Array.from(bytes)], "a.hs")

it.each([
  ["UTF-8", [0x67, 0xc3, 0xb6, 0x0d, 0x0a], "gö\r\n"],
  ["UTF-8 with a mark", [0xef, 0xbb, 0xbf, 0x67, 0xc3, 0xb6], "\uFEFFgö"],
  ["UTF-16, little-endian", [0xff, 0xfe, 0x67, 0, 0xf6, 0], "\uFEFFgö"],
  ["UTF-16, big-endian", [0xfe, 0xff, 0, 0x67, 0, 0xf6], "\uFEFFgö"],
])("%s is read with its mark and line ends", async (_, bytes, text) => {
  expect(await contentOf(file(...bytes))).toEqual({kind: "text", text})
})

it.each([
  ["Latin-1", [0x66, 0x0a, 0x67, 0xf6], "a.hs is in the encoding Latin-1, not in UTF-8: see line 2, “gö”."],
  ["Windows-1252", [0x80], "a.hs is in the encoding Windows-1252, not in UTF-8: see line 1, “€”."],
  ["a NUL", [0x66, 0, 0x67], "a.hs does not hold text."],
  ["a control character", [0xff, 0x01], "a.hs does not hold text."],
  ["half a UTF-16 unit", [0xff, 0xfe, 0x67], "a.hs does not hold text."],
])("%s is reported", async (_, bytes, message) => {
  const content = await contentOf(file(...bytes))
  if (content.kind === "text") throw new Error("it is text")
  expect(noticeText(noticeOf("a.hs", content)).message).toBe(message)
})

it.each([
  ["Latin-1", [0x66, 0x0a, 0x67, 0xf6], "f\ngö"],
  ["Windows-1252", [0x22, 0x80, 0x22, 0x0d, 0x0a], '"€"\r\n'],
])("a file in %s can be read as such", async (encoding, bytes, text) =>
  expect(await contentOf(file(...bytes))).toMatchObject({kind: "older-encoding", encoding, text}),
)
