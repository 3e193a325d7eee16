/// Last values of functions, commands and events of the program, as far as firings tell them.

import {describe, expect, it} from "vitest"
import {addFirings, emptyLog} from "../../src/state/runs/firing_log.ts"
import {emptyRoom, type RoomState} from "../../src/state/runs/room_state.ts"
import {lastOf} from "../../src/values/last_values.ts"
import type {Given} from "../../src/wire/firing.generated.ts"
import type {FiringShown} from "../../src/wire/page/explanations.generated.ts"
import {measures, words} from "../../src/words/index.ts"

const firing = (n: number, time: number, name: string, ...gave: Given[]): FiringShown => ({
  n,
  time,
  function: name,
  task: 0,
  cause: {by: "tick", value: "", instant: null, event: null, firing: null},
  took: [
    {
      from: "state",
      value: "Velocity 0.1 0.0",
      type: "",
      firing: null,
      channel: "",
      instant: null,
      read: null,
    },
  ],
  gave,
  branches: [],
})
const velocity = (value: string): Given => ({to: "command", value, type: "Velocity", event: null})
const frame = {run: 1, step: 0, x: 0, y: 0, theta: 0, channels: {}, fired: [], sensed: []}

const room: RoomState = {
  ...emptyRoom,
  frame: {...frame, time: 2, boxes: null, ghost: null, memory: null},
  firings: addFirings(emptyLog, [
    firing(1, 1.8, "drive", velocity("Velocity 0.30000000000000004 0.0")),
    firing(2, 1.9, "turn", velocity("Velocity 0.0 1.0")),
    firing(3, 1.9, "tell", {to: "event", value: "Far 3", type: "Far", event: null}),
    firing(4, 1.96, "turn"),
  ]),
}
const last = (kind: string, key: string) => lastOf(room, {kind, key}, words.why, measures)

describe("the last value", () => {
  it("of a function is what it took and gave", () => {
    expect(last("function", "drive")).toBe("Velocity 0.1 0.0 → Velocity 0.3 0.0")
    expect(last("function", "turn")).toBe("Velocity 0.1 0.0 → nothing")
  })

  it("of a command and of an event is what the latest firings gave", () => {
    expect(last("command", "Velocity")).toBe("Velocity 0.0 1.0")
    expect(last("channel", "Far")).toBe("Far 3")
  })

  it("of a command is not known when a firing is missing that may have given a later one", () => {
    const {pieces} = room.firings
    const firings = {
      isWhole: false,
      pieces: pieces.map(piece => ({...piece, firings: piece.firings.filter(({n}) => n !== 2)})),
    }
    const shown = (key: string, kind: string) => lastOf({...room, firings}, {kind, key}, words.why, measures)
    expect(shown("Far", "channel")).toBe("Far 3")
    expect(shown("Velocity", "command")).toBeNull()
  })

  it("is not known before a firing, without a run, and of other nodes", () => {
    expect(last("function", "stop")).toBeNull()
    expect(last("command", "Led1")).toBeNull()
    expect(lastOf(emptyRoom, {kind: "function", key: "drive"}, words.why, measures)).toBeNull()
    expect(last("state", "Velocity")).toBeNull()
  })
})
