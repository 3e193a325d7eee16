/// When a preview is asked for, which answers are taken, and when a preview is forgotten.

import {describe, expect, it} from "vitest"
import {type Document, emptyDocument, emptyHistory} from "../../src/program/history.ts"
import {reduce} from "../../src/reducers/reducer.ts"
import type {Frame, ServiceMessage} from "../../src/state/messages/messages.ts"
import {type Preview, placeAt, shownPreview} from "../../src/state/messages/preview.ts"
import type {PageEvent} from "../../src/state/page_events.ts"
import {initialState, type PageState} from "../../src/state/page_state.ts"
import {previewInk} from "../../src/state/runs/preview_ink.ts"
import type {World} from "../../src/worlds/world.ts"

const documentOf = (text: string): Document => ({...emptyDocument, program: {...emptyDocument.program, text}})
const hear = (message: ServiceMessage): PageEvent => ({kind: "heard", message})
const edit = (text: string): PageEvent => ({
  kind: "program-changed",
  document: documentOf(text),
  by: "blocks",
  at: 0,
})
const run: PageEvent = {kind: "run-pressed", seed: 3}
const running = hear({op: "state", run: 1, state: "running"})
const ended = hear({op: "state", run: 1, state: "ended", ended: "stopped", problems: []})
const frame = (time: number): PageEvent =>
  hear({op: "frame", frame: {run: 1, step: 1, time, x: 1, y: 2, theta: 0, channels: {}, fired: [], sensed: [],
    boxes: null, ghost: null, memory: null} satisfies Frame}) // biome-ignore format: a table
const preview = (id: number, more: Partial<Preview> = {}): Preview => ({
  id, ended: "time", time: 10, x: 3, y: 2, theta: 0, path: [{time: 0, x: 1, y: 2}], collisions: [], goals: [], pen: [], ...more,
}) // biome-ignore format: a table
const answer = (id: number, more: Partial<Preview> = {}) =>
  hear({op: "previewed", preview: preview(id, more)})

const opened = {
  name: "other",
  world: null,
  document: documentOf("other"),
  history: emptyHistory,
  welcome: false,
  isNew: false,
}

function play(...events: readonly PageEvent[]) {
  let state: PageState = {...initialState, document: documentOf("old")}
  const asked: {id: number; source: string; seconds: number}[] = []
  const sent: string[] = []
  for (const event of [hear({op: "hello", session: "s"}), ...events]) {
    const step = reduce(state, event)
    state = step.state
    for (const e of step.effects) if (e.kind === "send") sent.push(e.message.op)
    for (const e of step.effects) if (e.kind === "send" && e.message.op === "preview") asked.push(e.message)
  }
  return {state, asked, sent, shown: shownPreview(state.room.preview)}
}

describe("a preview is asked for", () => {
  it("after each change, once a run has ended", () => {
    const {asked} = play(run, running, frame(4), ended, edit("a"), edit("b"))
    expect(asked.map(({id, source, seconds}) => [id, source, seconds])).toEqual([
      [1, "a", 10],
      [2, "b", 10],
    ])
  })
  it("for as long as the last run, as far as the service computes it", () => {
    expect(play(run, running, frame(42), ended, edit("a")).asked[0]?.seconds).toBe(42)
    expect(play(run, running, frame(1000), ended, edit("a")).asked[0]?.seconds).toBe(300)
  })
  it("while the run is paused or looked back at, and when it is paused after a change", () => {
    const pause = {kind: "pause-pressed"} as const
    expect(play(run, running, frame(4), pause, edit("a")).asked).toHaveLength(1)
    expect(play(run, running, frame(4), edit("a"), {kind: "looked-back", time: 2}).asked).toHaveLength(1)
    expect(play(run, running, frame(4), edit("a"), pause).asked).toHaveLength(1)
  })
  it.each([
    ["before the first run", [edit("a")]],
    ["while a run goes on", [run, running, frame(4), edit("a")]],
    ["while it compiles", [run, edit("a")]],
    ["for the program that ran", [run, running, ended, edit("old")]],
    ["for an empty program", [run, running, ended, edit("")]],
    ["when previews are off", [run, running, ended, {kind: "previewing", previewing: false}, edit("a")]],
    ["without the service", [run, running, ended, {kind: "link-lost"}, edit("a")]],
    ["after a reset", [run, running, ended, {kind: "reset-pressed"}, edit("a")]],
  ] as readonly (readonly [string, readonly PageEvent[]])[])("not %s", (_, events) =>
    expect(play(...events).asked).toEqual([]),
  )
  it("after the service has been told that it may be, when a run ends or stands still", () => {
    const told = (...events: readonly PageEvent[]) =>
      play(...events).sent.filter(op => op.endsWith("previews"))
    expect(told(run, running, frame(4), ended, edit("a"), edit("b"))).toEqual(["prepare-previews"])
    expect(told(run, running, frame(4), {kind: "pause-pressed"})).toEqual(["prepare-previews"])
    expect(told(edit("a"), run, running)).toEqual([])
    expect(told({kind: "previewing", previewing: false}, run, running, ended, edit("a"))).toEqual([])
  })
  it("as soon as it is typed, before the document has it, and not again", () => {
    const typed = {kind: "text-typed", text: "a"} as const
    expect(play(run, running, ended, typed).asked.map(({source}) => source)).toEqual(["a"])
    expect(play(run, running, ended, typed, edit("a"), edit("b")).asked.map(({source}) => source)).toEqual([
      "a",
      "b",
    ])
    expect(play(run, running, ended, typed, {kind: "dialog", dialog: null}).asked).toHaveLength(1)
  })
  it("not for what was typed into a program that is no longer open", () => {
    expect(play({kind: "text-typed", text: "a"}, {kind: "opened", opened}).state.pendingText).toBeNull()
  })
  it("when previews are switched on again", () => {
    const off = {kind: "previewing", previewing: false} as const
    const {asked} = play(run, running, ended, edit("a"), off, {kind: "previewing", previewing: true})
    expect(asked.map(({source}) => source)).toEqual(["a", "a"])
  })
})

describe("an answer", () => {
  const before = [run, running, frame(4), ended, edit("a")] as const
  it("is shown", () => {
    expect(play(...before, answer(1)).shown).toEqual({preview: preview(1), current: true})
  })
  it("is dropped when the program has changed since", () => {
    expect(play(...before, edit("b"), answer(1)).shown).toBeNull()
    expect(play(...before, edit("b"), answer(2), answer(1, {x: 9})).shown?.preview.x).toBe(3)
  })
  it("stays until the next has come, as an old one when that is late", () => {
    const late = {kind: "preview-late", id: 2} as const
    expect(play(...before, answer(1), edit("b")).shown).toEqual({preview: preview(1), current: true})
    expect(play(...before, answer(1), edit("b"), late).shown).toEqual({preview: preview(1), current: false})
    expect(play(...before, answer(1), edit("b"), late, answer(2)).shown?.current).toBe(true)
    expect(play(...before, answer(1), edit("b"), answer(2), late).shown?.current).toBe(true)
    expect(play(...before, answer(1), edit("b"), edit("c"), late).shown?.current).toBe(true)
  })
  it("is forgotten when the new program does not compile", () => {
    expect(play(...before, answer(1), edit("b"), answer(2, {ended: "refused"})).shown).toBeNull()
  })
  it("says that the last run cannot be repeated, until there is another run", () => {
    const unrepeatable = play(...before, answer(1, {ended: "unrepeatable", path: []}))
    expect(unrepeatable.shown).toBeNull()
    expect(unrepeatable.state.room.preview.answer?.unrepeatable).toBe(true)
    expect(play(...before, answer(1, {ended: "unrepeatable"}), run).state.room.preview.answer).toBeNull()
  })
  it("is forgotten when the change is taken back", () => {
    const {state, shown} = play(...before, answer(1), {kind: "undo-pressed"})
    expect([state.document.program.text, shown]).toEqual(["old", null])
  })
  const room = {name: "pits", size: [5, 4], start: {x: 1, y: 2, theta: 0}} as unknown as World
  it.each([
    ["a run", run],
    ["a reset", {kind: "reset-pressed"}],
    ["another program", {kind: "opened", opened}],
    ["another room", {kind: "world-chosen", world: "pits"}],
    ["a room from a file", {kind: "world-file-read", name: "pits", text: JSON.stringify(room)}],
    ["the end of the connection", {kind: "link-lost"}],
    ["the switch", {kind: "previewing", previewing: false}],
    ["a real robot", {kind: "robot-taken", robot: "Kitchen", who: "Ada"}],
  ] as readonly (readonly [string, PageEvent])[])(
    "is forgotten by %s, also when it comes late",
    (_, event) => {
      const held =
        event.kind === "robot-taken"
          ? [
              hear({
                op: "robot",
                robot: {name: "Kitchen", link: "connected", why: "", stopped: false, maxSpeed: 1, maxTurn: 1},
              }),
            ]
          : []
      const late = play(...before, event, ...held, answer(1))
      expect(late.shown).toBeNull()
      expect(play(...before, answer(1), event, ...held).shown).toBeNull()
    },
  )
})

describe("a place on a path", () => {
  const path = [
    {time: 0, x: 1, y: 2},
    {time: 0.5, x: 1.2, y: 2},
    {time: 3, x: 2, y: 2},
  ]
  it("is the last one before a time", () => {
    expect([0, 0.4, 0.5, 2.9, 9].map(time => placeAt(path, time)?.x)).toEqual([1, 1, 1.2, 1.2, 2])
    expect(placeAt([], 1)).toBeNull()
  })
})

describe("the ink of a preview", () => {
  const drawn = (pen: Preview["pen"]) =>
    previewInk({path: [0, 1, 2, 3, 4].map(time => ({time, x: 1 + time, y: 1})), pen})

  it("is none while the pen is up", () => {
    expect(drawn([])).toEqual([])
    expect(drawn([[1, 0, 2, 0.1]])).toEqual([])
  })

  it("has the colour and the width that the pen has from its time on", () => {
    const strokes = drawn([
      [1, 1, 1, 0.05],
      [3, 1, 4, 0.1],
    ])
    expect(strokes.map(({color, width, points}) => [color, width, points.map(p => p.x)])).toEqual([
      [1, 0.05, [1, 2, 3]],
      [4, 0.1, [3, 4, 5]],
    ])
  })

  it("ends where the pen goes up", () => {
    const [stroke, ...others] = drawn([
      [0, 1, 1, 0.05],
      [3, 0, 1, 0.05],
    ])
    expect(stroke?.points.map(p => p.x)).toEqual([1, 2, 3])
    expect(others).toEqual([])
  })
})
