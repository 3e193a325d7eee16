/// The study of the class on a pupil's page: what is shown follows the service's messages.

import {describe, expect, it} from "vitest"
import {type ClassState, firstClassState, reduceClass} from "../../src/classroom/pupil/class_state.ts"
import type {PupilAnswer} from "../../src/wire/classroom/pupil_messages.generated.ts"

const after = (...messages: readonly PupilAnswer[]): ClassState =>
  messages.reduce<ClassState>(
    (state, message) => reduceClass(state, {kind: "heard", message}),
    firstClassState,
  )

const entered: PupilAnswer = {
  op: "entered",
  pupil: 1,
  nickname: "Ada",
  words: "apple boat star",
  token: null,
  hand: false,
  programs: [],
  progress: {},
}
const asked: PupilAnswer = {op: "study", contact: "Prof. Quirk", takesPart: null}

describe("a study of the class", () => {
  it("is not shown before the service says that there is one", () => {
    expect(after(entered).study).toBe(null)
  })

  it("is shown with the contact and the answer", () => {
    expect(after(entered, asked).study).toEqual({contact: "Prof. Quirk", takesPart: null})
    expect(after(entered, asked, {...asked, takesPart: false}).study?.takesPart).toBe(false)
  })

  it("is gone when it ends, also while the page had no connection", () => {
    expect(after(entered, asked, {op: "study", contact: null, takesPart: null}).study).toBe(null)
    expect(after(entered, asked, entered).study).toBe(null)
  })
})
