/// When the blocks follow an edit of the text: after the frame that shows it, and after the path where one is on its way.

import {afterEach, beforeEach, expect, test, vi} from "vitest"
import {openEditDebounce} from "../../src/controller/document/edit_debounce.ts"
import {ChangeSet} from "../../src/program/text_changes.ts"

const frame = 16

beforeEach(() => {
  vi.useFakeTimers({toFake: ["setTimeout", "clearTimeout", "performance"]})
  vi.stubGlobal("document", {visibilityState: "visible"})
  vi.stubGlobal("requestAnimationFrame", (draw: () => void) => setTimeout(draw, frame))
  vi.stubGlobal("cancelAnimationFrame", (asked: number) => clearTimeout(asked))
})
afterEach(() => {
  vi.useRealTimers()
  vi.unstubAllGlobals()
})

/// A page in which a path is on its way or not; `followed` is how long after the first key the blocks followed, each time.
function page(pending: boolean) {
  const followed: number[] = []
  const path = {isPending: pending}
  const began = performance.now()
  const debounce = openEditDebounce(
    () => {
      debounce.take()
      followed.push(performance.now() - began)
    },
    () => path.isPending,
  )
  const key = () => debounce.typed("x", ChangeSet.empty(1), true)
  const arrives = () => {
    path.isPending = false
    debounce.pathSettled()
  }
  return {debounce, followed, key, arrives}
}

test("the blocks follow after the frame that shows the key", () => {
  const {followed, key} = page(false)
  key()
  vi.advanceTimersByTime(1000)
  expect(followed).toHaveLength(1)
  expect(followed[0]).toBeLessThan(2 * frame)
})

test("where a path is on its way, they follow when it is on the screen", () => {
  const {followed, key, arrives} = page(true)
  key()
  vi.advanceTimersByTime(70)
  arrives()
  expect(followed).toEqual([])
  vi.advanceTimersByTime(1000)
  expect(followed).toEqual([104])
})

test("they do not wait for a path that is long in coming", () => {
  const {followed, key, arrives} = page(true)
  key()
  vi.advanceTimersByTime(1000)
  arrives()
  expect(followed).toEqual([frame + 150])
})

test("while keys follow one another they wait no longer than 0.3 s for a path", () => {
  const {followed, key} = page(true)
  for (let typed = 0; typed < 20; typed++) {
    key()
    vi.advanceTimersByTime(50)
  }
  expect(followed.map(at => Math.round(at / 50))).toEqual([6, 12, 18])
})

test("an update that takes long waits for its pause also when the path has come", () => {
  const {debounce, followed, key, arrives} = page(true)
  debounce.cost(200)
  key()
  vi.advanceTimersByTime(20)
  arrives()
  vi.advanceTimersByTime(1000)
  expect(followed).toEqual([220])
})
