/// Ways to mend a program, as edits of its text.

import fc from "fast-check"
import {describe, expect, it} from "vitest"
import {emptyDocument, emptyHistory, recordChange} from "../../src/program/history.ts"
import {
  emptyProgram,
  type Fix,
  fixChanges,
  locateProblem,
  mapFix,
  selectionAfterFix,
  signatureFix,
} from "../../src/program/program.ts"
import {applyChanges, changesBetween} from "../../src/program/text_changes.ts"

const fix = (...edits: Fix["edits"]): Fix => ({title: "mend", edits})
const applyFix = (text: string, one: Fix) => applyChanges(text, fixChanges(one, text.length))

describe("a fix", () => {
  it("replaces all its places at once, whatever their order", () => {
    const both = fix({start: 4, end: 5, text: "=="}, {start: 0, end: 1, text: "(a"})
    expect(applyFix("a b = c", both)).toBe("(a b == c")
  })

  it.each([
    ["\nplay _ = _", "the open place", 10],
    ["\nf _ A = _\nf _ B = _", "the first open place", 9],
    [")", "behind what it wrote", 1],
  ])("that writes %j goes on at %s", (text, _, at) => {
    expect(selectionAfterFix(fix({start: 10, end: 10, text})).start).toBe(10 + at)
  })

  it("comes from the worker's lines and columns, which count characters", () => {
    const text = 'say "🤖" x'
    const found = locateProblem(
      {...emptyProgram, text},
      {
        severity: "error",
        kind: "not-in-scope",
        start: {line: 1, column: 9},
        end: {line: 1, column: 10},
        function: null,
        message: "",
        hint: "",
        ghc: "",
        time: null,
        inputs: [],
        sentences: null,
        fixes: [
          {
            title: "Write y",
            sentence: null,
            edits: [{start: {line: 1, column: 9}, end: {line: 1, column: 10}, text: "y"}],
          },
        ],
      },
      "compiler",
    )
    expect(found.fixes.map(f => applyFix(text, f))).toEqual(['say "🤖" y'])
  })

  it("means the same after something else was typed in front of it or behind it", () => {
    const letters = fc.string({unit: fc.constantFrom("a", "b", " ")})
    const digits = fc.string({unit: fc.constantFrom("1", "2"), minLength: 1})
    fc.assert(
      fc.property(letters, letters, letters, digits, (before, inside, behind, typed) => {
        const text = before + inside + behind
        const one = fix({start: before.length, end: before.length + inside.length, text: "X"})
        fc.pre(inside !== "")
        expect(applyFix(typed + text, mapFix(changesBetween(text, typed + text), one))).toBe(
          typed + applyFix(text, one),
        )
        expect(applyFix(text + typed, mapFix(changesBetween(text, text + typed), one))).toBe(
          applyFix(text, one) + typed,
        )
      }),
    )
  })

  it("is a step of its own in the history, however soon it comes", () => {
    const typed = recordChange(emptyHistory, emptyDocument, "haskell", 0)
    const done = recordChange(typed, emptyDocument, "command", 1)
    expect(done.past.length).toBe(2)
    expect(recordChange(done, emptyDocument, "haskell", 2).past.length).toBe(3)
    expect(recordChange(done, emptyDocument, "command", 2).past.length).toBe(3)
  })
})

describe("a signature", () => {
  const text = "-- go\nmove = Velocity 0.5 0\n\nplay :: Bumper -> Sound\nplay _ = OnSound\n"
  const program = {
    ...emptyProgram,
    text,
    definitions: [
      {name: "move", start: text.indexOf("move"), end: text.indexOf("\n\n"), block: "a"},
      {name: "play", start: text.indexOf("play"), end: text.length - 1, block: "b"},
    ],
  }
  const declared = [
    {name: "move", type: "Velocity"},
    {name: "play", type: "Bumper -> Sound"},
  ]
  const at = (offset: number) => signatureFix(program, declared, offset, s => s)
  it("is written above the definition under the cursor, with the type that the compiler found", () => {
    const found = at(10)
    expect(found?.title).toBe("move :: Velocity")
    expect(found && applyFix(text, found)).toBe(text.replace("move =", "move :: Velocity\nmove ="))
  })
  it("is not offered where there is one, where no type is known, or outside", () => {
    expect(at(text.indexOf("OnSound"))).toBeNull()
    expect(at(text.indexOf("\nplay"))).toBeNull()
    expect(signatureFix(program, [], 10, s => s)).toBeNull()
  })
})
