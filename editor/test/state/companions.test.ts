/// Several robots in one room: where they start, what the service is asked for, and what the console says of them.

import {describe, expect, it} from "vitest"
import {lacksPreview, mayPreview} from "../../src/reducers/preview_requests.ts"
import {readServiceMessage} from "../../src/state/messages/message_decoder.ts"
import {initialState, type PageState} from "../../src/state/page_state.ts"
import {type Companion, freePlace, isFreePlace} from "../../src/state/runs/companions.ts"
import {CompanionMotions} from "../../src/views/room/robots/companion_drawing.ts"
import {words} from "../../src/words/index.ts"
import type {World} from "../../src/worlds/world.ts"
import {emptyRoom} from "../worlds/worlds.ts"
import {document, ended, frame, hear, play, press, running, text} from "./event_player.ts"

const companion: Companion = {x: 1, y: 3, theta: 0, program: null}
const other: Companion = {x: 3, y: 3, theta: 1, program: {id: "p", name: "Square", text: "main = square\n"}}
const room: World = {...emptyRoom, name: "room"}
const open: PageState = {
  ...initialState,
  link: "open",
  document,
  room: {...initialState.room, world: room, idle: true},
}
const chosen = (...companions: readonly Companion[]) => ({kind: "companions-chosen", companions}) as const

describe("a place to start", () => {
  it("is free floor, apart from walls and from other robots", () => {
    const {start} = room
    expect(isFreePlace(room, {...start, y: start.y + 0.2}, [])).toBe(false)
    expect(isFreePlace(room, {...start, y: start.y + 0.4}, [])).toBe(true)
    expect(isFreePlace(room, {...start, y: start.y + 0.4}, [{...start, y: start.y + 0.6}])).toBe(false)
    expect(isFreePlace(room, {x: 0.05, y: 1, theta: 0}, [])).toBe(false)
  })

  it("is found beside the first robot, for each one more", () => {
    let taken: readonly Companion[] = []
    for (let i = 0; i < 3; i++) {
      const place = freePlace(room, taken)
      expect(place).not.toBeNull()
      if (place !== null) {
        expect(isFreePlace(room, place, taken)).toBe(true)
        taken = [...taken, {...place, program: null}]
      }
    }
  })

  it("is none where the room is full", () => {
    const narrow: World = {...room, size: [0.5, 0.5], start: {x: 0.25, y: 0.25, theta: 0}}
    expect(freePlace(narrow, [])).toBeNull()
  })
})

describe("a run with other robots", () => {
  it("asks for each with its program: the open one, or the chosen one of the learner", () => {
    const {sent} = play(open, chosen(companion, other), press)
    expect(sent).toMatchObject([
      {
        op: "run",
        companions: [
          {source: text, x: 1, y: 3, theta: 0},
          {source: "main = square\n", x: 3, y: 3, theta: 1},
        ],
      },
    ])
  })

  it("is one without them where there are none", () => {
    expect(play(open, press).sent[0]).not.toHaveProperty("companions")
  })

  it("says on the console what they said and why they ended, with their numbers", () => {
    const problem = {severity: "error", kind: "no-place", message: "No place.", hint: "", ghc: ""}
    const heard = [
      {op: "companion-said", run: 1, robot: 1, time: 0.5, text: "hello"},
      {op: "companion-ended", run: 1, robot: 2, time: 1, problem},
      {op: "companion-ended", run: 1, robot: 1, time: 2, problem: null},
      {op: "companion-said", run: 7, robot: 1, time: 0.5, text: "of another run"},
    ].map(message => {
      const read = readServiceMessage(JSON.stringify(message))
      if (read.kind !== "ok") throw new Error("expected a message")
      return hear(read.value)
    })
    const {state} = play(open, chosen(companion, other), press, running(1), ...heard)
    expect(state.lines.map(({kind, text}) => [kind, text])).toEqual([
      ["companion", "Robot 2: hello"],
      ["companion", "Robot 3 stands still: No place."],
      ["companion", "Robot 2 has finished its program and stands still."],
    ])
    // The bubble is the first robot's.
    expect(state.room.words).toEqual([])
  })

  it("keeps where they were, in each frame that does not tell it anew", () => {
    const others = [[1, 2, 0]] as const
    const {state} = play(
      open,
      chosen(companion),
      press,
      running(1),
      frame(1, {others}),
      frame(1, {time: 0.04}),
    )
    expect(state.room.frame?.others).toEqual(others)
    expect(state.room.recording.length).toBe(2)
  })

  it("ends, and the room is as before a run, when other robots are chosen", () => {
    const {state, ops} = play(open, press, running(1), frame(1), chosen(companion))
    expect(ops).toEqual(["run", "reset"])
    expect(state.room.run).toBeNull()
    expect(state.companions).toEqual([companion])
  })

  it("has no preview of an edited program, and says so", () => {
    const ran = play(open, chosen(companion), press, running(1), frame(1), ended(1, "done")).state
    const edited = {...ran, document: {...document, program: {...document.program, text: `${text}\n`}}}
    expect(mayPreview(edited)).toBe(false)
    expect(lacksPreview(edited)).toBe(true)
    expect(lacksPreview({...edited, companions: []})).toBe(false)
    expect(lacksPreview(ran)).toBe(false)
  })
})

describe("a robot that is dragged", () => {
  const placed = (x: number, y: number, isDropped = true) =>
    ({kind: "companion-placed", companion: 0, place: {x, y, theta: 0}, isDropped}) as const

  it("goes to free floor, and stays where it was elsewhere and during a run", () => {
    const moved = play(open, chosen(companion, other), placed(1.5, 3)).state
    expect(moved.companions[0]).toMatchObject({x: 1.5, y: 3, program: null})
    expect(play(moved, placed(2.9, 3, false)).state).toMatchObject({
      notice: null,
      companions: moved.companions,
    })
    const taken = play(moved, placed(2.9, 3)).state
    expect(taken.companions[0]?.x).toBe(1.5)
    expect(taken.notice).toMatchObject({kind: "refusal", message: words.companions.taken})
    expect(play(taken, placed(1.4, 3)).state.notice).toBeNull()
    expect(play(moved, press, running(1), placed(1, 3)).state.companions[0]?.x).toBe(1.5)
  })
})

describe("another room", () => {
  it("has the robots where they have floor, in other places where not, and no more than it has floor for", () => {
    const walled: World = {...room, boxes: [{x: 1, y: 3, w: 1, h: 1, theta: 0, movable: false, mass: 1}]}
    const {state} = play(open, chosen(companion, other), hear({op: "world", world: walled}))
    expect(state.companions[1]).toEqual(other)
    expect(state.companions[0]?.x === 1 && state.companions[0].y === 3).toBe(false)
    const narrow: World = {...room, size: [0.5, 0.5], start: {x: 0.25, y: 0.25, theta: 0}}
    const crowded = play(open, chosen(companion), hear({op: "world", world: narrow})).state
    expect(crowded.companions).toEqual([])
    expect(crowded.notice).toMatchObject({message: words.companions.noPlace})
  })
})

describe("the picture", () => {
  it("has them between two frames of a run, and none without a frame", () => {
    const motions = new CompanionMotions()
    const at = (x: number) => ({run: 1, others: [[x, 1, 0] as const]})
    expect(motions.posesAt(null, true, 0)).toBeNull()
    expect(motions.posesAt(at(1), true, 0)).toMatchObject([{x: 1}])
    const next = at(1.1)
    motions.posesAt(next, true, 20)
    expect(motions.posesAt(next, true, 30)?.[0]?.x).toBeCloseTo(1.05)
    expect(motions.posesAt({run: 2}, true, 40)).toEqual([])
  })
})
