/// Project files: what is read, what is refused, and in which words.

import fc from "fast-check"
import {describe, expect, test} from "vitest"
import {commands} from "../src/commands.ts"
import {hashOf, newProject, parseProject, saveProject, splitDeclarations} from "../src/index.ts"

const whole = saveProject(newProject("fresh"))
const changed = (change: object) => JSON.stringify({...JSON.parse(whole), ...change})

describe("a project file", () => {
  test("reads back as it was saved", () => {
    const outcome = parseProject(whole)
    expect(outcome.ok && saveProject(outcome.project)).toBe(whole)
  })
  test("keeps settings it does not know", () => {
    const outcome = parseProject(changed({settings: {later: [1]}}))
    expect(outcome.ok && outcome.project.settings).toEqual({later: [1]})
  })
  test("keeps the places of the diagram's nodes, and ignores what is no place", () => {
    const diagram = {go: [10, 20], stop: [-1, 2], turn: "left", back: [1, 2, 3]}
    const layout = {...JSON.parse(whole).layout, diagram}
    const outcome = parseProject(changed({layout}))
    expect(outcome.ok && outcome.notice).toBeUndefined()
    expect(outcome.ok && outcome.project.layout.diagram).toEqual({go: [10, 20]})
    expect(outcome.ok && JSON.parse(saveProject(outcome.project)).layout.diagram).toEqual({go: [10, 20]})
  })
  test.each([
    [
      "a truncated file",
      whole.slice(0, 60),
      "This file is not a whole Rosy project. It may have been cut off; open a copy that was saved completely.",
    ],
    [
      "an empty file",
      "",
      "This file is not a whole Rosy project. It may have been cut off; open a copy that was saved completely.",
    ],
    [
      "another JSON file",
      "[1]",
      "This file is not a Rosy project. A project is a file that Rosy saved, ending in .rosy.",
    ],
    [
      "a file from the future",
      changed({rosy: 7}),
      "This project was saved by a newer Rosy. Its version is 7, and this Rosy reads up to 1; update Rosy to open it.",
    ],
    [
      "a wrong version",
      changed({rosy: "one"}),
      'This file is not a Rosy project. at rosy: expected 1, found "one".',
    ],
    [
      "text that is a number",
      changed({haskell: 3}),
      "This project file is damaged. at haskell: expected text, found 3.",
    ],
    [
      "no text",
      changed({haskell: undefined}),
      "This project file is damaged. at haskell: expected text, found nothing.",
    ],
  ])("that is %s is refused with a sentence", (_, text, sentence) => {
    const outcome = parseProject(text)
    expect(outcome.ok ? "it was read" : `${outcome.message} ${outcome.hint}`).toBe(sentence)
  })
  test("with a damaged layout opens, with a notice that names the place", () => {
    const outcome = parseProject(
      changed({
        layout: {declarations: [{name: "main", hash: "", blocks: {type: "main", inputs: {R0: {block: 3}}}}]},
      }),
    )
    expect(outcome.ok && outcome.notice?.hint).toBe(
      "at layout.declarations.0.blocks.inputs.R0.block: expected a block, found 3.",
    )
    expect(outcome.ok && outcome.project.layout.declarations).toEqual([])
  })

  test.each([
    {type: "main", next: "x"},
    {type: "main", next: {block: null}},
    {type: "main", next: {block: {type: 1}}},
    {type: "main", inputs: {R0: {shadow: 3}}},
    {type: "main", icons: 1},
    {type: "main", icons: {comment: {text: 5}}},
  ])("with the damaged block %j opens without its blocks", blocks => {
    const outcome = parseProject(changed({layout: {declarations: [{name: "main", hash: "", blocks}]}}))
    expect(outcome.ok && outcome.notice?.hint).toMatch(/^at layout\.declarations\.0\.blocks\./)
    expect(outcome.ok && outcome.project.layout.declarations).toEqual([])
  })

  test("never breaks the reader, whatever is in it", () => {
    fc.assert(
      fc.property(
        fc.oneof(
          fc.string(),
          fc.json(),
          fc.json().map(j => changed({layout: JSON.parse(j)})),
        ),
        text => {
          parseProject(text)
        },
      ),
    )
  })
})

describe("to-haskell", () => {
  const run = (text: string) => commands("to-haskell", ["p.rosy"], () => new TextEncoder().encode(text))
  test("prints the text", () =>
    expect(run(whole)).toEqual({out: "main :: IO ()\nmain = simulate _\n", err: "", status: 0}))
  test("takes the text when blocks say something else", () => {
    const {out, status} = run(changed({haskell: "main = simulate ()\n"}))
    expect([out, status]).toEqual(["main = simulate ()\n", 0])
  })
  test("says that loose blocks are lost", () => {
    const outcome = run(changed({layout: {declarations: [], loose: [{type: "number"}]}}))
    expect(outcome).toEqual({
      out: "main :: IO ()\nmain = simulate _\n",
      err: "One loose block belongs to no function and is not in the Haskell.",
      status: 1,
    })
  })
  test("says that a file is damaged", () => expect(run("{").status).toBe(1))
  test("says that a file is not there", () => {
    const fail = () => {
      throw new Error("ENOENT")
    }
    expect(commands("to-haskell", ["p.rosy"], fail)).toEqual({out: "", err: "Cannot read p.rosy.", status: 1})
  })
  test("says how it is called", () => expect(commands("help", [], () => new Uint8Array()).status).toBe(2))
})

describe("cutting text into declarations", () => {
  test("loses nothing", () => {
    const line = fc.constantFrom(
      "f :: Int",
      "f x = 1",
      "  where",
      "    y = 2",
      "",
      "-- note",
      "{- a",
      "-}",
      "data A = B",
      "import X",
      "main = do",
      "x <+> y = 3",
      "\tt",
    )
    fc.assert(
      fc.property(fc.array(line, {maxLength: 15}), fc.constantFrom("\n", "\r\n"), (lines, end) => {
        const text = lines.join(end)
        const pieces = splitDeclarations(text)
        expect(pieces.map(p => text.slice(p.start, p.end)).join("")).toBe(text)
        for (const p of pieces) expect(p.start <= p.from && p.from <= p.to && p.to <= p.end).toBe(true)
      }),
    )
  })
  test("keeps signature, equations and comment together", () => {
    const text = "-- c\nf :: Int -> Int\nf 0 = 1\nf n = n\n  where\n\n    x = 1\n\n-- own\n\ng = 2\n"
    expect(splitDeclarations(text).map(p => [p.name, text.slice(p.from, p.to)])).toEqual([
      ["f", "-- c\nf :: Int -> Int\nf 0 = 1\nf n = n\n  where\n\n    x = 1"],
      ["g", "g = 2"],
    ])
  })
  test("hashes differ when texts do", () => {
    fc.assert(
      fc.property(fc.string(), fc.string(), (a, b) => {
        expect(hashOf(a) === hashOf(b)).toBe(a === b)
      }),
    )
  })
})
