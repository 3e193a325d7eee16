/// The work of inference grows with the program, not with its square. It is counted in members that sets are given: no clock is read.

import {beforeAll, expect, test, vi} from "vitest"
import type {Reader} from "../../src/reader/index.ts"
import {openView, workspaceOf} from "../../src/reader/index.ts"
import {infer} from "../../src/workspace/inference/workspace_inference.ts"
import {testReader} from "../reader/open.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

function workOf(definitions: number): number {
  const text = Array.from({length: definitions}, (_, i) => `f${i} x = g${i} (unread${i} x) + ${i}\n`).join(
    "\n",
  )
  const workspace = workspaceOf(openView(reader, text))
  const add = vi.spyOn(Set.prototype, "add")
  try {
    infer(workspace)
    return add.mock.calls.length
  } finally {
    add.mockRestore()
  }
}

test("definitions with names that are not known cost the same each", () => {
  expect(workOf(200) / workOf(100)).toBeLessThan(2.2)
})
