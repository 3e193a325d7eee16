/// The demonstration of a first visit: its steps, and that it ends when the learner takes over.

import {afterEach, beforeEach, describe, expect, test, vi} from "vitest"
import {type DemonstratedPage, openDemonstration} from "../../src/controller/demonstration.ts"
import {emptyDocument} from "../../src/program/history.ts"
import {reduce} from "../../src/reducers/reducer.ts"
import type {PageEvent} from "../../src/state/page_events.ts"
import {initialState, type PageState} from "../../src/state/page_state.ts"
import {words} from "../../src/words/index.ts"
import {translations} from "../translations.ts"

beforeEach(() => void vi.useFakeTimers())
afterEach(() => void vi.useRealTimers())

function page() {
  let now: PageState = {...initialState, welcoming: true}
  const seen: string[] = []
  const dispatch = (event: PageEvent) => {
    if (event.kind === "demonstration") seen.push(`step ${event.step}`)
    now = reduce(now, event).state
  }
  const type = (text: string) => {
    now = {...now, document: {...emptyDocument, program: {...emptyDocument.program, text}}}
  }
  const shown: DemonstratedPage = {
    show: text => type(text),
    run: () => {
      seen.push(now.document.program.text.split("\n")[1] ?? "")
      now = {...now, runs: now.runs + 1}
    },
  }
  const store = {
    get now() {
      return now
    },
    dispatch,
  }
  return {store, seen, type, run: shown.run, demonstrate: openDemonstration(store, shown)}
}

describe("the demonstration", () => {
  test("shows each of its steps with a sentence, runs two programs, and asks again how to begin", () => {
    const {store, seen, demonstrate} = page()
    demonstrate()
    vi.runAllTimers()
    expect(seen).toEqual([
      "step 0",
      "step 1",
      "step 2",
      "step 3",
      "drive = Velocity 0.3 0",
      "step 4",
      "drive = Velocity 0.3 1",
      "step null",
    ])
    expect(store.now.welcoming).toBe(true)
    for (const table of [words, ...translations.map(one => one.page)])
      expect(table.welcome.steps).toHaveLength(5)
  })
  test.each(["changes the program", "runs it"])("ends when the learner %s", how => {
    const {store, seen, type, run, demonstrate} = page()
    demonstrate()
    vi.advanceTimersToNextTimer()
    if (how === "runs it") run()
    else type("main = simulate 1")
    const text = store.now.document.program.text
    vi.runAllTimers()
    expect(seen.filter(one => one.startsWith("step"))).toEqual(["step 0", "step 1", "step null"])
    expect(store.now.document.program.text).toBe(text)
  })
  test("ends when it is called again", () => {
    const {store, seen, demonstrate} = page()
    demonstrate()
    demonstrate()
    vi.runAllTimers()
    expect(seen).toEqual(["step 0", "step null"])
    expect(store.now.welcoming).toBe(true)
  })
})
