/// Branches that functions took at a moment: ranges of the text, blocks, and when they are not told.

import {describe, expect, it} from "vitest"
import {emptyDocument} from "../../src/program/history.ts"
import {initialState, type PageState} from "../../src/state/page_state.ts"
import {addFrame} from "../../src/state/runs/room_state.ts"
import {noBranches, takenBranches} from "../../src/values/taken_branches.ts"
import type {Branch} from "../../src/wire/firing.generated.ts"
import type {FiringShown} from "../../src/wire/page/explanations.generated.ts"

const text = "play True = Red\nplay _ = if late then Red else Black\nhelper 0 = 1\nhelper n = n\n"
const range = (part: string) => ({start: text.indexOf(part), end: text.indexOf(part) + part.length})

const branch = (part: string, name: string, kind: Branch["kind"] = "equation"): Branch => {
  const {start} = range(part)
  const line = text.slice(0, start).split("\n").length
  const column = start - text.lastIndexOf("\n", start - 1)
  return {
    in: [name],
    kind,
    number: 1,
    text: part,
    start: {line, column},
    end: {line, column: column + part.length},
  }
}

const firing = (n: number, time: number, branches: readonly Branch[]): FiringShown => ({
  n,
  time,
  function: "play",
  task: 0,
  cause: {by: "tick", value: "", instant: n, event: null, firing: null},
  took: [],
  gave: [],
  branches,
})

const second = "play _ = if late then Red else Black"

function stateOf(ran: string | null, lookedAt: number | null = null): PageState {
  const spans = [
    {...range("Red"), block: "first result"},
    {...range("if late then Red else Black"), block: "choice"},
    {...range("Black"), block: "black"},
  ]
  const firings = [
    firing(0, 0, [branch("play True = Red", "play")]),
    firing(1, 1, [branch("helper n = n", "helper"), branch(second, "play"), branch("Black", "play", "else")]),
  ]
  const frame = {
    run: 1,
    step: 50,
    time: 1,
    x: 1,
    y: 1,
    theta: 0,
    channels: {},
    fired: ["play"],
    sensed: [],
    boxes: null,
    ghost: null,
    memory: null,
  }
  const room = [
    {...frame, step: 0, time: 0},
    {...frame, firings},
  ].reduce(addFrame, {
    ...initialState.room,
    run: 1,
  })
  return {
    ...initialState,
    valuesShown: true,
    document: {...emptyDocument, program: {...emptyDocument.program, text, spans}},
    room: {...room, lookedAt, source: ran},
  }
}

describe("the branches that were taken", () => {
  it("are those of the latest firing, of the function itself, the outer one first", () => {
    expect(takenBranches(stateOf(text))).toEqual({
      ranges: [range(second), range("Black")],
      blocks: ["choice", "black"],
    })
  })

  it("are those of then when the learner looks back", () => {
    expect(takenBranches(stateOf(text, 0))).toEqual({
      ranges: [range("play True = Red")],
      blocks: ["first result"],
    })
  })

  it("are not told of a text that has changed since, and not when values are not shown", () => {
    expect(takenBranches(stateOf(`${text}-- changed`))).toEqual(noBranches)
    expect(takenBranches({...stateOf(text), valuesShown: false})).toEqual(noBranches)
  })
})
