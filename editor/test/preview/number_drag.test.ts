/// One undo step for each drag of a number, however long it lasts.

import {expect, it} from "vitest"
import {type Document, emptyDocument} from "../../src/program/history.ts"
import {reduce} from "../../src/reducers/reducer.ts"
import type {PageEvent} from "../../src/state/page_events.ts"
import {initialState} from "../../src/state/page_state.ts"

const documentOf = (text: string): Document => ({...emptyDocument, program: {...emptyDocument.program, text}})
const change = (text: string, at: number): PageEvent => ({
  kind: "program-changed",
  document: documentOf(text),
  by: "blocks",
  at,
})
const begins: PageEvent = {kind: "number-drag", going: true}
const ends: PageEvent = {kind: "number-drag", going: false}

it.each([
  [
    "two slow drags, and a change after them",
    [begins, change("1", 0), change("2", 5000), ends, begins, change("3", 5010), ends, change("4", 5020)],
    ["0", "2", "3"],
  ],
  [
    "a drag right after something was typed",
    [change("1", 0), begins, change("2", 10), change("3", 20), ends],
    ["0", "1"],
  ],
  ["a drag that changes nothing", [begins, ends, change("1", 0)], ["0"]],
] as readonly (readonly [string, readonly PageEvent[], readonly string[]])[])("%s", (_, events, past) => {
  let state = {...initialState, document: documentOf("0")}
  for (const event of events) state = reduce(state, event).state
  expect(state.history.past.map(({program}) => program.text)).toEqual(past)
})
