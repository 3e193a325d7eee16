/// Completion requests: one answer in time, one that comes late, and one that nothing waits for any longer.

import {afterEach, beforeEach, expect, it, vi} from "vitest"
import {openCompletions, patience} from "../../src/controller/document/completion_requests.ts"
import type {Request} from "../../src/wire/page/page.generated.ts"
import type {Suggestion} from "../../src/wire/worker.generated.ts"

beforeEach(() => void vi.useFakeTimers())
afterEach(() => void vi.useRealTimers())

const orange: readonly Suggestion[] = [{name: "Orange", type: "LedColor", takes: 0}]

function opened() {
  const sent: number[] = []
  const completions = openCompletions((message: Request) => {
    if (message.op === "complete") sent.push(message.id)
  })
  const answers = (id: number) => completions.heard({op: "completed", id, names: [...orange]} as never)
  return {completions, sent, answers}
}

it("gives the compiler's answer when it comes in time", async () => {
  const {completions, answers} = opened()
  const later = vi.fn()
  const found = completions.fitting("x = ", 4, later)
  answers(1)
  expect((await found)?.names).toEqual(orange)
  expect(later).not.toHaveBeenCalled()
})

it("tells of a late answer once, and gives it to the next request about the same place at once", async () => {
  const {completions, sent, answers} = opened()
  const later = vi.fn()
  const found = completions.fitting("x = ", 4, later)
  vi.advanceTimersByTime(patience)
  expect(await found).toBeNull()
  answers(1)
  answers(1)
  expect(later).toHaveBeenCalledTimes(1)
  expect((await completions.fitting("x = ", 4, later))?.names).toEqual(orange)
  expect(sent).toEqual([1])
})

it("asks the compiler again about another place or text", async () => {
  const {completions, sent, answers} = opened()
  const found = completions.fitting("x = ", 4, () => undefined)
  vi.advanceTimersByTime(patience)
  await found
  answers(1)
  const next = completions.fitting("x = O", 5, () => undefined)
  answers(2)
  expect((await next)?.names).toEqual(orange)
  expect(sent).toEqual([1, 2])
})

it("does not tell of an answer to a request that a newer one has replaced", async () => {
  const {completions, answers} = opened()
  const [first, second] = [vi.fn(), vi.fn()]
  void completions.fitting("x = ", 4, first)
  vi.advanceTimersByTime(patience)
  void completions.fitting("x = O", 5, second)
  answers(1)
  expect(first).not.toHaveBeenCalled()
  expect(second).not.toHaveBeenCalled()
})
