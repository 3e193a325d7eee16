/// Progress in lessons of pupils who share a browser: each gets what the class stores of them, and nothing of another.

import {afterEach, beforeEach, expect, test, vi} from "vitest"
import {createStore} from "../../src/browser/store.ts"
import {openClassProgress} from "../../src/classroom/pupil/class_progress.ts"
import type {Lesson} from "../../src/lesson_files/lesson.ts"
import type {Progress} from "../../src/lesson_files/progress.ts"
import {initialState} from "../../src/state/page_state.ts"
import {memoryStorage} from "../../src/storage/memory_storage.ts"
import type {PupilRequest} from "../../src/wire/classroom/pupil_messages.generated.ts"

beforeEach(() => void vi.stubGlobal("requestAnimationFrame", () => 1))
afterEach(() => void vi.unstubAllGlobals())

function opened(progress: Progress) {
  const sent: PupilRequest[] = []
  const storage = memoryStorage()
  const store = createStore(() => undefined, {lessons: {...initialState.lessons, progress}})
  const pages = openClassProgress(store, storage, message => sent.push(message) > 0)
  const enters = (classId: string, stored: Progress, token: string | null) => {
    pages.meets(classId)
    const fields = {pupil: 1, nickname: "Ada", words: "a b c", hand: false, programs: []} as const
    pages.entered({op: "entered", ...fields, token, progress: stored}, classId)
    return store.now.lessons.progress
  }
  return {enters, store, sent, pages}
}

const cases: readonly [string, Progress, Progress, string | null, Progress][] = [
  ["a new pupil keeps what was done before joining", {bump: ["a"]}, {}, "t", {bump: ["a"]}],
  ["a pupil on a new device gets what the class has", {chance: ["x"]}, {bump: ["a"]}, "t", {bump: ["a"]}],
  [
    "a pupil who was away has both",
    {bump: ["b"], chance: ["x"]},
    {bump: ["a"]},
    null,
    {bump: ["a", "b"], chance: ["x"]},
  ],
]

test.each(cases)("%s", (_, local, stored, token, expected) => {
  expect(opened(local).enters("7b", stored, token)).toEqual(expected)
})

test("a pupil of another class gets nothing of the first", () => {
  const {enters} = opened({bump: ["a"]})
  enters("7b", {}, "t")
  expect(enters("7c", {}, "t")).toEqual({})
  expect(enters("7b", {bump: ["a"]}, null)).toEqual({bump: ["a"]})
})

test("leaving the class leaves nothing behind", () => {
  const {enters, store, pages} = opened({})
  enters("7b", {bump: ["a"]}, "t")
  pages.left()
  expect(store.now.lessons.progress).toEqual({})
})

test("what the class does not have of the open lesson is sent once", () => {
  const {enters, store, sent} = opened({bump: ["a"]})
  const lesson = {name: "bump", title: "Bump!", steps: [], room: {}} as unknown as Lesson
  store.dispatch({kind: "lesson", event: {kind: "opened", lesson, at: 0, runs: 0}})
  enters("7b", {bump: ["b"]}, null)
  enters("7b", {bump: ["b", "a"]}, null)
  expect(sent).toEqual([{op: "progress", lesson: "bump", title: "Bump!", steps: 0, done: ["b", "a"]}])
})
