/// Programs that are chosen while others are being loaded, in every order in which their answers arrive: none that the learner chose last is dropped.

import type {Reader} from "@rosy/codegen/reader"
import {afterEach, beforeEach, expect, test, vi} from "vitest"
import type {Store} from "../../src/browser/store.ts"
import {programRequests} from "../../src/controller/program_requests.ts"
import type {Origin, ProgramLoader} from "../../src/controller/programs/program_loader.ts"
import {orderRequests} from "../../src/controller/programs/request_order.ts"
import {emptyDocument} from "../../src/program/history.ts"
import type {ProgramStore} from "../../src/storage/program_store.ts"

/// Answers of the service by example, given when a test calls them.
let answers: Map<string, (found: boolean) => void>

beforeEach(() => {
  answers = new Map()
  vi.stubGlobal("window", {
    location: {hash: "", search: "", href: "http://rosy/"},
    history: {replaceState() {}},
  })
  vi.stubGlobal("fetch", (path: string) => {
    const name = path.replace(/.*\//, "").replace(/\..*/, "")
    return new Promise(resolve => answers.set(name, ok => resolve({ok, text: async () => name})))
  })
})
afterEach(() => vi.unstubAllGlobals())

/// A page whose last program is `last`; `null` for a new learner.
function page(last: string | null) {
  const opened: string[] = []
  const notices: unknown[] = []
  const requests = orderRequests()
  const parts = {reader: null as Reader | null}
  const state = {document: emptyDocument as unknown, notice: null}
  const store = {now: state, dispatch: (event: unknown) => notices.push(event)} as unknown as Store
  const loader = {
    requests,
    openText(_name: string, text: string, {isFirst = false}: Origin = {}) {
      if (!isFirst) requests.choose()
      opened.push(text)
      state.document = {}
    },
  } as unknown as ProgramLoader
  const stored = {
    setLeft() {},
    left: () => null,
    isFirstVisit: () => last === null,
    current: () => (last === null ? null : {id: "1", text: last}),
  } as unknown as ProgramStore
  return {opened, notices, parts, ...programRequests(store, parts, loader, stored)}
}

const settled = () => new Promise<void>(resolve => setImmediate(resolve))

const answer = async (name: string, found = true) => {
  await settled()
  answers.get(name)?.(found)
  await settled()
}

for (const last of ["mine", null])
  for (const order of [
    ["click", "first", "answer"],
    ["first", "click", "answer"],
    ["click", "answer", "first"],
  ])
    test(`an example is open in the end, after ${order.join(", ")}, ${last === null ? "of a new learner" : "with a stored program"}`, async () => {
      const {opened, openExample, openFirst} = page(last)
      for (const step of order) {
        if (step === "click") void openExample("chosen")
        if (step === "first") void openFirst()
        if (step === "answer") await answer("chosen")
        await settled()
      }
      await answer("accelerate")
      expect(opened.at(-1)).toBe("chosen")
    })

test("of two examples the last one is opened, whichever answer comes first", async () => {
  for (const order of [
    ["a", "b"],
    ["b", "a"],
  ]) {
    const {opened, openExample} = page("mine")
    void openExample("a")
    void openExample("b")
    for (const name of order) await answer(name)
    expect(opened).toEqual(["b"])
  }
})

test("the page's first program is opened when the chosen one does not exist", async () => {
  const {opened, notices, parts, openExample, openFirst} = page("mine")
  void openExample("gone")
  parts.reader = {} as Reader
  expect(await openFirst()).toBe("chosen")
  await answer("gone", false)
  expect(opened).toEqual(["mine"])
  expect(notices).toEqual([{kind: "notice", notice: {kind: "example-missing", name: "gone"}}])
})
