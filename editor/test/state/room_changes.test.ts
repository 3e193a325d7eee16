/// The room as the page's state has it: its editor, its files, its luck.

import {describe, expect, it} from "vitest"
import {newDraft} from "../../src/lesson_files/draft.ts"
import {emptyDocument, emptyHistory} from "../../src/program/history.ts"
import {reduce} from "../../src/reducers/reducer.ts"
import type {PageEvent} from "../../src/state/page_events.ts"
import {initialState, type PageState, type ReplacedRoom} from "../../src/state/page_state.ts"
import {goalsOf} from "../../src/state/runs/room_state.ts"
import type {World} from "../../src/worlds/world.ts"
import {emptyRoom} from "../worlds/worlds.ts"

const open: PageState = {
  ...initialState,
  link: "open",
  worlds: ["room"],
  room: {...initialState.room, world: {...emptyRoom, name: "room"}},
}

/// The state after some events, and all that was sent on the way.
function after(state: PageState, ...events: readonly PageEvent[]) {
  const sent: unknown[] = []
  let now = state
  for (const event of events) {
    const step = reduce(now, event)
    now = step.state
    sent.push(...step.effects.flatMap(order => (order.kind === "send" ? [order.message] : [])))
  }
  return {state: now, sent}
}

const withWall: World = {...emptyRoom, name: "room", walls: [{from: [3, 1], to: [3, 3]}]}
const drawWall: PageEvent = {kind: "world-edited", edit: {kind: "change", world: withWall}}

describe("the robot of the room", () => {
  it("changes with the room as it is, and is sent and saved with the program", () => {
    const world: World = {...emptyRoom, name: "room", robot: "turtlebot3"}
    const {state, sent} = after(open, {kind: "world-taken", world})
    expect(state.room.world?.robot).toBe("turtlebot3")
    expect(state.worldName).toMatchObject({name: "room", robot: "turtlebot3"})
    expect(sent).toEqual([{op: "world", world: state.worldName}])
  })

  it("stays when it has no place at the start, and the notice says why", () => {
    const narrow = {...emptyRoom, start: {x: 0.15, y: 2, theta: 0}}
    const before: PageState = {...open, room: {...open.room, world: {...narrow, robot: "turtlebot3"}}}
    const {state, sent} = after(before, {kind: "world-taken", world: {...narrow, robot: "kobuki"}})
    expect(state.room.world?.robot).toBe("turtlebot3")
    expect(state.notice).toMatchObject({why: expect.stringContaining("it needs 0.35 metres")})
    expect(sent).toEqual([])
  })
})

describe("the world editor on the page", () => {
  it("gives the changed room to the lesson that is being written", () => {
    const draft = newDraft("lesson-1", "en", {size: [4, 3]}, "main = simulate ()\n")
    const {state} = after(
      open,
      {kind: "lesson", event: {kind: "draft-opened", draft}},
      {kind: "world-editor-opened"},
      drawWall,
      {kind: "world-editor-closed", keep: true},
    )
    expect(state.lessons.drafts[0]?.room).toEqual(state.worldName)
    expect(state.worldName).toMatchObject({name: "my room"})
  })

  it("gives the changed room a name of its own, sends it, and saves it with the program", () => {
    const {state, sent} = after(open, {kind: "world-editor-opened"}, drawWall, {
      kind: "world-editor-closed",
      keep: true,
    })
    expect(state.worldEditor).toBeNull()
    expect(state.worldName).toMatchObject({
      name: "my room",
      title: "room, changed",
      walls: [{from: [3, 1], to: [3, 3]}],
    })
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
  const read = (text: string): PageEvent => ({kind: "world-file-read", name: "hall.json", text})

  it("is the room now, or goes into the open editor, where it can be undone", () => {
    const file = JSON.stringify({size: [4, 4], start: {x: 2, y: 2}})
    expect(after(open, read(file)).sent).toMatchObject([{op: "world", world: {size: [4, 4]}}])
    const {state, sent} = after(open, {kind: "world-editor-opened"}, read(`\uFEFF${file}`))
    expect(state.worldEditor?.world.size).toEqual([4, 4])
    expect(state.worldEditor?.past).toHaveLength(1)
    expect(sent).toEqual([])
  })

  it.each([
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

describe("a room of a test", () => {
  const opens = (name: string): PageEvent => ({kind: "test-room-opened", world: {...emptyRoom, name}})
  const back: PageEvent = {kind: "own-room-restored"}
  const mine = after(open, {kind: "world-editor-opened"}, drawWall, {kind: "world-editor-closed", keep: true})
  const opened = (world: string | null, replacedRoom: ReplacedRoom | null): PageEvent => ({
    kind: "opened",
    opened: {
      name: "walk",
      world,
      replacedRoom,
      document: emptyDocument,
      history: emptyHistory,
      welcome: false,
      isNew: false,
    },
  })

  it("gives way to the learner's own room, however many rooms of tests were opened", () => {
    const {state, sent} = after(mine.state, opens("pits 3"), opens("pits 5"), back)
    expect(state.worldName).toEqual(mine.state.worldName)
    expect(state.replacedRoom).toBeNull()
    expect(sent.at(-1)).toEqual({op: "world", world: mine.state.worldName})
    expect(state.saved).toBe("changed")
  })

  it("gives way to a room of the gallery, and to the first room where the program names none", () => {
    expect(after({...open, worldName: "maze"}, opens("pits 3"), back).state.worldName).toBe("maze")
    expect(after({...open, worldName: null}, opens("pits 3"), back).state.worldName).toBe("room")
  })

  it("replaces what was chosen since the last room of a test", () => {
    const chosen = after(mine.state, opens("pits 3"), {kind: "world-chosen", world: "maze"}, opens("pits 5"))
    expect(chosen.state.replacedRoom).toEqual({by: "pits 5", own: "maze"})
  })

  it("belongs to its program: another one with a room has its own", () => {
    const away = after(mine.state, opens("pits 3"), opened("maze", null))
    expect(away.state.replacedRoom).toBeNull()
    expect(after(away.state, back).state.worldName).toBe("maze")
    const again = {by: "pits 3", own: "corridor"}
    expect(after(away.state, opened("pits 3", again), back).state.worldName).toBe("corridor")
  })

  it("can be left from a program without a room, which is opened in the room of the test", () => {
    const {state} = after(mine.state, opens("pits 3"), opened(null, null), back)
    expect(state.worldName).toEqual(mine.state.worldName)
  })
})
