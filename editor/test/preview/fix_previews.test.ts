/// When previews of fixes are asked for, which answers are taken, and when they are dropped.

import {describe, expect, it} from "vitest"
import {type Document, emptyDocument} from "../../src/program/history.ts"
import {reduce} from "../../src/reducers/reducer.ts"
import type {ServiceMessage} from "../../src/state/messages/messages.ts"
import type {Preview} from "../../src/state/messages/preview.ts"
import type {PageEvent} from "../../src/state/page_events.ts"
import {initialState, type PageState} from "../../src/state/page_state.ts"
import {finding} from "../state/finding.ts"

const documentOf = (text: string): Document => ({...emptyDocument, program: {...emptyDocument.program, text}})
const hear = (message: ServiceMessage): PageEvent => ({kind: "heard", message})
const edit = (text: string): PageEvent => ({
  kind: "program-changed",
  document: documentOf(text),
  by: "blocks",
  at: 0,
})
const shown = (texts: readonly string[], of = "old", list = "1"): PageEvent => ({
  kind: "fixes-offered",
  offered: {list, of, texts},
})
const answer = (id: number, path: Preview["path"] = [{time: 0, x: 1, y: 2}]) =>
  hear({
    op: "previewed",
    preview: {id, ended: "time", time: 10, x: 3, y: 2, theta: 0, path, collisions: [], goals: [], pen: []},
  })
const run: PageEvent = {kind: "run-pressed", seed: 3}
const ended = hear({op: "state", run: 1, state: "ended", ended: "stopped", problems: []}) // biome-ignore format: tables

function play(...events: readonly PageEvent[]) {
  let state: PageState = {...initialState, document: documentOf("old")}
  const asked: (readonly [number, string])[] = []
  const seconds = new Set<number>()
  const steps: readonly (PageEvent | "compiled")[] = [
    hear({op: "hello", session: "s"}),
    "compiled",
    ...events,
  ]
  for (const event of steps) {
    if (event === "compiled") {
      state = {...state, accepted: true}
      continue
    }
    const step = reduce(state, event)
    state = step.state
    for (const e of step.effects)
      if (e.kind === "send" && e.message.op === "preview") {
        asked.push([e.message.id, e.message.source])
        seconds.add(e.message.seconds)
      }
  }
  return {state, asked, seconds: [...seconds], answers: [...state.room.fixPreviews.answers.keys()]}
}

describe("previews of fixes are asked for", () => {
  it("one after another, the program first", () => {
    expect(play(shown(["a", "b"])).asked).toEqual([[1, "old"]])
    expect(play(shown(["a", "b"]), answer(1), answer(2), answer(3))).toMatchObject({
      asked: [[1, "old"], [2, "a"], [3, "b"]],
      answers: ["old", "a", "b"],
    }) // biome-ignore format: a table
  })
  it("for half a minute, in which the robot comes to a wall, the program as well as the fixes", () => {
    expect(play(shown(["a", "b"]), answer(1), answer(2)).seconds).toEqual([30])
  })
  it("once, also by two lists", () => {
    expect(play(shown(["a"]), shown(["a"], "old", "2"), answer(1), answer(2)).asked).toHaveLength(2)
  })
  it("no further when the list is no longer seen", () => {
    expect(play(shown(["a", "b"]), shown([]), answer(1)).asked).toHaveLength(1)
  })
  it("only about the program as it is", () => {
    expect(play(shown(["a"], "older")).asked).toEqual([])
  })
  it("not while a program runs, and after it once more, because it is another run", () => {
    expect(play(run, shown(["a"])).asked).toEqual([])
    expect(play(shown(["a"]), answer(1), answer(2), run, ended).asked.map(([, text]) => text)).toEqual([
      "old",
      "a",
      "old",
    ])
  })
  it("not when the program itself has no path", () => {
    expect(play(shown(["a"]), answer(1, [])).asked).toHaveLength(1)
  })
  it("not without the service", () => {
    expect(play({kind: "link-lost"}, shown(["a"])).asked).toEqual([])
  })
})

it("a process that computes them is wanted when a conflict appears, once", () => {
  const {program, ...rest} = documentOf("new")
  const conflict = {command: "Velocity", winner: "drive", loser: "backOff"}
  const document = {...rest, program, findings: [finding({severity: "warning", kind: "conflict", conflict})]}
  const wanted = (state: PageState) => {
    const step = reduce(state, {kind: "program-changed", document, by: "blocks", at: 0})
    return {state: step.state, ops: step.effects.flatMap(e => (e.kind === "send" ? [e.message.op] : []))}
  }
  const first = wanted(play().state)
  expect(first.ops).toContain("prepare-previews")
  expect(wanted(first.state).ops).not.toContain("prepare-previews")
})

describe("answers", () => {
  it("are dropped when the program changes, and a late one is not taken", () => {
    const {state, answers} = play(shown(["a"]), answer(1), edit("new"), answer(2))
    expect(answers).toEqual([])
    expect(state.room.fixPreviews.asked).toBeNull()
  })
  it("are dropped in another room", () => {
    const known = play(shown(["a"]), answer(1), answer(2)).state
    expect(known.room.fixPreviews.answers.size).toBe(2)
    expect(reduce(known, {kind: "reset-pressed"}).state.room.fixPreviews.answers.size).toBe(0)
  })
  it("without a path are known to be none", () => {
    expect(play(shown(["a"]), answer(1), answer(2, [])).state.room.fixPreviews.answers.get("a")).toBeNull()
  })
})
