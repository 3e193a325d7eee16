/// A browser whose storage is full: nothing that the page does there throws, and what is not kept is said.

import {readdirSync, readFileSync} from "node:fs"
import {afterEach, expect, test, vi} from "vitest"
import {createStore} from "../../src/browser/store.ts"
import {storeLessons} from "../../src/controller/lessons/lessons.ts"
import {initialState} from "../../src/state/page_state.ts"
import {tryToStore} from "../../src/storage/browser_storage.ts"
import {memoryStorage} from "../../src/storage/memory_storage.ts"

afterEach(() => void vi.unstubAllGlobals())

const failing = (fault: Error): Storage => ({
  ...memoryStorage(),
  setItem() {
    throw fault
  },
})
const full = () => failing(new DOMException("full", "QuotaExceededError"))

test("a text that there is no room for is not stored, and what was there stays", () => {
  expect(tryToStore(full(), "key", "text")).toBe(false)
  const storage = memoryStorage()
  expect(tryToStore(storage, "key", "text")).toBe(true)
  expect(storage.getItem("key")).toBe("text")
})

test("a fault of the page is not taken for a full storage", () => {
  expect(() => tryToStore(failing(new TypeError("a mistake")), "key", "text")).toThrow(TypeError)
})

/// Where the storage itself may be forbidden, and each way of using it is guarded; and what is no storage of the browser.
const guarded = [
  "storage/browser_storage.ts",
  "storage/memory_storage.ts",
  "browser/preferences.ts",
  "guide/guide.ts",
]

test("no part of the page stores a text in a way that throws when there is no room", () => {
  const root = new URL("../../src/", import.meta.url)
  const files = readdirSync(root, {recursive: true, encoding: "utf8"}).filter(
    file => /\.tsx?$/.test(file) && !guarded.includes(file),
  )
  expect(files.length).toBeGreaterThan(300)
  expect(files.filter(file => readFileSync(new URL(file, root), "utf8").includes(".setItem("))).toEqual([])
})

test("progress in a lesson that is not kept is said, and the learner goes on", () => {
  const frames: (() => void)[] = []
  vi.stubGlobal("requestAnimationFrame", (frame: () => void) => frames.push(frame))
  const store = createStore(() => undefined, {lessons: initialState.lessons})
  storeLessons(store, {shared: full(), tab: full()})
  store.dispatch({kind: "lesson", event: {kind: "progress-replaced", progress: {bump: ["a"]}}})
  for (const frame of frames) frame()
  expect(store.now.notice).toEqual({kind: "progress-not-saved"})
  expect(store.now.lessons.progress).toEqual({bump: ["a"]})
})
