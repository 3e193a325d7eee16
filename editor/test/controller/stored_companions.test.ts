/// The other robots run the programs of the learner as they are stored, also after these were changed.

import {expect, test} from "vitest"
import {followStoredPrograms} from "../../src/controller/programs/stored_companions.ts"
import type {PageEvent} from "../../src/state/page_events.ts"
import {initialState, type PageState} from "../../src/state/page_state.ts"
import type {Companion} from "../../src/state/runs/companions.ts"

const place = {x: 1, y: 1, theta: 0}
const twin: Companion = {...place, program: null}
const square: Companion = {...place, program: {id: "p", name: "Square", text: "old"}}

/// What is dispatched when the page has been in these states, one after the other; the stored program is "new".
function dispatched(...states: readonly Pick<PageState, "saved" | "companions">[]): readonly PageEvent[] {
  const events: PageEvent[] = []
  let hear: (state: PageState) => void = () => {}
  const store = {
    now: initialState,
    onEvent: (heard: (state: PageState) => void) => {
      hear = heard
    },
    dispatch: (event: PageEvent) => events.push(event),
  }
  followStoredPrograms(store, id => (id === "p" ? "new" : null))
  for (const state of states) hear({...initialState, ...state})
  return events
}

test("a robot gets its program again when one was stored", () => {
  const companions = [twin, square]
  expect(dispatched({saved: "changed", companions}, {saved: "saved", companions})).toEqual([
    {
      kind: "companions-stored",
      companions: [twin, {...square, program: {id: "p", name: "Square", text: "new"}}],
    },
  ])
})

test("nothing happens without a change", () => {
  const deleted: Companion = {...place, program: {id: "gone", name: "", text: "old"}}
  expect(dispatched({saved: "saved", companions: [square]})).toEqual([])
  const companions = [twin, deleted]
  expect(dispatched({saved: "changed", companions}, {saved: "saved", companions})).toEqual([])
})
