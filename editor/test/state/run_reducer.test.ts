/// What Run, Stop and Reset do, also when answers come late, twice, or not at all.

import {describe, expect, it} from "vitest"
import {initialState} from "../../src/state/page_state.ts"
import {shownFrame, speech} from "../../src/state/runs/room_state.ts"
import {runStatus} from "../../src/ui/descriptions.ts"
import {readout} from "../../src/values/readout.ts"
import type {Problem} from "../../src/wire/problem.generated.ts"
import type {World} from "../../src/worlds/world.ts"
import {
  document,
  ended,
  frame,
  hear,
  hello,
  open,
  play,
  press,
  problem,
  reset,
  running,
  stop,
  text,
} from "./event_player.ts"

describe("a run", () => {
  it("answers at once, starts when the service says so, and carries the program's text", () => {
    const pressed = play(open, press)
    expect(pressed.state.run).toEqual({kind: "compiling", run: 1})
    expect(pressed.sent).toEqual([{op: "run", run: 1, source: text, speed: 1}])
    expect(play(pressed.state, running(1)).state.run.kind).toBe("running")
  })

  it("that was stopped while compiling stays stopped when the service says it runs", () => {
    const {state, ops} = play(open, press, stop, running(1))
    expect(ops).toEqual(["run", "stop"])
    expect(state.run).toEqual({kind: "ended", run: 1, how: "stopped"})
  })

  it("that was stopped keeps its end when the service tells of another", () => {
    expect(play(open, press, running(1), stop, ended(1, "error", [problem])).state.run).toMatchObject({
      how: "stopped",
    })
  })

  it("is replaced by the next without a stop, and late words about the first change nothing", () => {
    const {state} = play(open, press, running(1), press, ended(1, "stopped"), running(1), frame(1))
    expect(state.run).toEqual({kind: "compiling", run: 2})
    expect(state.room.frame).toBeNull()
  })

  it("that is refused shows the problem on the innermost block and in its tab", () => {
    const {state} = play(open, press, ended(1, "refused", [problem]))
    expect(state.run).toMatchObject({kind: "ended", how: "refused"})
    expect(state.findings.compiler).toMatchObject([{block: "type", range: {start: 14, end: 22}}])
    expect(state.tab).toBe("problems")
  })

  it("that ends by a problem without a place shows it on the function's definition", () => {
    const atRunTime = {...problem, start: null, end: null, time: 1.5}
    const {state} = play(open, press, running(1), ended(1, "error", [atRunTime]))
    expect(state.findings.run).toMatchObject([{block: "def", time: 1.5}])
    expect(state.run).toMatchObject({how: "error"})
  })

  it("that comes to an empty place has an end of its own, and tells of the place", () => {
    const empty: Problem = {...problem, kind: "hole", time: 1.5}
    const {state} = play(open, press, running(1), ended(1, "error", [empty]))
    expect(state.run).toMatchObject({how: "hole"})
    expect(runStatus(state)).toBe("Stopped at an empty place")
    expect(state.findings.run).toMatchObject([{kind: "hole", range: {start: 14, end: 22}}])
  })

  it("pressed before the service answers is sent when it does", () => {
    const waiting = play({...initialState, document}, press)
    expect(waiting.state.run.kind).toBe("waiting")
    expect(waiting.ops).toEqual([])
    const {state, ops} = play(waiting.state, hello)
    expect(state.run).toEqual({kind: "compiling", run: 1})
    expect(ops).toEqual(["observe", "check", "run"])
  })

  it("that waits for the service can be stopped, and is then not sent", () => {
    const {state, ops} = play({...initialState, document}, press, stop, hello)
    expect(state.run.kind).toBe("ready")
    expect(ops).toEqual(["observe", "check"])
  })

  it("ends when the connection is lost; the next one works when it is back", () => {
    const lost = play(open, press, running(1), {kind: "link-lost"})
    expect(lost.state.run).toMatchObject({kind: "ended", how: "lost"})
    const {state, ops} = play(lost.state, hello, press, running(2))
    expect(ops).toContain("run")
    expect(state.run).toEqual({kind: "running", run: 2})
  })
})

describe("time", () => {
  const pause = {kind: "pause-pressed"} as const
  const resume = {kind: "resume-pressed"} as const
  const driving = play(open, press, running(1), frame(1, {time: 1, x: 1}), frame(1, {time: 2, x: 2})).state

  it("shows a robot that is driven without a run, but nothing of the run before a reset", () => {
    const world = hear({op: "world", world: {name: "room", size: [5, 4]} as unknown as World})
    const idle = frame(1, {time: 0, x: 3, channels: {Velocity: [0.2, 0]}})
    const still = play(open, press, running(1), frame(1, {x: 2}), reset, frame(1, {x: 9})).state
    expect(still.room.frame).toBeNull()
    const driven = play(still, world, idle, idle).state
    expect(readout(driven)).toMatchObject({x: "3.000", speed: "0.200"})
    expect(driven.room.recording.length).toBe(1)
  })

  it("goes with the robot in a room too large to be seen whole, until the learner wants it otherwise", () => {
    const room = (name: string, size: [number, number]) =>
      hear({op: "world", world: {name, size} as unknown as World})
    const large = play(open, room("empty", [20, 20])).state
    expect(large.follows).toBe(true)
    const liked = play(large, {kind: "follows", follows: false}, room("empty", [20, 20])).state
    expect(liked.follows).toBe(false)
    expect(play(liked, room("room", [5, 4])).state.follows).toBe(false)
    expect(play(liked, room("room", [5, 4]), room("empty", [20, 20])).state.follows).toBe(true)
  })

  it("shows what was said and where the boxes stood at that moment", () => {
    const told = play(
      open,
      press,
      running(1),
      frame(1, {time: 1, boxes: [[1, 1, 0]]}),
      hear({op: "said", run: 1, time: 1.5, text: "bump!"}),
      frame(1, {time: 2}),
      frame(1, {time: 9}),
    ).state
    const at = (time: number) => play(told, {kind: "looked-back", time}).state.room
    expect(speech(at(1.2))).toBeNull()
    expect(speech(at(2))?.text).toBe("bump!")
    expect(speech(told.room)).toBeNull()
    // Boxes are told of only when they move; in between they stay where they were.
    expect(shownFrame(at(2))?.boxes).toEqual([[1, 1, 0]])
    expect(shownFrame(told.room)?.boxes).toEqual([[1, 1, 0]])
  })

  it("stands, goes one step, and goes on", () => {
    const {state, ops} = play(driving, pause, {kind: "forward-pressed"}, resume)
    expect(ops).toEqual(["pause", "forward", "resume"])
    expect(state.clock).toBe("going")
  })

  it("does not stand when nothing runs, and goes again with the next run", () => {
    expect(play(open, pause).ops).toEqual([])
    expect(play(driving, pause, stop, press).state.clock).toBe("going")
  })

  it("stands while the learner looks back, and is now again at the end or when it goes on", () => {
    const back = play(driving, {kind: "looked-back", time: 1.5})
    expect(back.ops).toEqual(["pause"])
    expect(readout(back.state)).toMatchObject({time: "1.00", x: "1.000"})
    expect(readout(play(back.state, resume).state)).toMatchObject({time: "2.00"})
    expect(play(back.state, {kind: "looked-back", time: 2}).state.room.lookedAt).toBeNull()
  })

  it("runs at the chosen speed, and changes it while it runs", () => {
    const fast = play(open, {kind: "speed-chosen", speed: 4}, press)
    expect(fast.sent).toMatchObject([{op: "run", speed: 4}])
    expect(play(fast.state, {kind: "speed-chosen", speed: "max"}).sent).toEqual([{op: "speed", speed: "max"}])
  })
})

describe("reset", () => {
  it("ends the run and puts the robot, the trail and the console back; late frames do not move it", () => {
    const {state, ops} = play(
      open,
      press,
      running(1),
      frame(1, {sensed: ["Bumper CenterBumper Pressed"]}),
      reset,
      frame(1, {x: 9}),
    )
    expect(ops).toEqual(["run", "reset"])
    expect(state.run.kind).toBe("ready")
    expect(state.room).toMatchObject({frame: null, trail: [], run: null})
    expect(state.lines).toEqual([])
  })
})
