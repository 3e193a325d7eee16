/// A real robot in the page's hands: choosing, driving, stopping, losing it.

import {describe, expect, it} from "vitest"
import {reduce} from "../../src/reducers/reducer.ts"
import type {Frame, ServiceMessage} from "../../src/state/messages/messages.ts"
import type {PageEvent} from "../../src/state/page_events.ts"
import {initialState, type PageState} from "../../src/state/page_state.ts"
import {isDriving} from "../../src/state/robot_ownership.ts"
import type {OwnedRobot} from "../../src/state/robots.ts"
import {comparedRun, runRows} from "../../src/state/runs/run_tree.ts"
import type {Effect} from "../../src/state/transition.ts"
import type {World} from "../../src/worlds/world.ts"

function play(state: PageState, ...events: readonly PageEvent[]) {
  const orders: Effect[] = []
  for (const event of events) {
    const step = reduce(state, event)
    state = step.state
    orders.push(...step.effects)
  }
  return {state, ops: orders.flatMap(o => (o.kind === "send" ? [o.message.op] : []))}
}

const hear = (message: ServiceMessage): PageEvent => ({kind: "heard", message})
const robots = (locked: boolean) => hear({op: "robots", locked, robots: [], discovers: false})
const robot = (
  more: Partial<Omit<OwnedRobot, "link">> & {link?: OwnedRobot["link"] | "gone"} = {},
): PageEvent =>
  hear({
    op: "robot",
    robot: {
      name: "Kitchen",
      link: "connected",
      why: "",
      stopped: false,
      maxSpeed: 0.7,
      maxTurn: 3.14,
      ...more,
    },
  })
const frame = (run: number, x: number): PageEvent => {
  const still = {theta: 0, channels: {Velocity: [0, 0]}, sensed: []}
  const none = {fired: [], boxes: null, ghost: null, memory: null}
  const told: Frame = {run, step: 1, time: 0.02, x, y: 0, ...none, ...still}
  return hear({op: "frame", frame: told})
}
const world: World = {
  name: "room",
  title: "",
  size: [5, 4],
  start: {x: 1, y: 1, theta: 0},
  tile: 0.5,
  realism: null,
  dock: null,
  battery: 1,
  scanner: false,
  robot: "kobuki",
  tiles: [],
  walls: [],
  boxes: [],
  rounds: [],
  lines: [],
  goals: [],
}
const open = play(initialState, hear({op: "hello", session: "s"}), robots(false)).state
const held = play(open, {kind: "robot-taken", robot: "Kitchen", who: "Anna"}, robot()).state
const driving = play(held, {kind: "run-pressed"}, hear({op: "state", run: 1, state: "running"})).state

describe("a real robot", () => {
  it("is unlocked again by itself after the connection was lost", () => {
    const known = play(open, {kind: "robots-unlocked", code: "abc"}).state
    expect(play(known, {kind: "link-lost"}, hear({op: "hello", session: "t"}), robots(true)).ops).toContain(
      "unlock",
    )
  })

  it("does not try a code again that was refused", () => {
    const asked = play(initialState, {kind: "robots-unlocked", code: "abc"}, robots(true))
    expect(asked.ops).toEqual(["unlock"])
    const refused = play(asked.state, hear({op: "refusal", message: "No.", hint: ""})).state
    expect(refused.robots).toMatchObject({code: null, refused: "No."})
    expect(play(refused, robots(true)).ops).toEqual([])
  })

  it("stands on open floor, and is seen before a program runs", () => {
    expect(held.room.world).toMatchObject({name: "Kitchen", open: true})
    expect(play(held, frame(0, 0.5)).state.room.frame?.x).toBe(0.5)
  })

  it("keeps its floor when the service tells of the simulated room", () => {
    expect(play(held, hear({op: "world", world})).state.room.world?.name).toBe("Kitchen")
    const back = play(held, robot({link: "gone"}), hear({op: "world", world})).state
    expect(back.room.world?.name).toBe("room")
  })

  it("has neither pause nor steps nor hands, also when the run is looked back at", () => {
    const moved = play(driving, frame(1, 0), frame(1, 1)).state
    const events: readonly PageEvent[] = [
      {kind: "pause-pressed"},
      {kind: "forward-pressed"},
      {kind: "looked-back", time: 0},
      {kind: "hand", hand: {press: "Button0"}},
    ]
    expect(play(moved, ...events).ops).toEqual([])
  })

  it("drives from Run to the end of the run, and only then must it be watched", () => {
    expect([isDriving(held), isDriving(driving), isDriving(open)]).toEqual([false, true, false])
  })

  it("is stopped when the page is seen no more, and the learner is told why", () => {
    const hidden = play(driving, {kind: "out-of-sight"})
    expect(hidden.ops).toEqual(["stop"])
    expect(hidden.state.notice).toMatchObject({kind: "out-of-sight", name: "Kitchen"})
    expect(play(held, {kind: "out-of-sight"}).ops).toEqual([])
  })

  it("is stopped in an emergency and freed again", () => {
    expect(play(driving, {kind: "estop-pressed"}, {kind: "free-pressed"}).ops).toEqual(["estop", "free"])
    expect(play(open, {kind: "estop-pressed"}).ops).toEqual([])
  })

  it("is gone with the connection, and the run with it", () => {
    const lost = play(driving, {kind: "link-lost"}).state
    expect(lost.robots.held).toBeNull()
    expect(lost.run.kind).toBe("ended")
  })
})

describe("a real robot beside the simulated one", () => {
  const there = play(open, hear({op: "world", world})).state
  const taken = play(there, {kind: "robot-taken", robot: "Kitchen", who: "Anna"}, robot()).state
  const switched = play(taken, {kind: "twin-switched", on: true}).state
  const started = reduce(switched, {kind: "run-pressed"})
  const running = play(started.state, hear({op: "state", run: 2, state: "running"})).state
  const sound: PageEvent = hear({op: "sound", run: 1, time: 0.1, sound: 4})

  it("drives in the room, and on its floor again without it", () => {
    expect(taken.room.world?.name).toBe("Kitchen")
    expect(switched.room.world?.name).toBe("room")
    expect(play(switched, {kind: "twin-switched", on: false}).state.room.world?.name).toBe("Kitchen")
    expect(play(running, {kind: "twin-switched", on: false}).state.robots.twin).toBe(true)
  })

  it("is in another room when another one is chosen", () => {
    const other = {...world, name: "table"}
    const chosen = play(switched, {kind: "world-chosen", world: "table"}, hear({op: "world", world: other}))
    expect(chosen.ops).toEqual(["world"])
    expect(chosen.state.room.world?.name).toBe("table")
    // Its frames have the number of the run before.
    expect(play(chosen.state, frame(chosen.state.runs, 0.5)).state.room.frame?.x).toBe(0.5)
  })

  it("asks for both runs, and shows the simulated one over the real one", () => {
    expect(started.effects).toEqual([
      {kind: "send", message: expect.objectContaining({op: "run", run: 2, twin: 1})},
    ])
    const both = play(running, frame(2, 0.5), frame(1, 0.7)).state
    expect(both.room.frame?.x).toBe(0.5)
    expect(comparedRun(both.runTree)?.kept.room.frame?.x).toBe(0.7)
    expect(runRows(both.runTree).map(({node, level}) => [node.number, node.twin, level])).toEqual([
      [1, "real", 1],
      [1, "simulated", 2],
    ])
  })

  it("is the only one that is heard", () => {
    const played = reduce(running, sound)
    expect(played.effects).toEqual([])
    expect(played.state.lines).toEqual([])
    expect(comparedRun(played.state.runTree)?.kept.lines).toHaveLength(1)
  })

  it("has no runs in the tree when its program does not compile, or when it is let go", () => {
    const refused = hear({op: "state", run: 2, state: "ended", ended: "refused", problems: []})
    expect(play(started.state, refused).state.runTree.nodes).toEqual([])
    const both = play(running, frame(2, 0.5), frame(1, 0.7)).state
    expect(play(both, robot({link: "gone"})).state.runTree.nodes).toEqual([])
  })

  it("begins its next run beside the last one, also while the simulated one is looked at", () => {
    const both = play(
      running,
      frame(2, 0.5),
      frame(1, 0.7),
      hear({op: "state", run: 2, state: "ended", ended: "done", problems: []}),
    ).state
    const twin = play(both, {kind: "run-shown", run: 1}).state
    expect(twin.room.frame?.x).toBe(0.7)
    const again = play(twin, {kind: "run-pressed"}).state
    expect(runRows(again.runTree).map(({node, level}) => [node.number, node.twin, level])).toEqual([
      [1, "real", 1],
      [1, "simulated", 2],
      [2, "real", 1],
      [2, "simulated", 2],
    ])
    expect(again.runTree.compared).toBe(3)
  })
})
