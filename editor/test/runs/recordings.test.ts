/// Recordings of runs on real robots: asking for one, its run, its end, and what is sent to the service.

import {afterEach, beforeEach, describe, expect, it, vi} from "vitest"
import {mostRecordingBytes, sendRecording} from "../../src/controller/programs/recordings.ts"
import {mayOpenRecording} from "../../src/reducers/recording_reducer.ts"
import {reduce} from "../../src/reducers/reducer.ts"
import {mayContinue} from "../../src/reducers/run_reducer.ts"
import type {Frame, ServiceMessage} from "../../src/state/messages/messages.ts"
import type {PageEvent} from "../../src/state/page_events.ts"
import {initialState, type PageState} from "../../src/state/page_state.ts"
import {isDriving} from "../../src/state/robot_ownership.ts"
import {nodeOf} from "../../src/state/runs/run_tree.ts"
import type {Effect} from "../../src/state/transition.ts"

function play(before: PageState, ...events: readonly PageEvent[]) {
  let state = before
  const effects: Effect[] = []
  for (const event of events) {
    const step = reduce(state, event)
    state = step.state
    effects.push(...step.effects)
  }
  return {state, effects}
}

const hear = (message: ServiceMessage): PageEvent => ({kind: "heard", message})
const open: PageState = {...initialState, link: "open", session: "s"}
const wanted = (of: number | null): PageEvent => ({kind: "recording-wanted", of})
const replayed = (run: number, program = "main = simulate move\n") =>
  hear({op: "replayed", run, program, robot: "Kitchen"})
const frame = (run: number, step: number): PageEvent => {
  const none = {fired: [], sensed: [], boxes: null, ghost: null, memory: null}
  const told: Frame = {run, step, time: step / 50, x: step / 50, y: 0, theta: 0, channels: {}, ...none}
  return hear({op: "frame", frame: told})
}
const running = (run: number) => hear({op: "state", run, state: "running"})
const ended = (run: number, how: "stopped" | "refused" = "stopped") =>
  hear({op: "state", run, state: "ended", ended: how, problems: []})
const held = {name: "Kitchen", link: "connected", why: "", stopped: false, maxSpeed: 0.7, maxTurn: 3} as const

describe("a recording", () => {
  it("opens as a run of its own with the recorded program, can be scrubbed, and is not gone on with", () => {
    const asked = play(open, wanted(7))
    expect(asked.effects).toEqual([{kind: "send", message: {op: "replay", run: 1, of: 7, room: true}}])
    const {state} = play(asked.state, replayed(1), running(1), frame(1, 0), frame(1, 50), ended(1))
    expect(nodeOf(state.runTree, 1)).toMatchObject({recorded: "Kitchen", text: "main = simulate move\n"})
    expect(state.room.recording.length).toBe(2)
    // Another program is open: the tab shows which.
    expect(state.tab).toBe("runs")
    const looking = play(state, {kind: "looked-back", time: 0.5}).state
    expect(looking.room.lookedAt).toBe(0.5)
    expect(mayContinue(looking)).toBe(false)
  })

  it("begins in the middle of the open floor below a real robot, which is not driving meanwhile", () => {
    const {state} = play({...open, robots: {...open.robots, room: null}}, hear({op: "robot", robot: held}))
    const asked = play(state, wanted(1))
    expect(asked.effects).toEqual([{kind: "send", message: {op: "replay", run: 1, of: 1, room: false}}])
    expect(isDriving(asked.state)).toBe(false)
    const driving = play(asked.state, {kind: "stop-pressed"}, {kind: "run-pressed", seed: 1}).state
    expect([isDriving(driving), mayOpenRecording(driving)]).toEqual([true, false])
    const refused = play(driving, wanted(1))
    expect(refused.effects).toEqual([])
    expect(refused.state.notice).toMatchObject({kind: "refusal", message: expect.stringContaining("driving")})
  })

  it("plays no sounds and keeps the words", () => {
    const {state, effects} = play(
      open,
      wanted(null),
      replayed(1),
      running(1),
      hear({op: "sound", run: 1, time: 0, sound: 0}),
      hear({op: "said", run: 1, time: 0, text: "hi"}),
    )
    expect(effects.some(({kind}) => kind === "play")).toBe(false)
    expect(state.lines.map(({text}) => text)).toEqual(["OnSound", "hi"])
  })

  it("that cannot be opened leaves the page as it is", () => {
    // Where robots are locked, too, whose refusals are shown in their dialog.
    const locked = play(open, hear({op: "robots", locked: true, robots: [], discovers: false})).state
    const before = play(locked, {kind: "run-pressed", seed: 1}, running(1), frame(1, 0), ended(1)).state
    const {state} = play(
      before,
      wanted(null),
      hear({op: "refusal", message: "no recording", hint: ""}),
      ended(2),
    )
    expect(state.notice).toMatchObject({message: "no recording"})
    expect([state.room.run, state.run.kind]).toEqual([1, "ended"])
    expect(state.runTree.nodes.map(({run}) => run)).toEqual([1])
  })

  it("whose program does not compile any more is taken out of the runs", () => {
    const {state} = play(open, wanted(null), replayed(1), ended(1, "refused"))
    expect(state.runTree.nodes).toEqual([])
    expect(state.notice).toMatchObject({message: expect.stringContaining("another version")})
    expect(state.findings.compiler).toEqual([])
  })

  it("is known by its run until the connection is lost", () => {
    const {state} = play(open, hear({op: "recorded", run: 3, file: "/r/x.mcap"}))
    expect(state.recorded).toEqual({run: 3, file: "/r/x.mcap"})
    expect(play(state, {kind: "link-lost"}).state.recorded).toBe(null)
  })
})

describe("a file", () => {
  const file = (size: number) =>
    Object.defineProperties(new Blob(["x"]), {
      name: {value: "a b.mcap"},
      size: {value: size},
    }) as Blob & {name: string}
  // Only for these tests: the files of a process share its globals.
  beforeEach(() => {
    vi.stubGlobal("window", {location: {href: "http://rosy:8000/"}})
  })
  afterEach(() => {
    vi.unstubAllGlobals()
  })

  async function sent(size: number, answer: () => Promise<{ok: boolean; text(): Promise<string>}>) {
    const events: PageEvent[] = []
    const addresses: string[] = []
    await sendRecording({now: open, dispatch: event => events.push(event)}, file(size), address => {
      addresses.push(address)
      return answer()
    })
    return {events, addresses}
  }
  const notice = (message: unknown) => [{kind: "notice", notice: {kind: "refusal", message, hint: ""}}]

  it("is sent to the session of the page, and then asked for", async () => {
    const {events, addresses} = await sent(1, async () => ({ok: true, text: async () => "{}"}))
    expect(addresses).toEqual(["http://rosy:8000/api/recordings/s?name=a%20b.mcap"])
    expect(events).toEqual([wanted(null)])
  })

  it("that the service does not take gets its sentence, or one of the page", async () => {
    const said = {message: "too large", sentence: null}
    const refused = await sent(1, async () => ({ok: false, text: async () => JSON.stringify(said)}))
    expect(refused.events).toEqual(notice("too large"))
    const broken = await sent(1, async () => ({ok: false, text: async () => "<html>"}))
    expect(broken.events).toEqual(notice("a b.mcap could not be sent to Rosy. Try it again."))
    const lost = await sent(1, () => Promise.reject(new TypeError("network")))
    expect(lost.events).toEqual(notice("a b.mcap could not be sent to Rosy. Try it again."))
    const long = await sent(mostRecordingBytes + 1, () => Promise.reject(new Error("not sent")))
    expect(long.addresses).toEqual([])
    expect(long.events).toEqual(notice("a b.mcap is too large for a recording of a run."))
  })
})
