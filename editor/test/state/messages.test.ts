/// The one door for the service's words: what follows the protocol comes in, what does not is named with its path.

import {describe, expect, it} from "vitest"
import {offsetOf} from "../../src/program/program.ts"
import {readServiceMessage} from "../../src/state/messages/message_decoder.ts"

describe("a message of the service", () => {
  it("is read", () => {
    expect(readServiceMessage('{"op":"worker","state":"ready"}')).toEqual({
      kind: "ok",
      value: {op: "worker", state: "ready", fault: ""},
    })
  })

  it("says why a worker cannot start", () => {
    expect(readServiceMessage('{"op":"worker","state":"failed","message":"No library."}')).toMatchObject({
      value: {op: "worker", state: "failed", fault: "No library."},
    })
  })

  it.each([
    ['{"op":"worker","state":"asleep"}', "at state: expected one of starting, ready, restarting, failed"],
    ['{"op":"frame","run":1}', "at time: expected a number"],
    ['{"op":"world","world":{"size":[1]}}', "at world.size: expected two numbers"],
    ['{"op":"state","run":1,"state":"ended","ended":"done","problems":[{}]}', "at problems[0].severity"],
    ['{"op":"dance"}', "at op: expected a message this page knows"],
    ["nonsense", "at the top: expected an object"],
  ])("%s is refused with its path", (text, message) => {
    const read = readServiceMessage(text)
    expect(read).toMatchObject({kind: "mismatch"})
    expect(read.kind === "mismatch" && read.message).toContain(message)
  })
})

describe("a place in the text", () => {
  it("counts characters, not UTF-16 units", () => {
    expect(offsetOf('x = "🤖" + y', {line: 1, column: 9})).toBe(9)
    expect(offsetOf("a\nbc", {line: 2, column: 2})).toBe(3)
  })

  it("past the end is the end", () => {
    expect(offsetOf("a\nbc", {line: 2, column: 40})).toBe(4)
    expect(offsetOf("a\nbc", {line: 9, column: 1})).toBe(4)
  })
})
