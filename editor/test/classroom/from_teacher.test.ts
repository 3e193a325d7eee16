/// What comes from the teacher on a pupil's page, over losses of the connection: something sent, and "eyes up". And the invitation of the projector.

import {expect, test} from "vitest"
import {readProjectorMessage} from "../../src/classroom/messages/projector_messages.ts"
import {
  type ClassEvent,
  type ClassState,
  firstClassState,
  reduceClass,
} from "../../src/classroom/pupil/class_state.ts"
import type {Handout} from "../../src/wire/classroom/pupil_messages.generated.ts"

const lesson: Handout = {op: "handout", id: "h1", what: "lesson", name: "Bump!", text: "bump"}

const after = (...events: ClassEvent[]): ClassState =>
  events.reduce((state, event) => reduceClass(state, event), firstClassState)
const sent = (handout: Handout): ClassEvent => ({kind: "heard", message: handout})
const later: ClassEvent = {kind: "handout-folded", folded: true}

test("what a pupil does not open now stays, also when it comes again after a reconnection", () => {
  const folded = after(sent(lesson), later, {kind: "link", link: "lost"}, sent(lesson))
  expect([folded.handout?.id, folded.isHandoutFolded]).toEqual(["h1", true])
  const shown = reduceClass(folded, {kind: "handout-folded", folded: false})
  expect([shown.handout?.id, shown.isHandoutFolded]).toEqual(["h1", false])
})

test("something newer is shown, and so is what comes after one that was opened", () => {
  const newer = after(sent(lesson), later, sent({...lesson, id: "h2"}))
  expect([newer.handout?.id, newer.isHandoutFolded]).toEqual(["h2", false])
  const opened = after(sent(lesson), later, {kind: "handout-closed"}, sent({...lesson, id: "h3"}))
  expect([opened.handout?.id, opened.isHandoutFolded]).toEqual(["h3", false])
})

test("a page whose connection is lost goes on, and looks up again when the message comes again", () => {
  const up: ClassEvent = {kind: "heard", message: {op: "attention", message: "Look at me"}}
  expect(after(up).attention).toBe("Look at me")
  expect(after(up, {kind: "link", link: "lost"}).attention).toBeNull()
  expect(after(up, {kind: "link", link: "lost"}, {kind: "link", link: "open"}, up).attention).toBe(
    "Look at me",
  )
})

test("the projector reads how pupils join", () => {
  const invitation = {op: "invitation", code: "7bk3x9", addresses: ["http://192.168.4.1:8080/"]}
  expect(readProjectorMessage(JSON.stringify(invitation))).toEqual({kind: "ok", value: invitation})
})
