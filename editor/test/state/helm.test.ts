/// A real robot in the page's hands: choosing, driving, stopping, losing it.

import {describe, expect, it} from "vitest"
import {drives} from "../../src/state/helm.ts"
import type {Frame, ServiceMessage} from "../../src/state/messages.ts"
import {next} from "../../src/state/next.ts"
import {firstPage, type Order, type PageEvent, type PageState} from "../../src/state/page.ts"
import type {Held} from "../../src/state/robots.ts"

function play(state: PageState, ...events: readonly PageEvent[]) {
  const orders: Order[] = []
  for (const event of events) {
    const step = next(state, event)
    state = step.state
    orders.push(...step.orders)
  }
  return {state, ops: orders.flatMap(o => (o.kind === "send" ? [o.message.op] : []))}
}

const hear = (message: ServiceMessage): PageEvent => ({kind: "heard", message})
const robots = (locked: boolean) => hear({op: "robots", locked, robots: []})
const robot = (more: Partial<Omit<Held, "link">> & {link?: Held["link"] | "gone"} = {}): PageEvent =>
  hear({
    op: "robot",
    robot: {
      name: "Kitchen",
      link: "connected",
      why: "",
      safety: true,
      backing: false,
      stopped: false,
      maxSpeed: 0.7,
      maxTurn: 3.14,
      ...more,
    },
  })
const frame = (run: number, x: number): PageEvent => {
  const still = {theta: 0, v: 0, w: 0, bumpers: 0, cliffs: 0, wheels: 0, buttons: 0, led1: 0, led2: 0}
  const none = {fired: [], boxes: null, ghost: null, memory: null}
  const told: Frame = {run, step: 1, time: 0.02, x, y: 0, ...none, ...still}
  return hear({op: "frame", frame: told})
}
const open = play(firstPage, hear({op: "hello", session: "s"}), robots(false)).state
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
    const asked = play(firstPage, {kind: "robots-unlocked", code: "abc"}, robots(true))
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
    const world = {...room, title: "", realism: null, tiles: [], walls: [], boxes: [], rounds: [], goals: []}
    expect(play(held, hear({op: "world", world})).state.room.world?.name).toBe("Kitchen")
    const back = play(held, robot({link: "gone"}), hear({op: "world", world})).state
    expect(back.room.world?.name).toBe("room")
  })

  it("has neither pause nor steps nor hands, also when somebody looks back", () => {
    const moved = play(driving, frame(1, 0), frame(1, 1)).state
    const events: readonly PageEvent[] = [
      {kind: "pause-pressed"},
      {kind: "forward-pressed"},
      {kind: "looked-back", time: 0},
      {kind: "hand", hand: {press: "Button0"}},
    ]
    expect(play(moved, ...events).ops).toEqual([])
  })

  it("drives from Run to the end of the run, and only then must somebody watch", () => {
    expect([drives(held), drives(driving), drives(open)]).toEqual([false, true, false])
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
