/// Formatting: the printer's layout, and nothing lost.

import {beforeAll, describe, expect, it} from "vitest"
import {formatted, openView, type Reader, workspaceOf} from "../../src/reader/index.ts"
import {hashTree} from "../../src/reader/view/tree_matching.ts"
import {corpus, testReader} from "./open.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

/// The words of a text's lines that are comments, as far as a test can tell without the lexer.
const remarks = (text: string) =>
  (text.match(/(?:^|\s)--+ .*/gm) ?? [])
    .flatMap(line => line.split(/\s+/).filter(w => !/^-*$/.test(w)))
    .sort()

describe("formatting", () => {
  it("lays a definition out as the printer does, and keeps its remarks", () => {
    const text =
      "-- go\nmove  ::   Velocity\nmove=Velocity   0.5    0 -- fast\n\n\n-- alone\n\nmain   = simulate move\n"
    const {text: now, left} = formatted(reader, text)
    expect(left).toBe(0)
    expect(now).toContain("move :: Velocity\n")
    expect(now).toContain("main = simulate move")
    expect(remarks(now)).toEqual(remarks(text))
  })

  it("leaves broken text as it is, and says how much it left", () => {
    const text = "move   = (Velocity 0.5\n\nmain   = simulate move\n"
    expect(formatted(reader, text)).toEqual({text: text.replace("main   =", "main ="), left: 1})
  })

  it("means the same, keeps every remark, and changes nothing the second time, for the corpus", () => {
    for (const {name, text} of corpus) {
      const once = formatted(reader, text).text
      const trees = (t: string) => workspaceOf(openView(reader, t)).blocks.blocks.map(b => hashTree(b))
      expect(trees(once), name).toEqual(trees(text))
      expect(formatted(reader, once).text, name).toBe(once)
    }
  })
})
