/// The lesson of a page that returns to its class after the service ran another one.

import {afterEach, beforeEach, expect, test, vi} from "vitest"
import {createStore} from "../../src/browser/store.ts"
import {openInterruptedLessons} from "../../src/classroom/pupil/interrupted_lessons.ts"
import type {PageOfClass} from "../../src/classroom/pupil/page_of_class.ts"
import type {Lesson} from "../../src/lesson_files/lesson.ts"
import {initialState} from "../../src/state/page_state.ts"

beforeEach(() => void vi.stubGlobal("requestAnimationFrame", () => 1))
afterEach(() => void vi.unstubAllGlobals())

const step = (id: string) => ({id, program: null, watched: null})
const lesson = {
  name: "hello",
  title: "Hello",
  start: "main = simulate (Velocity 0.2 0)\n",
  room: {name: "ring"},
  steps: [step("guess"), step("look")],
} as unknown as Lesson

/// A page at the second step of the lesson, with the program of an entry of the program store or the unchanged one of the lesson.
function pageWith(program: string | null) {
  const store = createStore(() => undefined, initialState)
  const opened: string[] = []
  let id = program
  const loader = {storedId: () => id, openText: (name: string) => opened.push(name)}
  const lessons = openInterruptedLessons({store, loader} as unknown as PageOfClass)
  store.dispatch({kind: "lesson", event: {kind: "opened", lesson, at: 1, runs: 0}})
  const returnsWith = (shown: string | null) => {
    lessons.interrupt("7b")
    store.dispatch({kind: "lesson", event: {kind: "closed"}})
    id = null
    lessons.goOn("7c")
    expect(store.now.lessons.open).toBeNull()
    id = shown
    lessons.goOn("7b")
    return store.now.lessons.open
  }
  return {returnsWith, opened, lessons, store}
}

test.each([
  ["with the pupil's own program, which is shown again", "mine", "mine", []],
  ["with its program, which was not changed", null, null, ["Hello"]],
])("the lesson is open again at its step, %s", (_, program, shown, opening) => {
  const page = pageWith(program)
  expect(page.returnsWith(shown)).toMatchObject({lesson, at: 1})
  expect(page.opened).toEqual(opening)
})

test("a pupil who changed another program last, on another device, goes on with that one", () => {
  expect(pageWith("mine").returnsWith("other")).toBeNull()
})

test("what was open is opened once: a pupil who closes the lesson is not asked back", () => {
  const {returnsWith, store, lessons} = pageWith("mine")
  returnsWith("mine")
  store.dispatch({kind: "lesson", event: {kind: "closed"}})
  lessons.goOn("7b")
  expect(store.now.lessons.open).toBeNull()
})
