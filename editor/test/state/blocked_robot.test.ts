/// A robot that pushes against something and does not move: what the console says of it.

import {describe, expect, it} from "vitest"
import {reduce} from "../../src/reducers/reducer.ts"
import type {ServiceMessage} from "../../src/state/messages/messages.ts"
import type {PageEvent} from "../../src/state/page_events.ts"
import {initialState, type PageState} from "../../src/state/page_state.ts"

const hear = (message: ServiceMessage): PageEvent => ({kind: "heard", message})
const after = (state: PageState, ...events: readonly PageEvent[]) =>
  events.reduce((before, event) => reduce(before, event).state, state)
const running = after(
  initialState,
  hear({op: "hello", session: "s"}),
  {kind: "run-pressed"},
  hear({op: "state", run: 1, state: "running"}),
)

describe("a robot that pushes against something", () => {
  it.each([
    [true, "bumper"],
    [false, ""],
  ])("is a line of the console with the time (bumped: %s)", (bumped, text) => {
    expect(after(running, hear({op: "blocked", run: 1, time: 4.5, bumped})).lines).toEqual([
      {kind: "blocked", text, time: 4.5, count: 1},
    ])
  })

  it("is none of another run", () => {
    expect(after(running, hear({op: "blocked", run: 7, time: 4.5, bumped: true})).lines).toEqual([])
  })
})
