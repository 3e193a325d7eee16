/// The room as the page's state has it: its editor, its files, its luck.

import {describe, expect, it} from "vitest"
import {next} from "../../src/state/next.ts"
import {firstPage, type PageEvent, type PageState} from "../../src/state/page.ts"
import {goalsOf} from "../../src/state/room.ts"
import type {World} from "../../src/worlds/world.ts"
import {emptyRoom} from "../worlds/worlds.ts"

const open: PageState = {
  ...firstPage,
  link: "open",
  worlds: ["room"],
  room: {...firstPage.room, world: {...emptyRoom, name: "room"}},
}

/// The state after some events, and all that was sent on the way.
function after(state: PageState, ...events: readonly PageEvent[]) {
  const sent: unknown[] = []
  let now = state
  for (const event of events) {
    const step = next(now, event)
    now = step.state
    sent.push(...step.orders.flatMap(order => (order.kind === "send" ? [order.message] : [])))
  }
  return {state: now, sent}
}

const withWall: World = {...emptyRoom, name: "room", walls: [{from: [3, 1], to: [3, 3]}]}
const drawWall: PageEvent = {kind: "world-edited", edit: {kind: "change", world: withWall}}

describe("the world editor on the page", () => {
  it("gives the changed room a name of its own, sends it, and saves it with the program", () => {
    const {state, sent} = after(open, {kind: "world-editor-opened"}, drawWall, {
      kind: "world-editor-closed",
      keep: true,
    })
    expect(state.worldEditor).toBeNull()
    expect(state.worldName).toMatchObject({name: "my room", walls: [{from: [3, 1], to: [3, 3]}]})
    expect(state.saved).toBe("changed")
    expect(sent).toEqual([{op: "world", world: state.worldName}])
  })

  it("changes nothing when it is left, or when nothing was drawn", () => {
    const left = after(open, {kind: "world-editor-opened"}, drawWall, {
      kind: "world-editor-closed",
      keep: false,
    })
    const same = after(open, {kind: "world-editor-opened"}, {kind: "world-editor-closed", keep: true})
    for (const {state, sent} of [left, same]) {
      expect(state).toEqual(open)
      expect(sent).toEqual([])
    }
  })

  it("stays open while the robot could not start in the room", () => {
    const onRobot = {...withWall, walls: [{from: [1, 2], to: [2, 2]}] as const}
    const {state, sent} = after(
      open,
      {kind: "world-editor-opened"},
      {kind: "world-edited", edit: {kind: "change", world: onRobot}},
      {kind: "world-editor-closed", keep: true},
    )
    expect(state.worldEditor?.world).toEqual(onRobot)
    expect(sent).toEqual([])
  })
})

describe("a room from a file", () => {
  const read = (text: string | null): PageEvent => ({kind: "world-file-read", name: "hall.json", text})

  it("is the room now, or goes into the open editor, where it can be undone", () => {
    const file = JSON.stringify({size: [4, 4], start: {x: 2, y: 2}})
    expect(after(open, read(file)).sent).toMatchObject([{op: "world", world: {size: [4, 4]}}])
    const {state, sent} = after(open, {kind: "world-editor-opened"}, read(`\uFEFF${file}`))
    expect(state.worldEditor?.world.size).toEqual([4, 4])
    expect(state.worldEditor?.past).toHaveLength(1)
    expect(sent).toEqual([])
  })

  it.each([
    [null, ""],
    ["{", ""],
    ["[]", ""],
    ['{"size":[4,4]}', "start"],
    ['{"size":[4,4],"start":{"x":0,"y":0}}', "start"],
    ['{"size":[4,4],"start":{"x":2,"y":2},"rounds":[{"x":1,"y":1,"r":-1}]}', "rounds[0].r"],
  ])("%s is explained and changes nothing", (text, path) => {
    const {state, sent} = after(open, read(text))
    expect(state.notice).toMatchObject({kind: "unreadable-world", name: "hall.json", path})
    expect({...state, notice: null}).toEqual(open)
    expect(sent).toEqual([])
  })
})

describe("the luck of a run", () => {
  it("is new when it is thrown, and the same when it is not", () => {
    const {sent} = after(
      open,
      {kind: "run-pressed", seed: 7},
      {kind: "run-pressed"},
      {kind: "run-pressed", seed: 8},
    )
    expect(sent).toMatchObject([{seed: 7}, {seed: 7}, {seed: 8}])
  })
})

describe("the goals of a room", () => {
  it("are shown as open before a run", () => {
    const goal = {kind: "reach", title: "Here", within: null, x: 1, y: 1, r: 1} as const
    const room = {...open.room, world: {...emptyRoom, goals: [goal]}}
    expect(goalsOf(room)).toEqual([{kind: "reach", title: "Here", state: "open", progress: 0, time: null}])
  })
})
