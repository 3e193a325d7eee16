/// A real robot in the page's hands: choosing, driving, stopping, losing it.

import {describe, expect, it} from "vitest"
import type {Frame, ServiceMessage} from "../../src/state/messages.ts"
import type {PageEvent} from "../../src/state/page_events.ts"
import {initialState, type PageState} from "../../src/state/page_state.ts"
import {reduce} from "../../src/state/reducer.ts"
import {isDriving} from "../../src/state/robot_ownership.ts"
import type {OwnedRobot} from "../../src/state/robots.ts"
import type {Effect} from "../../src/state/transition.ts"

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
const robots = (locked: boolean) => hear({op: "robots", locked, robots: []})
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
    const room = {name: "room", size: [5, 4], start: {x: 1, y: 1, theta: 0}, tile: 0.5} as const
    const world = {
      ...room,
      title: "",
      realism: null,
      dock: null,
      battery: 1,
      scanner: false,
      tiles: [],
      walls: [],
      boxes: [],
      rounds: [],
      goals: [],
    }
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
