/// Definitions as texts, and what becomes of the program when one of them is written anew.

import {beforeAll, describe, expect, test} from "vitest"
import {definitionEdit, definitionTexts} from "../src/network_edits/index.ts"
import {openView, type Reader} from "../src/reader/index.ts"
import {exampleTexts} from "./generate/network_actions.ts"
import {testReader} from "./reader/open.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

const program = `-- Away from walls.
backOff :: Bumper -> Velocity
backOff _ = _   -- where to?

main :: IO ()
main = simulate backOff -- all of it
`

function edited(text: string, name: string | null, written: string): string {
  const outcome = definitionEdit(reader, openView(reader, text), name, written)
  return outcome.ok ? outcome.text : outcome.refusal.kind
}

test("a definition is read with its comment, and its types are definitions too", () => {
  const texts = definitionTexts(openView(reader, `data Mode = Go | Stop\n\n${program}`))
  expect(texts.map(({name}) => name)).toEqual(["Mode", "backOff", "main"])
  expect(texts[1]?.text).toBe("-- Away from walls.\nbackOff :: Bumper -> Velocity\nbackOff _ = _")
})

test("a definition that is written as it was changes no character of any example", () => {
  for (const [, text] of exampleTexts)
    for (const {name, text: written} of definitionTexts(openView(reader, text)))
      expect(edited(text, name, written)).toBe(text)
})

describe("what is written", () => {
  test("replaces the definition alone", () => {
    expect(edited(program, "backOff", "backOff :: Bumper -> Velocity\nbackOff _ = Velocity 0 0  \n")).toBe(
      program.replace(/-- Away.*\n/, "").replace("= _", "= Velocity 0 0"),
    )
  })
  test("stands before main when it is new, with an empty line on both sides", () => {
    expect(edited("main = simulate _\n", null, "\ntype Hit = Bool\n")).toBe(
      "type Hit = Bool\n\nmain = simulate _\n",
    )
    expect(edited(program, null, "type Hit = Bool")).toBe(
      program.replace("main ::", "type Hit = Bool\n\nmain ::"),
    )
  })
  test("deletes the definition when it is nothing", () => {
    const text = "type Hit = Bool\n\nmain = simulate _\n"
    expect(edited(text, "Hit", " \n")).toBe("main = simulate _\n")
  })
  test("is refused when it is unfinished", () => {
    expect(edited(program, "backOff", "backOff _ = Velocity (0")).toBe("unfinished-text")
    expect(edited(program, null, "data =")).toBe("unfinished-text")
  })
})

test("what is new is shown", () => {
  const outcome = definitionEdit(reader, openView(reader, program), null, "limit :: Double\nlimit = 2")
  expect(outcome.ok && outcome.selects).toBe("limit")
})
