/// The question why a case was not taken, for a block in it.

import {describe, expect, it} from "vitest"
import {emptyDocument} from "../../src/program/history.ts"
import {noQuestion, reduceWhy} from "../../src/state/messages/why_state.ts"
import {initialState} from "../../src/state/page_state.ts"
import {addFrame} from "../../src/state/runs/room_state.ts"
import {caseQuestion, caseQuestionAt} from "../../src/values/untaken_case.ts"
import type {Branch} from "../../src/wire/firing.generated.ts"

const text = "play True = Red\nplay _ = if late then Red else Black\n"
const range = (part: string) => ({start: text.indexOf(part), end: text.indexOf(part) + part.length})

function branch(part: string, kind: Branch["kind"], told = part): Branch {
  const {start} = range(part)
  const line = text.slice(0, start).split("\n").length
  const column = start - text.lastIndexOf("\n", start - 1)
  const end = {line, column: column + part.length}
  return {in: ["play"], kind, number: 1, text: told, start: {line, column}, end}
}

const second = "play _ = if late then Red else Black"
const branches = [
  branch("Black", "else", "late"),
  branch("play True = Red", "equation", "play True"),
  branch(second, "equation", "play _"),
]
const spans = [
  {start: 0, end: text.length - 1, block: "definition"},
  {...range("True"), block: "pattern"},
  {...range("if late then Red else Black"), block: "choice"},
  {...range("Black"), block: "black"},
]

function stateOf({source = text, lookedAt = null as number | null} = {}) {
  const frame = {
    run: 1,
    step: 200,
    time: 4,
    pose: {x: 0, y: 0, theta: 0},
    channels: {},
    fired: [],
    sensed: [],
  }
  const room = {...initialState.room, run: 1, source, branches}
  const shown = {
    ...addFrame(room, {...frame, x: 0, y: 0, theta: 0, boxes: null, memory: null} as never),
    lookedAt,
  }
  const document = {...emptyDocument, program: {...emptyDocument.program, text, spans}}
  return {document, room: shown}
}

const asked = (block: string, options = {}) => caseQuestion(stateOf(options), block)

describe("the question about a case", () => {
  it("is about the innermost one around the block, in the two seconds before the displayed moment", () => {
    const question = asked("black")
    expect(question).toMatchObject({kind: "not-taken", text: "else (late)", since: 2, until: 4})
    expect(asked("choice")).toMatchObject({text: "play _"})
    expect(asked("pattern", {lookedAt: 1})).toMatchObject({text: "play True", since: 0, until: 1})
    expect(question && reduceWhy(noQuestion, {kind: "asked", question}).request).toEqual({
      op: "whyNot",
      id: 1,
      branch: {start: branches[0]?.start, end: branches[0]?.end},
      since: 2,
      until: 4,
    })
  })

  it("is about the one at the cursor in the text", () => {
    expect(caseQuestionAt(stateOf(), text.indexOf("= Red"))).toMatchObject({text: "play True"})
    expect(caseQuestionAt(stateOf(), text.indexOf("late"))).toMatchObject({text: "play _"})
    expect(caseQuestionAt(stateOf(), text.length)).toBeNull()
  })

  it("is not offered where nothing is chosen, nor for another text than the one that runs", () => {
    expect(asked("definition")).toBeNull()
    expect(asked("unknown")).toBeNull()
    expect(asked("black", {source: `${text} `})).toBeNull()
  })
})
