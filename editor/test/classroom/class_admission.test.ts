/// Admission of a browser that is in the class, also while the service refuses its address for a while.

import {afterEach, beforeEach, expect, test, vi} from "vitest"
import {openMemberships} from "../../src/classroom/messages/membership.ts"
import {openClassAdmission} from "../../src/classroom/pupil/class_admission.ts"
import {memoryStorage} from "../../src/storage/memory_storage.ts"

beforeEach(() => void vi.useFakeTimers())
afterEach(() => void vi.useRealTimers())

function opened(isMember: boolean) {
  const storage = memoryStorage()
  const memberships = openMemberships(storage)
  memberships.setClass("7b")
  if (isMember) memberships.write({token: "t", nickname: "Ada", programs: {}})
  const sent: string[] = []
  const links: string[] = []
  const admission = openClassAdmission(
    memberships,
    message => sent.push(message.op) > 0,
    event => event.kind === "link" && links.push(event.link),
  )
  return {admission, sent, links, memberships}
}

test("a page that too many wrong codes kept out counts as disconnected and asks again after a pause", () => {
  const {admission, sent, links, memberships} = opened(true)
  expect(admission.enter()).toBe(true)
  expect(admission.refused()).toBe(true)
  expect([sent, links]).toEqual([["enter"], ["open", "lost"]])
  vi.runAllTimers()
  expect([sent, links]).toEqual([
    ["enter", "enter"],
    ["open", "lost", "open"],
  ])
  expect(memberships.read()?.nickname).toBe("Ada")
})

test("a wrong code that was typed on a page outside the class is the card's to show", () => {
  const {admission, sent, links} = opened(false)
  expect(admission.enter()).toBe(false)
  expect(admission.refused()).toBe(false)
  vi.runAllTimers()
  expect([sent, links]).toEqual([[], []])
})
