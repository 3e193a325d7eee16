/// What opening, changing and undoing do, also when another tab changes the program.

import {describe, expect, it} from "vitest"
import {type Document, emptyDocument, emptyHistory} from "../../src/program/history.ts"
import type {PageEvent} from "../../src/state/page_events.ts"
import {initialState} from "../../src/state/page_state.ts"
import {noticeText} from "../../src/ui/descriptions.ts"
import {document, hello, open, play, press, program, running, text} from "./event_player.ts"

describe("a program that is opened", () => {
  const opened = (world: string | null) => ({
    kind: "opened" as const,
    opened: {name: "new", world, document, history: emptyHistory, welcome: false, isNew: false},
  })

  it("brings its room", () => {
    const {state, sent} = play({...open, worldName: "corridor"}, opened("maze"))
    expect(state.worldName).toBe("maze")
    expect(sent).toContainEqual({op: "world", world: "maze"})
  })

  it("closes the dialog it was chosen in; the first of the page leaves open what was opened before it arrived", () => {
    const chosen = opened(null)
    const first: PageEvent = {...chosen, opened: {...chosen.opened, isFirst: true}}
    const inDialog: PageEvent = {kind: "dialog", dialog: "robots"}
    expect(play(initialState, hello, inDialog, first).state.dialog).toBe("robots")
    expect(play(initialState, hello, inDialog, first, inDialog, chosen).state.dialog).toBeNull()
  })

  it("brings the places of the diagram's nodes, and moving one is a change to be stored", () => {
    const places = {go: [10, 20]} as const
    const {state} = play(open, {...opened(null), opened: {...opened(null).opened, places}})
    expect([state.diagram.places, state.saved]).toEqual([places, "saved"])
    const moved = play(state, {kind: "nodes-moved", places: {go: [30, 20]}}).state
    expect([moved.diagram.places, moved.saved]).toEqual([{go: [30, 20]}, "changed"])
    expect(play(moved, opened(null)).state.diagram.places).toEqual({})
  })

  it("that is new runs at the usual speed", () => {
    const blank: PageEvent = {
      kind: "opened",
      opened: {name: "", world: "room", document, history: emptyHistory, welcome: false, isNew: true},
    }
    expect(play({...open, speed: 5}, blank).state.speed).toBe(1)
  })

  it("without a room of its own takes the one it is opened in, also after the connection was lost", () => {
    const {state, ops} = play({...open, worldName: "corridor"}, opened(null))
    expect(state.worldName).toBe("corridor")
    expect(ops).toEqual(["reset", "check"])
    expect(play(state, {kind: "link-lost"}, hello).sent).toContainEqual({op: "world", world: "corridor"})
  })
})

it("the chosen node of the diagram stays chosen in a new drawing that has it", () => {
  const node = {kind: "command", key: "Velocity"}
  const drawn = (...nodes: readonly (typeof node)[]): PageEvent => ({
    kind: "diagram",
    outcome: "drawn",
    nodes,
  })
  const chosen = play(open, {kind: "node-chosen", node}).state
  expect(play(chosen, drawn({kind: "event", key: "Bumper"}, {...node})).state.diagram.chosen).toEqual(node)
  expect(play(chosen, drawn({kind: "state", key: "Velocity"})).state.diagram.chosen).toBeNull()
  expect(play(chosen, {kind: "diagram", outcome: "failed"}).state.diagram.chosen).toBeNull()
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

describe("another tab stored the open program", () => {
  const theirs: Document = {...emptyDocument, program: {...emptyDocument.program, text: "main = simulate go"}}
  const followed = (world: string | null): PageEvent => ({
    kind: "followed",
    name: "walk",
    world,
    replacedRoom: null,
    document: theirs,
    at: 5,
  })

  it("shows it as saved, checks it, and can undo to what stood here", () => {
    const {state, ops} = play(initialState, hello, followed(null))
    expect(state.document).toBe(theirs)
    expect([state.name, state.saved]).toEqual(["walk", "saved"])
    expect(state.history.past).toEqual([emptyDocument])
    expect(ops.at(-1)).toBe("check")
  })

  it("goes to its room, but not while a program runs here", () => {
    expect(play(initialState, hello, followed("maze")).sent).toContainEqual({op: "world", world: "maze"})
    const during = play(initialState, hello, {...press, seed: 1}, running(1), followed("maze"))
    expect(during.ops).not.toContain("world")
    expect(during.state.run.kind).toBe("running")
    expect(during.state.worldName).toBe(initialState.worldName)
  })
})

describe("a program that cannot be stored", () => {
  it("is said together with the deleted programs that made way for it, as often as it fails", () => {
    const gone: PageEvent = {kind: "notice", notice: {kind: "made-way", gone: ["walk", "turn"]}}
    const failed: PageEvent = {kind: "stored", ok: false}
    const {state} = play(open, gone, failed, failed)
    expect(state.notice).toEqual({kind: "not-saved", gone: ["walk", "turn"]})
    const {hint} = noticeText(state.notice!)
    expect(hint).toContain("walk, turn")
    expect(hint).toContain("My programs")
    expect(play(open, failed).state.notice).toEqual({kind: "not-saved", gone: []})
  })

  it("leaves the notice about programs that made way where it found room", () => {
    const notice = {kind: "made-way", gone: ["walk"]} as const
    expect(play(open, {kind: "notice", notice}, {kind: "stored", ok: true}).state.notice).toEqual(notice)
  })
})

describe("a new learner is asked how to begin", () => {
  const opened = (isFirstVisit: boolean): PageEvent => ({
    kind: "opened",
    opened: {
      name: "",
      world: null,
      document,
      history: emptyHistory,
      welcome: true,
      isNew: false,
      isFirstVisit,
    },
  })
  const after = (...events: readonly PageEvent[]) => play(initialState, ...events).state.welcoming
  it("on the first visit, until another program is opened, run, or the question is closed", () => {
    expect(after(opened(true))).toBe(true)
    expect(after(opened(false))).toBe(false)
    expect(after(opened(true), opened(false))).toBe(false)
    expect(after(opened(true), {kind: "run-pressed", seed: 1})).toBe(false)
    expect(after(opened(true), {kind: "welcoming", welcoming: false})).toBe(false)
  })
})
