/// Runs that go on from a moment: what is asked for, what of the run before stays, and where a changed program differs.

import {describe, expect, it} from "vitest"
import {reduce} from "../../src/reducers/reducer.ts"
import {awayRun} from "../../src/reducers/run_tree_reducer.ts"
import type {Frame, ServiceMessage} from "../../src/state/messages/messages.ts"
import type {PageEvent} from "../../src/state/page_events.ts"
import {initialState, type PageState} from "../../src/state/page_state.ts"
import {framesBetween} from "../../src/state/runs/recording.ts"
import {maxFrames} from "../../src/state/runs/run_tree.ts"
import {isOfRun} from "./event_player.ts"

const hear = (message: ServiceMessage): PageEvent => ({kind: "heard", message})
const frame = (run: number, step: number, fired: readonly string[] = []): PageEvent =>
  hear({
    op: "frame",
    frame: {
      run,
      step,
      time: step / 50,
      x: step / 50,
      y: 2,
      theta: 0,
      channels: {},
      fired,
      sensed: fired,
      boxes: null,
      ghost: null,
      memory: null,
    } satisfies Frame,
  })
const run: PageEvent = {kind: "run-pressed", seed: 3}
const running = hear({op: "state", run: 1, state: "running"})
const frames = [0, 25, 50, 75, 100].map(step => frame(1, step, [`f${step}`]))
const before = [hear({op: "hello", session: "s"}), run, running, ...frames]
const back: PageEvent = {kind: "looked-back", time: 1.2}
const goOn: PageEvent = {kind: "continue-pressed"}

function play(...events: readonly PageEvent[]) {
  let state: PageState = initialState
  let sent: readonly object[] = []
  for (const event of events) {
    const step = reduce(state, event)
    state = step.state
    sent = step.effects.flatMap(e => (e.kind === "send" && isOfRun(e.message) ? [e.message] : []))
  }
  const times = [...framesBetween(state.room.recording, 0, 100)].map(f => f.time)
  return {state, sent, times}
}

describe("a run that goes on from a moment", () => {
  it("repeats the last run up to the step that is looked at", () => {
    const {state, sent, times} = play(...before, back, goOn)
    expect(sent).toEqual([{op: "run", run: 2, source: "", seed: 3, speed: 1, after: 50, of: 1}])
    expect(times).toEqual([0, 0.5, 1])
    expect(state.room.frame?.time).toBe(1)
    expect(state.room.trail.flat().map(point => point.time)).toEqual([0, 0.5, 1])
    expect(state.lines.map(({text}) => text)).toEqual(["f0", "f25", "f50"])
    expect(state.room.fired).toEqual({f0: 0, f25: 0.5, f50: 1})
    expect([state.room.lookedAt, state.clock, state.run.kind]).toEqual([null, "going", "compiling"])
  })

  it("takes the frames that follow, and none of the run before", () => {
    expect(play(...before, back, goOn, frame(1, 110), frame(2, 50), frame(2, 51)).times).toEqual([
      0, 0.5, 1, 1.02,
    ])
  })

  it("forgets what was different when the program was changed", () => {
    const diverged = hear({op: "diverged", run: 2, time: 0.6})
    const {state, times} = play(...before, back, goOn, diverged, frame(2, 35), frame(2, 50))
    expect(times).toEqual([0, 0.5, 0.7, 1])
    expect(state.notice).toEqual({kind: "diverged", time: 0.6})
    expect(play(...before, back, goOn, hear({op: "diverged", run: 1, time: 0.6})).state.notice).toBeNull()
  })

  it("says when the commands of the run before are no longer kept, if the program was changed", () => {
    const uncompared = hear({op: "uncompared", run: 2, time: 0.6})
    expect(play(...before, back, goOn, uncompared).state.notice).toBeNull()
    const begun = play(...before, back).state
    const changed = {
      ...begun,
      document: {...begun.document, program: {...begun.document.program, text: "new"}},
    }
    const continued = reduce(changed, goOn).state
    expect(reduce(continued, uncompared).state.notice).toEqual({kind: "uncompared", time: 0.6})
  })

  it("comes from the run that it goes on from, in the tree of runs", () => {
    const {state} = play(...before, back, goOn, frame(2, 51))
    expect(state.runTree.nodes.map(({run, from}) => ({run, from}))).toEqual([
      {run: 1, from: null},
      {run: 2, from: {run: 1, at: 1}},
    ])
  })

  it("can go on from an earlier run as well, once that is shown again", () => {
    const stop: PageEvent = {kind: "stop-pressed"}
    const show: PageEvent = {kind: "run-shown", run: 1}
    const twice = [...before, back, goOn, frame(2, 51)]
    // Not while a program compiles.
    expect(play(...twice, show).state.room.run).toBe(2)
    const {state, times} = play(...twice, stop, show)
    expect(state.room.run).toBe(1)
    expect(times).toEqual([0, 0.5, 1, 1.5, 2])
    const ask: PageEvent = {
      kind: "why",
      event: {kind: "asked", question: {kind: "position", time: 1}},
    }
    expect(play(...twice, stop, show, ask).sent).toMatchObject([{op: "why", run: 1, position: true}])
    expect(play(...twice, stop, show, back, goOn).sent).toMatchObject([{run: 3, after: 50, of: 1}])
  })

  it("is no run when its program is refused: the run before is shown again at that moment", () => {
    const refused = hear({op: "state", run: 2, state: "ended", ended: "refused", problems: []})
    const {state, times} = play(...before, back, goOn, refused)
    expect(state.runTree.nodes.map(({run}) => run)).toEqual([1])
    expect([state.room.run, state.room.lookedAt]).toEqual([1, 1])
    expect(times).toEqual([0, 0.5, 1, 1.5, 2])
  })

  it.each<[string, readonly PageEvent[]]>([
    ["now", [goOn]],
    ["without the service", [back, {kind: "link-lost"}, goOn]],
    ["after a reset", [back, {kind: "reset-pressed"}, goOn]],
  ])("is not asked for %s", (_, events) => {
    expect(play(...before, ...events).sent).toEqual([])
  })
})

describe("an earlier run that is chosen while another goes on", () => {
  const show = (number: number): PageEvent => ({kind: "run-shown", run: number})
  const second = [back, goOn, hear({op: "state", run: 2, state: "running"}), frame(2, 51)]
  const away = [...before, ...second, show(1)]

  it("is shown, and the other one stands still", () => {
    const {state, sent, times} = play(...away)
    expect(sent).toEqual([{op: "pause"}])
    expect(times).toEqual([0, 0.5, 1, 1.5, 2])
    expect([state.room.run, state.clock, state.run]).toEqual([1, "standing", {kind: "running", run: 2}])
    expect(awayRun(state)?.number).toBe(2)
    // It stands already.
    expect(play(...before, ...second, {kind: "pause-pressed"}, show(1)).sent).toEqual([])
  })

  it("leaves the frames that are still on their way with their own run", () => {
    const {state, times} = play(...away, frame(2, 52), frame(1, 101), show(2))
    expect(times).toEqual([0, 0.5, 1, 1.02, 1.04])
    expect([state.room.run, state.clock, awayRun(state)]).toEqual([2, "standing", null])
    const seen = play(...away, frame(2, 52)).times
    expect(seen).toEqual([0, 0.5, 1, 1.5, 2])
  })

  it.each<[string, PageEvent, object]>([
    ["resumed", {kind: "resume-pressed"}, {op: "resume"}],
    ["made a step", {kind: "forward-pressed"}, {op: "forward"}],
    ["given a hand", {kind: "hand", hand: {lift: "both"}}, {op: "input", lift: "both"}],
  ])("gives its place to the other when that is %s", (_, event, message) => {
    const {state, sent, times} = play(...away, back, event)
    expect(sent).toEqual([message])
    expect([state.room.run, state.room.lookedAt]).toEqual([2, null])
    expect(times).toEqual([0, 0.5, 1, 1.02])
  })

  it("stays when the other one is stopped, which is then chosen like any", () => {
    const {state} = play(...away, {kind: "stop-pressed"}, frame(2, 52))
    expect([state.room.run, awayRun(state), state.run.kind]).toEqual([1, null, "ended"])
    expect(play(...away, {kind: "stop-pressed"}, frame(2, 52), show(2)).times).toEqual([
      0, 0.5, 1, 1.02, 1.04,
    ])
  })

  it("can be continued, which ends the other one", () => {
    const {state, sent} = play(...away, back, goOn)
    expect(sent).toMatchObject([{op: "run", run: 3, after: 50, of: 1}])
    expect(state.runTree.nodes.map(({run, from}) => [run, from?.run ?? null])).toEqual([
      [1, null],
      [2, 1],
      [3, 1],
    ])
    expect([awayRun(state), state.clock]).toEqual([null, "going"])
  })

  it("is never dropped for want of room while it goes on", () => {
    const {state} = play(...before, ...second)
    const long = {...state.room, recording: {...state.room.recording, length: maxFrames + 1}}
    const chosen = reduce({...state, room: long}, show(1)).state
    expect(awayRun(chosen)?.run).toBe(2)
  })
})
