/// What the messages of the service change: connection, room, console, answers about a run.

import {describe, expect, it} from "vitest"
import type {PageEvent} from "../../src/state/page_events.ts"
import {initialState} from "../../src/state/page_state.ts"
import {isMinorEvent} from "../../src/state/runs/room_state.ts"
import {readout} from "../../src/values/readout.ts"
import {frame, hear, hello, open, play, press, reset, running} from "./event_player.ts"

describe("the connection", () => {
  it("asks for a record of the runs", () => {
    expect(play(initialState, hello).sent).toContainEqual({op: "observe", on: true})
  })

  it("asks for the firings only while their values are shown", () => {
    const {state, sent} = play(open, {kind: "values-shown", shown: true})
    expect(sent).toEqual([{op: "observe", on: true, frames: true}])
    expect(play(state, {kind: "link-lost"}, hello).sent).toContainEqual({
      op: "observe",
      on: true,
      frames: true,
    })
    expect(play(state, {kind: "values-shown", shown: false}).sent).toEqual([{op: "observe", on: true}])
  })

  it("asks for the firings while the graph of a function is open", () => {
    const {state, sent} = play(open, {kind: "function-graphed", function: "go"})
    expect([state.graphed, state.tab, sent]).toEqual([
      "go",
      "charts",
      [{op: "observe", on: true, frames: true}],
    ])
    expect(play(state, {kind: "function-graphed", function: null}).sent).toEqual([{op: "observe", on: true}])
  })

  it("that comes back chooses the project's room and asks the compiler again", () => {
    const {ops} = play({...open, worldName: "corridor"}, {kind: "link-lost"}, hello)
    expect(ops).toEqual(["world", "observe", "check"])
  })

  it("says when the worker restarts and when it is back", () => {
    const restarting = play(open, hear({op: "worker", state: "restarting", fault: ""})).state
    expect(restarting.worker).toBe("restarting")
    expect(play(restarting, hear({op: "worker", state: "ready", fault: ""})).state.worker).toBe("ready")
  })

  it("keeps why the worker cannot start until it is ready", () => {
    const failed = play(open, hear({op: "worker", state: "failed", fault: "No library."})).state
    expect([failed.worker, failed.workerFault]).toEqual(["failed", "No library."])
    expect(play(failed, hear({op: "worker", state: "ready", fault: ""})).state.workerFault).toBe("")
  })
})

describe("the room", () => {
  it("tells each bump once, and counts what repeats", () => {
    const bump = (time: number) => frame(1, {time, sensed: ["Bumper CenterBumper Pressed"]})
    const {state} = play(open, press, running(1), bump(1), frame(1, {time: 1.02}), bump(1.06))
    expect(state.lines).toEqual([{kind: "sensed", text: "Bumper CenterBumper Pressed", time: 1.06, count: 2}])
  })

  it("has the time at which the program sensed an event, which a frame may tell later", () => {
    const late = frame(1, {time: 1.1, sensed: ["Bumper CenterBumper Pressed"], times: [1.06]})
    expect(play(open, press, running(1), late).state.lines).toMatchObject([{time: 1.06}])
  })

  it("plays sounds unless it is muted", () => {
    const sound = hear({op: "sound", run: 1, time: 1, sound: 4})
    const playing = play(open, press, running(1)).state
    expect(play(playing, sound).orders).toEqual([{kind: "play", sound: 4}])
    expect(play(playing, {kind: "muted", muted: true}, sound).orders).toEqual([])
  })

  it("reads as numbers and words", () => {
    const {state} = play(
      open,
      press,
      frame(1, {theta: -Math.PI / 2, channels: {Velocity: [0.5, 0], Bumper: [1, 1, 0], Led1: [2]}}),
    )
    expect(readout(state)).toMatchObject({
      x: "1.000",
      heading: "270°",
      bumpers: "left centre",
      led1: "Orange",
      led2: "Black",
    })
  })
})

describe("the console", () => {
  it("calls the end of an event and the robot's connection minor, and nothing else", () => {
    const minor = (text: string) => isMinorEvent({kind: "sensed", text})
    expect(
      [
        "Online",
        "Offline",
        "Bumper LeftBumper Released",
        "Cliff CenterCliff Floor",
        "Reply dock Feedback",
      ].map(minor),
    ).toEqual([true, true, true, true, true])
    expect(
      ["Bumper LeftBumper Pressed", "Wheel LeftWheel Air", "Button 1 Pressed", "Reply dock Succeeded"].map(
        minor,
      ),
    ).toEqual([false, false, false, false])
    expect(isMinorEvent({kind: "said", text: "Online"})).toBe(false)
  })

  it("shows minor events on request, also in the next run", () => {
    const {state} = play(initialState, {kind: "all-events", allEvents: true}, hello, {...press, seed: 1})
    expect(state.allEvents).toBe(true)
  })
})

describe("a question about the run", () => {
  const motion = {kind: "command", command: "Velocity", value: "", time: 1} as const
  const asked: PageEvent = {kind: "why", event: {kind: "asked", question: motion}}

  it("is sent to the service, and its answer is shown until the next run", () => {
    const {state, sent} = play(open, asked)
    expect(sent).toEqual([{op: "why", id: 1, command: "Velocity", time: 1}])
    const answer = {id: 1, time: 1, sentences: [], path: []}
    const told = play(state, hear({op: "because", answer})).state
    expect(told.why.open?.answer).toEqual(answer)
    expect(play(told, press).state.why.open).toBeNull()
    expect(play(told, reset).state.why.open).toBeNull()
  })

  it("is not asked without a service", () => {
    const {state, sent} = play(play(open, {kind: "link-lost"}).state, asked)
    expect(sent).toEqual([])
    expect(state.why.open).toBeNull()
  })

  it("leads a phone to the room, where the answer stands", () => {
    expect(play({...open, size: "phone", region: "haskell"}, asked).state.region).toBe("room")
  })
})
