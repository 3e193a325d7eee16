/// Questions, answers, and the way back between them.

import {describe, expect, it} from "vitest"
import {
  type Explanation,
  isAsking,
  motionQuestion,
  noCommandQuestion,
  noQuestion,
  otherQuestion,
  type Question,
  reduceWhy,
  type WhyEvent,
} from "../../src/state/messages/why_state.ts"

const motion: Question = {kind: "command", command: "Velocity", value: "", time: 3.5}
const bump: Question = {kind: "firing", firing: 1, function: "bump"}
const answer = (id: number): Explanation => ({id, time: 3.5, sentences: [], path: []})

function play(...events: readonly WhyEvent[]) {
  let state = noQuestion
  const sent = []
  for (const event of events) {
    const step = reduceWhy(state, event)
    state = step.state
    if (step.request !== null) sent.push(step.request)
  }
  return {state, sent}
}

describe("a question about the run", () => {
  it("is sent, and shows its answer when that comes", () => {
    const asked = play({kind: "asked", question: motion})
    expect(asked.sent).toEqual([{op: "why", id: 1, command: "Velocity", time: 3.5}])
    expect(isAsking(asked.state)).toBe(true)
    const {state} = play({kind: "asked", question: motion}, {kind: "answered", answer: answer(1)})
    expect(state.open?.answer?.id).toBe(1)
    expect(isAsking(state)).toBe(false)
  })

  it("leads one step further and back again", () => {
    const {state, sent} = play(
      {kind: "asked", question: motion},
      {kind: "answered", answer: answer(1)},
      {kind: "followed", question: bump},
      {kind: "answered", answer: answer(2)},
      {kind: "went-back"},
    )
    expect(sent.map(({id}) => id)).toEqual([1, 2, 3])
    expect(sent[1]).toEqual({op: "why", id: 2, firing: 1})
    expect(state.open).toMatchObject({question: motion, before: []})
  })

  it("ignores an answer to a question before, and one that comes after the panel was closed", () => {
    const late = play(
      {kind: "asked", question: motion},
      {kind: "followed", question: bump},
      {kind: "answered", answer: answer(1)},
    )
    expect(late.state.open?.answer).toBeNull()
    const closed = play(
      {kind: "asked", question: motion},
      {kind: "closed"},
      {kind: "answered", answer: answer(1)},
    )
    expect(closed.state.open).toBeNull()
  })

  it.each<[Question, object]>([
    [
      {kind: "memory", type: "Memory Int", time: null},
      {op: "why", id: 1, memory: "Memory Int"},
    ],
    [
      {kind: "position", time: 2.5},
      {op: "why", id: 1, position: true, time: 2.5},
    ],
    [
      {kind: "event", value: "Online", time: 1},
      {op: "why", id: 1, event: "Online", time: 1},
    ],
    [
      {kind: "not", function: "play", command: "", since: 2, until: 4},
      {op: "whyNot", id: 1, function: "play", since: 2, until: 4},
    ],
    [
      {kind: "not", function: "play", command: "Sound", since: 2, until: 4},
      {op: "whyNot", id: 1, function: "play", command: "Sound", since: 2, until: 4},
    ],
  ])("%j is sent as %j", (question, request) => {
    expect(play({kind: "asked", question}).sent).toEqual([request])
  })
})

describe("the question beside one about the robot", () => {
  it("goes from its motion to its place at that time, and back", () => {
    expect(otherQuestion(motionQuestion(3.5), 8)).toEqual({kind: "position", time: 3.5})
    expect(otherQuestion(motionQuestion(null), 8)).toEqual({kind: "position", time: 8})
    expect(otherQuestion(motionQuestion(null), null)).toBeNull()
    expect(otherQuestion({kind: "position", time: 3.5}, 8)).toEqual(motionQuestion(3.5))
  })

  it("is asked of nothing else", () => {
    expect(otherQuestion(bump, 8)).toBeNull()
    expect(otherQuestion({kind: "command", command: "Sound", value: "ErrorSound", time: 1}, 8)).toBeNull()
  })
})

describe("after the answer that no command had been sent", () => {
  const led: Question = {kind: "command", command: "Led1", value: "", time: 3}
  const told = (id: "nothing-sent-yet" | "sent"): Explanation => {
    const said = {id} as Explanation["sentences"][number]["said"]
    return {id: 1, time: 3, sentences: [{said, time: 3, firing: null}], path: []}
  }

  it("asks why there was none", () => {
    expect(noCommandQuestion(led, told("nothing-sent-yet"), null)).toEqual({
      kind: "no-command",
      command: "Led1",
      since: 1,
      until: 3,
    })
    expect(noCommandQuestion({...led, time: null}, told("nothing-sent-yet"), 1)).toMatchObject({
      since: 0,
      until: 1,
    })
  })

  it("asks nothing after other answers and other questions", () => {
    expect(noCommandQuestion(led, told("sent"), null)).toBeNull()
    expect(noCommandQuestion(led, null, null)).toBeNull()
    expect(noCommandQuestion(bump, told("nothing-sent-yet"), 3)).toBeNull()
  })
})
