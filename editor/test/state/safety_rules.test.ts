/// Safety rules: the switch, and what the page says when they override the program.

import {describe, expect, it} from "vitest"
import {reduce} from "../../src/reducers/reducer.ts"
import {readServiceMessage} from "../../src/state/messages/message_decoder.ts"
import type {ServiceMessage} from "../../src/state/messages/messages.ts"
import type {PageEvent} from "../../src/state/page_events.ts"
import {initialState, type PageState} from "../../src/state/page_state.ts"

const hear = (message: ServiceMessage): PageEvent => ({kind: "heard", message})
const after = (state: PageState, ...events: readonly PageEvent[]) =>
  events.reduce((before, event) => reduce(before, event).state, state)
const hello = hear({op: "hello", session: "s"})
const open = after(initialState, hello)
const running = after(open, {kind: "run-pressed"}, hear({op: "state", run: 1, state: "running"}))

describe("the safety rules", () => {
  it("are switched here and at the service", () => {
    const {state, effects} = reduce(open, {kind: "safety-switched", on: true})
    expect(state.safety).toEqual({on: true, since: null})
    expect(effects).toEqual([{kind: "send", message: {op: "safety", on: true}}])
  })

  it("are told to a service that is there again", () => {
    const on = after(open, {kind: "safety-switched", on: true}, {kind: "link-lost"})
    expect(reduce(on, hello).effects).toContainEqual({kind: "send", message: {op: "safety", on: true}})
    expect(reduce(open, hello).effects).not.toContainEqual({kind: "send", message: {op: "safety", on: true}})
  })

  it("are those of the robot that is taken", () => {
    expect(after(open, hear({op: "safety", on: true, override: null})).safety.on).toBe(true)
  })

  it("say on the console when they take over, and on the room until they give way", () => {
    const took = after(running, hear({op: "safety", on: true, override: {run: 1, since: 2.5}}))
    expect(took.safety.since).toBe(2.5)
    expect(took.lines).toEqual([{kind: "safety", text: "", time: 2.5, count: 1}])
    const gave = after(took, hear({op: "safety", on: true, override: null}))
    expect(gave.safety.since).toBeNull()
    expect(gave.lines).toHaveLength(1)
  })

  it("do not write about an older run", () => {
    const took = after(running, hear({op: "safety", on: true, override: {run: 0, since: 2.5}}))
    expect(took.lines).toEqual([])
  })

  it("are read from the service's words", () => {
    const read = (line: object) => readServiceMessage(JSON.stringify(line))
    expect(read({op: "safety", on: true, run: 3, since: 1})).toMatchObject({
      value: {op: "safety", on: true, override: {run: 3, since: 1}},
    })
    expect(read({op: "safety", on: false})).toMatchObject({value: {on: false, override: null}})
    expect(read({op: "safety"})).not.toHaveProperty("value")
  })
})
