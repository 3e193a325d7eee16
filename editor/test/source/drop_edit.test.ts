/// Where blocks of the toolbox go that are let fall on the text, with the layout that Haskell asks for. `¦` is where the pointer is.

import {readFileSync} from "node:fs"
import {createRequire} from "node:module"
import {codeOf, toolbox} from "@rosy/codegen"
import {openReader} from "@rosy/codegen/reader"
import {describe, expect, it} from "vitest"
import {type Code, dropEdit} from "../../src/views/source/drop_edit.ts"

/// The text after a piece was let fall at `¦`, with what is selected between `«` and `»`.
function put(marked: string, code: Code): string {
  const at = marked.indexOf("¦")
  const {from, to, insert, select} = dropEdit(marked.replace("¦", ""), at, code)
  const text = marked.replace("¦", "")
  const now = text.slice(0, from) + insert + text.slice(to)
  return `${now.slice(0, select.start)}«${now.slice(select.start, select.end)}»${now.slice(select.end)}`
}
const part = (text: string): Code => ({text, as: "part"})
const step = (text: string): Code => ({text, as: "steps"})
const definition = (text: string): Code => ({text, as: "definition"})

describe("a piece that is let fall on the text", () => {
  it.each([
    // At the word under the pointer, with space where there is none.
    ["a = 1 +¦ 2\n", part("x"), "a = 1 + x«» 2\n"],
    ["a = sp¦eed + 1\n", part("x"), "a = x«» speed + 1\n"],
    ["a = ¦\n", part("x"), "a = x«»\n"],
    ["a = f (¦b)\n", part("x"), "a = f (x«» b)\n"],
    // In place of what is open, in brackets where it would come apart.
    ["a = f _¦ b\n", part("g x"), "a = f (g x)«» b\n"],
    ["a = ¦_\n", part("g _ _"), "a = g «_» _\n"],
    ["a = (¦_, b)\n", part("g x"), "a = (g x«», b)\n"],
    ["play (Bumper ¦_ s) = _\n", part("LeftBumper"), "play (Bumper LeftBumper«» s) = _\n"],
    ["a | ¦_ = 1\n", part("x > 1"), "a | (x > 1)«» = 1\n"],
    // Further lines stand below the first.
    ["a = b ¦\n", part("case x of\n  1 -> 2"), "a = b (case x of\n         1 -> 2)«»\n"],
    // Steps have lines of their own.
    ["t = do\n  wait¦ 1\n  say\n", step("move 2\nturn 3"), "t = do\n  wait 1\n  move 2\n  turn 3«»\n  say\n"],
    ["t = do¦\n    say\n", step("move _"), "t = do\n    move «_»\n    say\n"],
    ["t = ¦do\n", step("move 1"), "t = do\n  move 1«»\n"],
    ["t = do say¦ 1\n", step("move 1"), "t = do say 1\n       move 1«»\n"],
    // Definitions stand between definitions, with an empty line around them.
    [
      "a = ¦1\n  where\n\n  x = 2\n\nb = 2\n",
      definition("c = 3"),
      "a = 1\n  where\n\n  x = 2\n\nc = 3«»\n\nb = 2\n",
    ],
    ["a = 1\n¦\nb = 2\n", definition("c = _"), "a = 1\n\nc = «_»\n\nb = 2\n"],
    ["a = 1\nb = 2¦", definition("c = 3"), "a = 1\nb = 2\n\nc = 3«»\n"],
    // Not into a comment, where it would have no effect.
    ["a = f -- of ¦b\n", part("x"), "a = f x«» -- of b\n"],
    ["a = f {- ¦-} b\n", part("x"), "a = f x«» {- -} b\n"],
    ["-- | O¦f b\na = f _ c\n", part("x"), "-- | Of b\na = f x«» c\n"],
    ["-- | O¦f b\na = f -- c", part("x"), "-- | Of b\na = f x«» -- c"],
    ["a = 1 -- b¦", part("x"), "a = 1 x«» -- b"],
    [
      "t = do\n  {- one\n  ¦two -}\n  say\n",
      step("move 1"),
      "t = do\n  {- one\n  two -}\n  move 1«»\n  say\n",
    ],
    ["{- one\n¦\ntwo -}\n\na = 1\n", definition("b = 2"), "{- one\n\ntwo -}\n\nb = 2«»\n\na = 1\n"],
    [
      "a = 1\n  {- one¦\n\ntwo -}\n  + 1\n",
      definition("b = 2"),
      "a = 1\n  {- one\n\ntwo -}\n  + 1\n\nb = 2«»\n",
    ],
    ["¦", definition("c = 3"), "c = 3«»\n"],
    ["\n¦\na = 1\n", definition("c = 3"), "c = 3«»\n\na = 1\n"],
  ] as const)("%j with %j", (text, code, expected) => {
    expect(put(text, code)).toBe(expected)
  })

  it("reads as Haskell, whatever block of the toolbox it is", async () => {
    const {resolve} = createRequire(import.meta.url)
    const reader = await openReader({
      runtime: readFileSync(resolve("web-tree-sitter/web-tree-sitter.wasm")),
      grammar: readFileSync(resolve("tree-sitter-haskell/tree-sitter-haskell.wasm")),
    })
    const places = {
      definition: "a = 1\n¦\nb = 2\n",
      steps: "a = do\n  wait 1¦\n  wait 2\n",
      part: "a = f _¦ b\n",
    }
    for (const {block} of toolbox("haskell").flatMap(category => category.items)) {
      const code = codeOf(block)
      if (code === undefined) continue
      const now = put(places[code.as], code).replace(/[«»]/g, "")
      expect(
        reader
          .read(now)
          .pieces.filter(piece => piece.broken)
          .map(piece => piece.slice),
        code.text,
      ).toEqual([])
    }
  })
})
