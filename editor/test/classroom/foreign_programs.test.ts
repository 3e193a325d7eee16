/// What a page shows of another class when the service runs a new one.

import {expect, test} from "vitest"
import {openForeignPrograms} from "../../src/classroom/pupil/foreign_programs.ts"
import type {PageOfClass} from "../../src/classroom/pupil/page_of_class.ts"

/// A page that shows the program of an entry, or one without, of which "theirs" belongs to the other class.
function pageWith(shown: string | null) {
  const done: string[] = []
  let id = shown
  const page = {
    store: {onEvent: () => {}, dispatch: () => done.push("lesson closed")},
    loader: {
      storedId: () => id,
      newProgram() {
        id = null
        done.push("new program")
      },
    },
    programStore: {hide: () => {}},
  } as unknown as PageOfClass
  return {done, programs: openForeignPrograms(page, {isForeign: entry => entry === "theirs"})}
}

const replaced = ["new program", "lesson closed"]

test.each([
  ["a program of the other class", "theirs", replaced],
  ["what was opened in the other class and not changed", null, replaced],
  ["a program of no class or of this one", "ours", []],
] as const)("a page that shows %s", (_, shown, expected) => {
  const {done, programs} = pageWith(shown)
  programs.meetClass(true, true)
  expect(done).toEqual(expected)
  expect(programs.takeReplaced()).toBe(true)
  expect(programs.takeReplaced()).toBe(false)
})

test("an example of a page that was no pupil's of the other class stays", () => {
  const {done, programs} = pageWith(null)
  programs.meetClass(true, false)
  expect(done).toEqual([])
})

test("a page that meets its first class keeps what it shows", () => {
  const {done, programs} = pageWith(null)
  programs.meetClass(false, false)
  expect(done).toEqual([])
  expect(programs.takeReplaced()).toBe(false)
})
