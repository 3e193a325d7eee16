import {describe, expect, it} from "vitest"
import {noQuestion, reduceWhy} from "../../src/state/messages/why_state.ts"
import {nodeQuestions} from "../../src/values/node_questions.ts"

const asked = (kind: string, key: string) =>
  nodeQuestions({kind, key}, 3).map(question => reduceWhy(noQuestion, {kind: "asked", question}).request)

describe("the questions about a node of the diagram", () => {
  it("are why a function ran and why it did not, in the two seconds before the displayed moment", () => {
    expect(asked("function", "spin")).toEqual([
      {op: "why", id: 1, function: "spin", time: 3},
      {op: "whyNot", id: 1, function: "spin", since: 1, until: 3},
    ])
  })

  it("are why a command was sent and why none was, without the parameters of its type", () => {
    expect(asked("command", "Say")).toEqual([
      {op: "why", id: 1, command: "Say", time: 3},
      {op: "whyNot", id: 1, command: "Say", since: 1, until: 3},
    ])
  })

  it("are what happened with an event, and why one of the program was not received", () => {
    expect(asked("event", "Bumper")).toEqual([{op: "why", id: 1, event: "Bumper", time: 3}])
    expect(asked("channel", "M1 Velocity")).toEqual([
      {op: "why", id: 1, event: "M1", time: 3},
      {op: "whyNot", id: 1, event: "M1 Velocity", since: 0, until: 3},
    ])
  })

  it("is why a memory has its value", () => {
    expect(asked("store", "Memory Mode")).toEqual([{op: "why", id: 1, memory: "Memory Mode", time: 3}])
  })

  it("is why the robot moves so, or how it came there, about what it measures of itself", () => {
    expect(asked("state", "Velocity")).toEqual([{op: "why", id: 1, command: "Velocity", time: 3}])
    expect(asked("state", "Position")).toEqual([{op: "why", id: 1, position: true, time: 3}])
    expect(asked("state", "Battery")).toEqual([])
  })

  it("are none about a container or a sample", () => {
    expect(asked("task", "explore")).toEqual([])
    expect(asked("sample", "Seconds")).toEqual([])
  })

  it("begin with the run", () => {
    expect(nodeQuestions({kind: "command", key: "Led1"}, 0.5)[1]).toMatchObject({since: 0, until: 0.5})
  })
})
