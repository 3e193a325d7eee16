/// Places of comments in a program that is edited: they follow, and are gone when their text is.

import fc from "fast-check"
import {expect, test} from "vitest"
import {
  lineNumber,
  locateComments,
  locatePlace,
  type PlaceInProgram,
  placeOf,
  quoteOf,
} from "../../src/program/block_comments.ts"
import {emptyProgram, type Program} from "../../src/program/program.ts"

/// Definitions are separated by empty lines; one block covers each of them, and one each number.
function programOf(text: string): Program {
  const definitions = [...text.matchAll(/^(\w+) (?:.+\n?)+/gm)].map(found => {
    const piece = found[0].trimEnd()
    return {
      name: found[1] ?? "",
      start: found.index,
      end: found.index + piece.length,
      block: `def ${found[1]}`,
    }
  })
  const numbers = [...text.matchAll(/\d+(\.\d+)?/g)].map(({0: number, index}) => ({
    start: index,
    end: index + number.length,
    block: `number at ${index}`,
  }))
  return {...emptyProgram, text, definitions, spans: [...definitions, ...numbers]}
}

const before = "f a = Velocity 0.5 0\n\ng b = wait 3\n\nmain = simulate (f, g)\n"
const commented = (text: string, part: string): PlaceInProgram => {
  const program = programOf(text)
  const at = text.indexOf(part)
  const block = program.spans.find(({start, end}) => start === at && end === at + part.length)?.block ?? null
  const place = placeOf(program, block, at)
  if (place === null) throw new Error(`expected a place at ${part}`)
  return place
}
const found = (now: string, place: PlaceInProgram): string | null => {
  const range = locatePlace(programOf(now), place)
  return range === null ? null : now.slice(range.start, range.end)
}

test("a place belongs to its definition", () => {
  expect(commented(before, "0.5")).toEqual({
    definition: "f",
    piece: "f a = Velocity 0.5 0",
    start: 15,
    end: 18,
  })
  expect(commented(before, "g b = wait 3")).toEqual({
    definition: "g",
    piece: "g b = wait 3",
    start: 0,
    end: 12,
  })
  // The cursor in an empty line chooses nothing.
  expect(placeOf(programOf(before), null, before.indexOf("\n\n") + 1)).toBeNull()
})

test("a place follows edits of other parts and of itself", () => {
  const place = commented(before, "0.5")
  for (const [now, text] of [
    [before, "0.5"],
    [`-- new\n\nh c = 0.5\n\n${before}`, "0.5"],
    [before.replace("f a = Velocity", "f :: A -> Velocity\nf anything = Velocity"), "0.5"],
    [before.replace("0.5", "0.25"), "0.25"],
    [before.replace("0.5", "7"), "7"],
    [before.replaceAll("f", "fast"), "0.5"],
    ["main = simulate (f, g)\n\ng b = wait 3\n\nf a = Velocity 0.5 0\n", "0.5"],
  ] as const)
    expect(found(now, place), now).toBe(text)
})

test("a whole definition is found by its name, whatever is in it", () => {
  const place = commented(before, "g b = wait 3")
  expect(found(before.replace("wait 3", "driveStraight 1 2"), place)).toBe("g b = driveStraight 1 2")
})

test("a place is gone with its text", () => {
  expect(found(before.replace(" 3", ""), commented(before, "3"))).toBeNull()
  const place = commented(before, "0.5")
  expect(found("g b = wait 3\n\nmain = simulate g\n", place)).toBeNull()
  expect(found("", place)).toBeNull()
})

test("a line outside of definitions is found by its text", () => {
  const text = `-- my robot\n${before}`
  const place = commented(text, "-- my robot")
  expect(place.definition).toBeNull()
  expect(found(`\n\n${text}`, place)).toBe("-- my robot")
  expect(found(before, place)).toBeNull()
})

test("comments are at the blocks of their places", () => {
  const comment = {id: 1, text: "Too fast", place: commented(before, "0.5")}
  const gone = {id: 2, text: "Why?", place: {...comment.place, definition: "h", piece: "quite another thing"}}
  const [located, ...others] = locateComments(programOf(before), [comment, gone])
  expect(others).toEqual([])
  expect(located).toMatchObject({comment, block: "number at 15"})
  expect(lineNumber(before, located?.range.start ?? 0)).toBe(1)
  expect(quoteOf(`  ${"x".repeat(50)}\ny`)).toBe(`${"x".repeat(39)}…`)
})

test("a located place is a range of the text, after any edit", () => {
  const place = commented(before, "0.5")
  fc.assert(
    fc.property(fc.nat(before.length), fc.nat(20), fc.string(), (from, deleted, inserted) => {
      const now = before.slice(0, from) + inserted + before.slice(from + deleted)
      const range = locatePlace(programOf(now), place)
      if (range === null) return
      expect(range.start).toBeLessThan(range.end)
      expect(range.end).toBeLessThanOrEqual(now.length)
    }),
  )
})
