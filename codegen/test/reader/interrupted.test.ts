/// What a definition holds may stand at the margin: quotations of other languages, and lines of the C preprocessor with more of it behind them.
/// Blocks never show a part of such a definition as if it were all.

import {beforeAll, expect, test} from "vitest"
import {reasons} from "../../src/model/raw_reasons.ts"
import type {Reader} from "../../src/reader/index.ts"
import {testReader} from "./open.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

/// Each definition: its first name, and the reason why it is text as a whole. Directives between definitions are left out.
function definitions(text: string): (readonly [name: string, reason: string | undefined])[] {
  return reader
    .read(text)
    .pieces.flatMap(({kind, slice, names, declaration: d}) =>
      kind === "declaration" && !slice.startsWith("#")
        ? [[names[0] ?? "", d?.kind === "raw-declaration" ? d.reason : undefined] as const]
        : [],
    )
}

const page = "page = [html|<!DOCTYPE html>\n<html>\n-- no comment {-\n|]\n"

test("a quotation over lines at the margin belongs to its definition", () => {
  const text = `{-# LANGUAGE QuasiQuotes #-}\n${page}\ng = 1\n`
  expect(definitions(text)).toEqual([
    ["page", undefined],
    ["g", undefined],
  ])
  const [first] = reader.read(text).pieces.filter(piece => piece.kind === "declaration")
  expect(first?.broken).toBe(false)
  expect(first?.slice).toContain("|]")
})

test("without the extension the same signs are a list comprehension", () => {
  expect(
    definitions("f xs = [x|x<-xs]\n\ng a = [y|y<-a] where {b = a}\n\nh = True ||]\n").slice(0, 2),
  ).toEqual([
    ["f", undefined],
    ["g", undefined],
  ])
})

test("a definition that goes on behind a condition of the preprocessor stays text as a whole", () => {
  const text = "{-# LANGUAGE CPP #-}\nf n = g n\n#if X\n    1\n#else\n    2\n#endif\n    3\n\ng = 1\n"
  expect(definitions(text)).toEqual([
    ["f", reasons.directive],
    ["g", undefined],
  ])
  const [whole] = reader.read(text).pieces.filter(piece => piece.kind === "declaration")
  expect(whole?.slice).toMatch(/^f n = g n\n#if[\s\S]*\n {4}3\n+$/)
})

test("the end of the last condition belongs to the definition that it interrupts, and the next condition to none", () => {
  const text = "f n = g n\n#if X\n    1\n#endif\n#if Y\ng = 1\n#endif\n"
  const pieces = reader.read(text).pieces.map(piece => piece.slice)
  expect(pieces[0]).toBe("f n = g n\n#if X\n    1\n#endif\n")
  expect(pieces[1]).toMatch(/^#if Y\n/)
})

test("the signature and the equations before the condition stay text together", () => {
  const text = "f :: Int -> Int\nf 0 = 1\nf n = g n\n#if X\n    1\n#endif\n"
  expect(definitions(text)[0]).toEqual(["f", reasons.directive])
})

test("whole definitions between conditions are blocks", () => {
  const text = "#if X\nf = 1\n#else\nf = 2\n#endif\n\n  -- an indented comment\ng = 1\n"
  expect(definitions(text).map(([, reason]) => reason)).toEqual([undefined, undefined, undefined])
})

test("a condition that is written into a definition is seen at once, and its end as well", () => {
  const [before, with1] = [
    "f n = g n\n\nh = 1\n\ng = 1\n",
    "f n = g n\n#if X\n    1\n#endif\n\nh = 1\n\ng = 1\n",
  ]
  reader.read(before)
  expect(definitions(with1)[0]).toEqual(["f", reasons.directive])
  expect(definitions(with1.replace("    1", "    2"))[0]).toEqual(["f", reasons.directive])
  expect(definitions(before)[0]).toEqual(["f", undefined])
})

test("the end of a quotation that is written later joins its lines", () => {
  const whole = `{-# LANGUAGE QuasiQuotes #-}\n${page}\ng = 1\n`
  reader.read(whole.replace("|]", "|"))
  expect(definitions(whole).map(([name]) => name)).toEqual(["page", "g"])
})
