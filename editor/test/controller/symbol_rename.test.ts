/// Renaming in the text: all places that mean the same, no other, and nothing else is touched.

import {readFileSync} from "node:fs"
import {createRequire} from "node:module"
import {openReader, type Reader} from "@rosy/codegen/reader"
import {beforeAll, describe, expect, it} from "vitest"
import {readHaskell} from "../../src/controller/document/document_conversion.ts"
import {renameSymbol} from "../../src/controller/document/symbol_rename.ts"
import {applyChanges} from "../../src/program/text_changes.ts"

const {resolve} = createRequire(import.meta.url)
let reader: Reader
beforeAll(async () => {
  reader = await openReader({
    runtime: readFileSync(resolve("web-tree-sitter/web-tree-sitter.wasm")),
    grammar: readFileSync(resolve("tree-sitter-haskell/tree-sitter-haskell.wasm")),
  })
})

const text = `-- speed  goes here
drive ::   Double -> Velocity
drive speed = Velocity   (speed + 1) 0 -- speed

turn speed = drive (speed * 2)

data Mode = Go | Stop

light :: Memory Mode -> Led1
light (Memory Go) = Led1 Green
light (Memory mode) = Led1 Red

main = simulate (drive 0.5, light)
`
const renameIn = (program: string, which: number, old: string, name: string) => {
  const at = [...program.matchAll(new RegExp(`\\b${old}\\b`, "g"))][which]?.index ?? -1
  const answer = renameSymbol(readHaskell(reader, "x", program).document, at, old, name)
  return answer.ok ? {ok: true as const, text: applyChanges(program, answer.changes)} : answer
}
const rename = (old: string, name: string, which = 0) => renameIn(text, which, old, name)

describe("renaming", () => {
  it("changes a function in its type, its equations and wherever it is used", () => {
    const answer = rename("drive", "go", 2)
    expect(answer).toEqual({ok: true, text: text.replaceAll("drive", "go")})
  })
  it("changes a local name in its own function only, and no comment", () => {
    const answer = rename("speed", "v", 1)
    expect(answer).toEqual({
      ok: true,
      text: text.replace("drive speed = Velocity   (speed + 1)", "drive v = Velocity   (v + 1)"),
    })
  })
  it("changes a constructor in its type and in patterns", () => {
    expect(rename("Go", "Drive")).toEqual({ok: true, text: text.replaceAll(/\bGo\b/g, "Drive")})
  })
  it("changes a type wherever it is named, and a constructor of the same name apart from it", () => {
    expect(rename("Mode", "State", 1)).toEqual({ok: true, text: text.replaceAll(/\bMode\b/g, "State")})
    const pair =
      "data Pair a b = Pair a b\n\nswap :: Pair a b -> Pair b a\nswap (Pair one other) = Pair other one\n"
    const at = (which: number, old: string, name: string) => renameIn(pair, which, old, name)
    const type =
      "data Two a b = Pair a b\n\nswap :: Two a b -> Two b a\nswap (Pair one other) = Pair other one\n"
    const made =
      "data Pair a b = Two a b\n\nswap :: Pair a b -> Pair b a\nswap (Two one other) = Two other one\n"
    for (const which of [0, 2, 3]) expect(at(which, "Pair", "Two")).toEqual({ok: true, text: type})
    for (const which of [1, 4, 5]) expect(at(which, "Pair", "Two")).toEqual({ok: true, text: made})
    // A variable of types belongs to its definition.
    expect(at(0, "a", "x")).toEqual({
      ok: true,
      text: pair.replace("Pair a b = Pair a b", "Pair x b = Pair x b"),
    })
    expect(at(2, "a", "x")).toEqual({
      ok: true,
      text: pair.replace("Pair a b -> Pair b a", "Pair x b -> Pair b x"),
    })
    expect(at(0, "a", "b").ok).toBe(false)
    expect(at(0, "a", "A").ok).toBe(false)
    expect(at(0, "Pair", "Maybe").ok).toBe(false)
    expect(at(1, "Pair", "Just").ok).toBe(false)
  })
  it.each([
    ["Memory", "Thing", 0, /Memory/],
    ["speed", "drive", 4, /drive/],
    ["drive", "turn", 0, /turn/],
    ["simulate", "run", 0, /simulate/],
    ["drive", "where", 0, /words/],
  ])("refuses %s as %s, and says why", (old, name, which, why) => {
    const answer = rename(old, name, which)
    expect(answer.ok ? answer.text : answer.why).toMatch(why)
    expect(answer.ok).toBe(false)
  })
})
