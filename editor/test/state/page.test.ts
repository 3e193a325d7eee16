/// What Run, Stop and Reset do, also when answers come late, twice, or not at all.

import {describe, expect, it} from "vitest"
import {type Document, emptyDocument, emptyHistory} from "../../src/state/history.ts"
import type {Frame, Problem, ServiceMessage} from "../../src/state/messages.ts"
import {next, readout} from "../../src/state/next.ts"
import {believed, firstPage, type Order, type PageEvent, type PageState} from "../../src/state/page.ts"
import type {Finding} from "../../src/state/program.ts"
import {shownFrame, speech} from "../../src/state/room.ts"
import type {World} from "../../src/worlds/world.ts"

/// Plays events in order; answers the last state and every message that was sent.
function play(state: PageState, ...events: readonly PageEvent[]) {
  const orders: Order[] = []
  for (const event of events) {
    const step = next(state, event)
    state = step.state
    orders.push(...step.orders)
  }
  const sent = orders.flatMap(o => (o.kind === "send" ? [o.message] : []))
  return {state, orders, sent, ops: sent.map(m => m.op)}
}

const hear = (message: ServiceMessage): PageEvent => ({kind: "heard", message})
const hello = hear({op: "hello", session: "s"})
const running = (run: number) => hear({op: "state", run, state: "running"})
const ended = (
  run: number,
  how: "done" | "error" | "refused" | "stopped",
  problems: readonly Problem[] = [],
) => hear({op: "state", run, state: "ended", ended: how, problems})
const frame = (run: number, more: Partial<Frame> = {}): PageEvent =>
  hear({
    op: "frame",
    frame: {
      run,
      step: 1,
      time: 0.02,
      x: 1,
      y: 2,
      theta: 0,
      v: 0.5,
      w: 0,
      bumpers: 0,
      cliffs: 0,
      wheels: 0,
      buttons: 0,
      led1: 0,
      led2: 0,
      fired: [],
      boxes: null,
      ghost: null,
      memory: null,
      ...more,
    },
  })
const press = {kind: "run-pressed"} as const
const stop = {kind: "stop-pressed"} as const
const reset = {kind: "reset-pressed"} as const
const text = "accelerate :: Velocity\n\nmain = simulate accelerate\n"
const program = {
  text,
  spans: [
    {start: 0, end: 22, block: "def"},
    {start: 14, end: 22, block: "type"},
    {start: 24, end: 50, block: "main"},
  ],
  definitions: [
    {name: "accelerate", start: 0, end: 22, block: "def"},
    {name: "main", start: 24, end: 50, block: "main"},
  ],
  families: {},
  words: [],
}
const document: Document = {...emptyDocument, program}
const open = play({...firstPage, document}, hello, hear({op: "worker", state: "ready"})).state
const problem: Problem = {
  severity: "error",
  kind: "type-mismatch",
  start: {line: 1, column: 15},
  end: {line: 1, column: 23},
  function: "accelerate",
  message: "",
  hint: "",
  ghc: "",
  time: null,
  inputs: [],
  fixes: [],
}

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
  })

  it("pressed before the service answers is sent when it does", () => {
    const waiting = play({...firstPage, document}, press)
    expect(waiting.state.run.kind).toBe("waiting")
    expect(waiting.ops).toEqual([])
    const {state, ops} = play(waiting.state, hello)
    expect(state.run).toEqual({kind: "compiling", run: 1})
    expect(ops).toEqual(["check", "run"])
  })

  it("that waits for the service can be stopped, and is then not sent", () => {
    const {state, ops} = play({...firstPage, document}, press, stop, hello)
    expect(state.run.kind).toBe("ready")
    expect(ops).toEqual(["check"])
  })

  it("ends when the connection is lost; the next one works when it is back", () => {
    const lost = play(open, press, running(1), {kind: "link-lost"})
    expect(lost.state.run).toMatchObject({kind: "ended", how: "lost"})
    const {state, ops} = play(lost.state, hello, press, running(2))
    expect(ops).toContain("run")
    expect(state.run).toEqual({kind: "running", run: 2})
  })
})

describe("a program that is opened", () => {
  const opened = (world: string | null): PageEvent => ({
    kind: "opened",
    opened: {name: "new", world, document, history: emptyHistory, welcome: false},
  })

  it("brings its room", () => {
    const {state, sent} = play({...open, worldName: "corridor"}, opened("maze"))
    expect(state.worldName).toBe("maze")
    expect(sent).toContainEqual({op: "world", world: "maze"})
  })

  it("without a room of its own takes the one it is opened in, also after the connection was lost", () => {
    const {state, ops} = play({...open, worldName: "corridor"}, opened(null))
    expect(state.worldName).toBe("corridor")
    expect(ops).toEqual(["reset", "check"])
    expect(play(state, {kind: "link-lost"}, hello).sent).toContainEqual({op: "world", world: "corridor"})
  })
})

describe("the connection", () => {
  it("that comes back chooses the project's room and asks the compiler again", () => {
    const {ops} = play({...open, worldName: "corridor"}, {kind: "link-lost"}, hello)
    expect(ops).toEqual(["world", "check"])
  })

  it("says when the worker restarts and when it is back", () => {
    const restarting = play(open, hear({op: "worker", state: "restarting"})).state
    expect(restarting.worker).toBe("restarting")
    expect(play(restarting, hear({op: "worker", state: "ready"})).state.worker).toBe("ready")
  })
})

describe("time", () => {
  const pause = {kind: "pause-pressed"} as const
  const resume = {kind: "resume-pressed"} as const
  const driving = play(open, press, running(1), frame(1, {time: 1, x: 1}), frame(1, {time: 2, x: 2})).state

  it("shows a robot that is driven without a run, but nothing of the run before a reset", () => {
    const world = hear({op: "world", world: {name: "room", size: [5, 4]} as unknown as World})
    const idle = frame(1, {time: 0, x: 3, v: 0.2})
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
    expect(speech(at(2))).toBe("bump!")
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
    const {state, ops} = play(open, press, running(1), frame(1, {bumpers: 2}), reset, frame(1, {x: 9}))
    expect(ops).toEqual(["run", "reset"])
    expect(state.run.kind).toBe("ready")
    expect(state.room).toMatchObject({frame: null, trail: [], run: null})
    expect(state.lines).toEqual([])
  })
})

describe("the compiler", () => {
  it("is asked after every change of the text, and only its newest answer counts", () => {
    const change = (t: string): PageEvent => ({
      kind: "program-changed",
      document: {...document, program: {...program, text: t}},
      by: "blocks",
      at: 0,
    })
    const {state, sent} = play(open, change("a"), change("b"))
    const ids = sent.flatMap(m => (m.op === "check" ? [m.id] : []))
    expect(new Set(ids).size).toBe(2)
    const checked = (id: number) =>
      hear({op: "checked", id, problems: [problem], declarations: [], types: {names: [], at: []}})
    expect(play(state, checked(ids[0] ?? -1)).state.findings.compiler).toEqual([])
    expect(play(state, checked(ids[1] ?? -1)).state.findings.compiler).toHaveLength(1)
  })

  it("is believed before the blocks once it has taken the text, but not about an empty socket", () => {
    const doubt = (kind: string): Finding => ({
      severity: "error",
      kind,
      from: "blocks",
      message: kind,
      hint: "",
      ghc: "",
      function: null,
      time: null,
      inputs: [],
      fixes: [],
      block: "b",
      range: null,
    })
    const doubted: PageState = {
      ...open,
      document: {...document, findings: [doubt("hole"), doubt("not-in-scope")]},
    }
    const answers = (problems: readonly Problem[]) =>
      play(
        doubted,
        hear({op: "checked", id: doubted.checks, problems, declarations: [], types: {names: [], at: []}}),
      ).state
    expect(believed(doubted)).toHaveLength(2)
    expect(believed(answers([])).map(f => f.kind)).toEqual(["hole"])
    expect(believed(answers([problem]))).toHaveLength(2)
  })

  it("is not asked when blocks only moved", () => {
    expect(play(open, {kind: "program-changed", document, by: "blocks", at: 0}).sent).toEqual([])
  })
})

describe("undo", () => {
  it("brings back the program before, asks the compiler about it, and redo the one after", () => {
    const other = {...document, program: {...program, text: "main = simulate ()\n"}}
    const changed = play(open, {kind: "program-changed", document: other, by: "blocks", at: 0})
    const back = play(changed.state, {kind: "undo-pressed"})
    expect(back.state.document).toBe(document)
    expect(back.sent).toMatchObject([{op: "check", source: text}])
    expect(play(back.state, {kind: "redo-pressed"}).state.document).toBe(other)
  })

  it("does nothing when there is nothing to undo", () => {
    expect(play(open, {kind: "undo-pressed"}).state).toBe(open)
  })
})

describe("the room", () => {
  it("tells each bump once, and counts what repeats", () => {
    const bump = (time: number, bumpers: number) => frame(1, {time, bumpers})
    const {state} = play(open, press, running(1), bump(1, 2), bump(1.02, 2), bump(1.04, 0), bump(1.06, 2))
    expect(state.lines).toEqual([{kind: "sensed", text: "Bumper CenterBumper Pressed", time: 1.06, count: 2}])
  })

  it("plays sounds unless it is muted", () => {
    const sound = hear({op: "sound", run: 1, time: 1, sound: 4})
    const playing = play(open, press, running(1)).state
    expect(play(playing, sound).orders).toEqual([{kind: "play", sound: 4}])
    expect(play(playing, {kind: "muted", muted: true}, sound).orders).toEqual([])
  })

  it("reads as numbers and words", () => {
    const {state} = play(open, press, frame(1, {theta: -Math.PI / 2, bumpers: 6, led1: 2}))
    expect(readout(state)).toMatchObject({
      x: "1.000",
      heading: "270°",
      bumpers: "left centre",
      led1: "Orange",
      led2: "Black",
    })
  })
})
