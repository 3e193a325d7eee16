/// Messages made by hand.

import {describe, expect, it} from "vitest"
import {messageOf} from "../../src/values/topic_message.ts"

describe("a message made by hand", () => {
  it("has numbers, truth values, lists and texts in its fields", () => {
    expect(
      messageOf([
        ["pose.position.x", "1.5"],
        ["pose.position.y", ""],
        ["on", "true"],
        ["ranges", "[1, 2]"],
        ["name", "kitchen"],
      ]),
    ).toEqual({pose: {position: {x: 1.5, y: 0}}, on: true, ranges: [1, 2], name: "kitchen"})
  })
})
