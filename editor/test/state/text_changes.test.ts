/// Change sets of a text: their result, and the ranges and words that they leave alone.

import {tokens} from "@rosy/codegen"
import fc from "fast-check"
import {describe, expect, it} from "vitest"
import {mapRange} from "../../src/program/program.ts"
import {applyChanges, ChangeSet, changesBetween, unchangedPosition} from "../../src/program/text_changes.ts"

/// Without `'`: it belongs to a word or begins a character, which more than the letters beside it decides. A digit is followed by a
/// blank for the same reason: in `play1a` it belongs to the word, in `(1a` it does not.
const words = fc
  .array(fc.constantFrom("a", "play", "Bumper", " ", "\n", "1 ", "(", "x_", "🤖"), {maxLength: 12})
  .map(some => some.join(""))

describe("the changes between two texts", () => {
  it("turn the one into the other", () => {
    fc.assert(
      fc.property(words, words, words, (a, b, c) => {
        const [old, now] = [a + b + a, a + c + a]
        expect(applyChanges(old, changesBetween(old, now))).toBe(now)
      }),
    )
  })

  it("are several where several places differ, so that the text between them keeps its positions", () => {
    const old = "one two three"
    const changes = changesBetween(old, "(one two three)")
    expect(changes.mapPos(old.indexOf("two"))).toBe("(one ".length)
    expect(unchangedPosition(changes)(5, 8)).toBe(4)
  })

  it("are found within the limit also for long texts that have nothing in common", () => {
    const [old, now] = ["ab\n".repeat(60_000), "cd\n".repeat(50_000)]
    expect(applyChanges(old, changesBetween(old, now))).toBe(now)
  })
})

describe("a range", () => {
  it("moves with the text around it and shrinks with deleted text", () => {
    const map = (old: string, now: string) => mapRange(changesBetween(old, now), {start: 3, end: 5})
    expect(map("ab cd ef", "x ab cd ef")).toEqual({start: 5, end: 7})
    expect(map("ab cd ef", "ab cd efg")).toEqual({start: 3, end: 5})
    expect(map("ab cd ef", "ab ef")).toEqual({start: 3, end: 3})
  })
})

describe("a word", () => {
  it("has the same letters at its old position, also after several edits", () => {
    const edit = fc.record({at: fc.nat(40), length: fc.nat(6), insert: words})
    fc.assert(
      fc.property(words, fc.array(edit, {maxLength: 4}), (old, edits) => {
        let now = old
        let changes = ChangeSet.empty(old.length)
        for (const {at, length, insert} of edits) {
          const from = Math.min(at, now.length)
          const next = ChangeSet.of({from, to: Math.min(from + length, now.length), insert}, now.length)
          now = applyChanges(now, next)
          changes = changes.compose(next)
        }
        const before = new Set(tokens(old).map(({start, end}) => `${start} ${end}`))
        const oldPosition = unchangedPosition(changes)
        for (const {start, end} of tokens(now)) {
          const at = oldPosition(start, end)
          if (at === null) continue
          expect(old.slice(at, at + end - start)).toBe(now.slice(start, end))
          if (tokens(now.slice(start, end))[0]?.kind === "name")
            expect(before).toContain(`${at} ${at + end - start}`)
        }
      }),
    )
  })

  it("that is being written on is another word", () => {
    const oldPosition = (old: string, now: string) => unchangedPosition(changesBetween(old, now))
    expect(oldPosition("play x", "pla x")(0, 3)).toBeNull()
    expect(oldPosition("play x", "play x")(0, 4)).toBe(0)
    expect(oldPosition("play", "play x")(0, 4)).toBe(0)
  })
})
