/// Rehearsals of a draft: what is asked of the service, the golden conversations, and what its answers say about the solution and the wrong attempts.

import {readdirSync, readFileSync} from "node:fs"
import {describe, expect, test} from "vitest"
import {
  findingsOf,
  heard,
  isAbout,
  isOver,
  type Rehearsal,
  readAnswer,
  rehearsalOf,
} from "../../src/jobs/rehearsal.ts"
import {initialArguments} from "../../src/lesson_files/check_arguments.ts"
import {editDraft, type LessonDraft, newDraft, withCheck} from "../../src/lesson_files/draft.ts"

const room = {name: "room", size: [6, 4], start: {x: 1, y: 2}}
const begun = newDraft("lesson-1", "en", room, "main = simulate (Velocity 0.1 0)\n")

/// One step, whose check has wrong attempts.
function draft(solution: string | null, wrong: readonly string[]): LessonDraft {
  const asked = editDraft(editDraft(begun, {kind: "step-added", step: "predict"}), {
    kind: "step-added",
    step: "make",
  })
  const step = asked.steps[1]
  if (step === undefined) throw new Error("expected a step")
  const checked = withCheck(asked, step, "moves", initialArguments("moves"))
  const checks = checked.checks.map(check => ({...check, wrong}))
  const whole = editDraft(asked, {kind: "step-changed", at: 1, step: {...checked, checks}})
  return editDraft(whole, {kind: "solution", program: solution})
}

/// The rehearsal after what the service says about each attempt.
const after = (of: LessonDraft, ...said: readonly object[]): Rehearsal =>
  said.reduce((rehearsal: Rehearsal, fields, number) => {
    const read = readAnswer(JSON.stringify({op: "attempt", number, ended: "time", problems: [], ...fields}))
    if (read.kind === "mismatch") throw new Error(read.message)
    return heard(rehearsal, read.value)
  }, rehearsalOf(of))

const done = {passed: true, checks: [{id: "check-1", state: "done"}]}
const missed = {
  passed: false,
  checks: [{id: "check-1", state: "missed", seen: {what: "drove", number: 0.5}}],
}
const problem = {severity: "error", kind: "syntax", message: "No.", hint: "", ghc: ""}
const refused = {passed: false, ended: "refused", checks: [], problems: [problem]}

describe("the rehearsal of a draft", () => {
  test("asks for the solution at the last step that is run, and for each wrong attempt", () => {
    const rehearsal = rehearsalOf(draft("right", ["slow", "still"]))
    expect(rehearsal.attempts).toEqual([
      {kind: "solution", step: 2},
      {kind: "wrong", step: 2, check: 1, place: 1},
      {kind: "wrong", step: 2, check: 1, place: 2},
    ])
    const {attempts, world} = JSON.parse(rehearsal.request)
    expect(world).toEqual(room)
    expect(attempts.map((attempt: {source: string}) => attempt.source)).toEqual(["right", "slow", "still"])
    expect(attempts[0].step).toMatchObject({seconds: 10, checks: [{kind: "moves", id: "check-1"}]})
  })

  test("is over when each attempt was judged, and good when nothing is to be said", () => {
    const of = draft("right", ["slow"])
    expect(isOver(after(of, done))).toBe(false)
    expect(isOver(after(of, done, missed))).toBe(true)
    expect(findingsOf(after(of, done, missed))).toEqual([])
  })

  test("says which check the solution misses, and which wrong attempt passes", () => {
    const seen = {what: "drove", time: null, number: 0.5, name: null}
    expect(findingsOf(after(draft("right", ["slow", "still"]), missed, done, missed))).toEqual([
      {kind: "solution-misses", step: 2, check: 1, seen},
      {kind: "wrong-passes", step: 2, check: 1, place: 1},
    ])
  })

  test("says which program cannot be run, and that a solution is missing", () => {
    expect(findingsOf(after(draft("right", ["slow"]), refused, refused))).toEqual([
      {kind: "solution-broken", step: 2, problem: "No."},
      {kind: "wrong-broken", step: 2, check: 1, place: 1, problem: "No."},
    ])
    const unsolved = rehearsalOf(draft(null, []))
    expect(isOver(unsolved)).toBe(true)
    expect(findingsOf(unsolved)).toEqual([{kind: "no-solution"}])
  })

  test("is out of date when a program, a check or the room has changed, and not when a text has", () => {
    const of = draft("right", ["slow"])
    const rehearsal = rehearsalOf(of)
    expect(isAbout(rehearsal, editDraft(of, {kind: "said", field: "title", text: "Far"}))).toBe(true)
    expect(isAbout(rehearsal, editDraft(of, {kind: "solution", program: "other"}))).toBe(false)
    expect(isAbout(rehearsal, editDraft(of, {kind: "room", room: {...room, size: [7, 4]}}))).toBe(false)
  })
})

const folder = new URL("../../../protocol/goldens/rehearsals/", import.meta.url)

test.each(readdirSync(folder))("the page reads what the service answers: %s", name => {
  const lines = readFileSync(new URL(name, folder), "utf8").trim().split("\n")
  for (const {from, line} of lines.map(text => JSON.parse(text)))
    if (from === "service") expect(readAnswer(JSON.stringify(line)).kind).toBe("ok")
})
