/// Renaming in the text: all places that mean the same, no other, and nothing else is touched.

import {readFileSync} from "node:fs"
import {createRequire} from "node:module"
import {openReader, type Reader} from "@rosy/codegen/reader"
import {beforeAll, describe, expect, it} from "vitest"
import {readHaskell} from "../../src/desk/programs.ts"
import {renamed} from "../../src/desk/rename.ts"

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
const rename = (old: string, name: string, which = 0) => {
  const at = [...text.matchAll(new RegExp(`\\b${old}\\b`, "g"))][which]?.index ?? -1
  return renamed(readHaskell(reader, "x", text).document, at, old, name)
}

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
  it.each([
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
