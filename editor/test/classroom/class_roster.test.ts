/// The roster on both ends: names of a list, and what a page shows whose pupil was removed or renamed, or that stands before a locked door.

import {describe, expect, test} from "vitest"
import {isRosterRefusal, namesIn} from "../../src/classroom/board/board_roster.tsx"
import {type ClassState, firstClassState, reduceClass} from "../../src/classroom/pupil/class_state.ts"
import {refusals} from "../../src/wire/classroom/message_fields.generated.ts"
import type {PupilAnswer} from "../../src/wire/classroom/pupil_messages.generated.ts"
import {words} from "../../src/words/index.ts"

const entered: PupilAnswer = {
  op: "entered",
  pupil: 1,
  nickname: "Ada",
  words: "river lamp garden",
  token: null,
  hand: true,
  programs: [],
  progress: {},
}
const open: ClassState = {...firstClassState, link: "open"}
const after = (...messages: PupilAnswer[]): ClassState =>
  messages.reduce<ClassState>((state, message) => reduceClass(state, {kind: "heard", message}), open)

test.each([
  ["one a line", "Ada\nBen\n", ["Ada", "Ben"]],
  ["of another system, with empty lines and spaces", "\uFEFFAda\r\n\r\n  Ben \rCleo", ["Ada", "Ben", "Cleo"]],
  ["the first column of a table", 'Ada;7b;x\n"Ben",7b\nCleo\t7b', ["Ada", "Ben", "Cleo"]],
  ["a cell in quotation marks", '"Müller; Anna";7b\n"Ben ""B"" L.",7b', ["Müller; Anna", 'Ben "B" L.']],
  ["with spaces inside", "Ada L.\nJosé María", ["Ada L.", "José María"]],
  ["nothing", " \n;\n", []],
])("the names of a list: %s", (_, list, names) => {
  expect(namesIn(list)).toEqual(names)
})

describe("a removed pupil's page", () => {
  test("shows nothing of the class but the sentence, also while the teacher paused all pages", () => {
    const removed = after(
      entered,
      {op: "attention", message: "Look at me"},
      {op: "refused", reason: "removed"},
    )
    expect(removed).toEqual({...firstClassState, link: "open", card: "join", refused: "removed"})
    expect(words.classroom.refused.removed).toContain("taken you out")
  })

  test("can join as another one", () => {
    const joined = after(
      entered,
      {op: "refused", reason: "removed"},
      {...entered, nickname: "Eve", token: "t"},
    )
    expect(joined).toMatchObject({member: {nickname: "Eve"}, card: "words", refused: null})
  })
})

test("a locked door is said on the card, which stays open", () => {
  const before = reduceClass(firstClassState, {kind: "card", card: "join"})
  const locked = reduceClass(before, {kind: "heard", message: {op: "refused", reason: "locked"}})
  expect(locked).toMatchObject({card: "join", refused: "locked", member: null})
  expect(words.classroom.refused.locked).toContain("locked")
})

test("a new name is shown, and the rest stays", () => {
  const before = after(entered)
  expect(after(entered, {op: "renamed", nickname: "Ada L."})).toEqual({
    ...before,
    member: {nickname: "Ada L.", words: "river lamp garden"},
  })
  expect(after({op: "renamed", nickname: "Ada L."}).member).toBeNull()
})

test("the board has a sentence for each name that it cannot take", () => {
  const found = refusals.filter(isRosterRefusal)
  expect(found).toEqual(["taken", "full", "nickname-empty", "nickname-long", "nickname-letters"])
})
