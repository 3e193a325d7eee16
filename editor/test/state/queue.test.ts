/// A run that waits for a place: what the page knows and says while the room is full.

import {describe, expect, test} from "vitest"
import {isActive, nextRun, type RunState} from "../../src/state/runs/run_state.ts"
import {words} from "../../src/words/index.ts"

const heard = (state: RunState, message: object): RunState =>
  nextRun(state, {kind: "heard", message: {op: "state", run: 3, ...message} as never})

describe("a run that has no place yet", () => {
  const compiling: RunState = {kind: "compiling", run: 3}
  const queued = heard(compiling, {state: "queued", place: 2})

  test("waits, moves up, compiles and runs", () => {
    expect(queued).toEqual({kind: "queued", run: 3, place: 2})
    const next = heard(queued, {state: "queued", place: 1})
    expect(next).toEqual({kind: "queued", run: 3, place: 1})
    const turn = heard(next, {state: "compiling"})
    expect(turn).toEqual(compiling)
    expect(heard(turn, {state: "running"})).toEqual({kind: "running", run: 3})
  })

  test("goes on after a pause, when it had given its place away", () => {
    const waiting = heard({kind: "running", run: 3}, {state: "queued", place: 1})
    expect(waiting).toEqual({kind: "queued", run: 3, place: 1})
    expect(heard(waiting, {state: "running"})).toEqual({kind: "running", run: 3})
  })

  test("can be stopped, and is lost with the connection", () => {
    expect(isActive(queued)).toBe(true)
    expect(nextRun(queued, {kind: "stop-pressed"})).toEqual({kind: "ended", run: 3, how: "stopped"})
    expect(nextRun(queued, {kind: "lost"})).toEqual({kind: "ended", run: 3, how: "lost"})
  })

  test("does not listen to what is said about another run", () => {
    expect(heard({kind: "compiling", run: 4}, {state: "queued", place: 2})).toEqual({
      kind: "compiling",
      run: 4,
    })
  })

  test("is told where it stands", () => {
    expect([1, 2, 3].map(words.queued)).toEqual([
      "The room is full. Your program is the next to run.",
      "The room is full. One program is before yours.",
      "The room is full. 2 programs are before yours.",
    ])
  })
})
