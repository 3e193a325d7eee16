/// Labels at definitions: the values of the displayed moment, when they are old or unknown, and how long ones are folded.

import {describe, expect, it} from "vitest"
import {emptyDocument} from "../../src/program/history.ts"
import type {Frame} from "../../src/state/messages/messages.ts"
import {initialState, type PageState} from "../../src/state/page_state.ts"
import {addFrame} from "../../src/state/runs/room_state.ts"
import {definitionQuestion, longestText, valueLabels} from "../../src/values/value_labels.ts"
import type {FiringShown} from "../../src/wire/page/explanations.generated.ts"
import {measures, words} from "../../src/words/index.ts"

const firing = (n: number, time: number, more: Partial<FiringShown> = {}): FiringShown => ({
  n,
  time,
  function: "bump",
  task: 0,
  cause: {by: "message", value: "", instant: null, event: null, firing: null},
  took: [
    {
      from: "event",
      value: "Bumper CenterBumper Pressed",
      type: "",
      firing: null,
      channel: "",
      instant: null,
      read: null,
    },
  ],
  gave: [{to: "memory", value: "True", type: "Memory Hit", event: null}],
  branches: [],
  ...more,
})

const frame = (time: number, firings: readonly FiringShown[] = [], more: Partial<Frame> = {}): Frame => ({
  run: 1,
  step: time * 50,
  time,
  x: 1,
  y: 1,
  theta: 0,
  channels: {},
  fired: firings.map(f => f.function),
  sensed: [],
  boxes: null,
  ghost: null,
  memory: null,
  ...(firings.length === 0 ? {} : {firings}),
  ...more,
})

const unit = {kind: "type", written: "()", spelled: "()", own: false, topic: null} as const
const part = (name: string) => ({kind: "function", name, at: null, inputs: [], output: unit}) as const
const names = ["Hit", "bump", "drive", "helper"]
const definitions = names.map((name, i) => ({name, start: 10 * i, end: 10 * i + 8, block: `b${i}`}))

function stateOf(...frames: readonly Frame[]): PageState {
  const document = {...emptyDocument, program: {...emptyDocument.program, definitions}}
  const network = {text: "", parts: [part("bump"), part("drive")]}
  const room = frames.reduce(addFrame, {...initialState.room, run: 1})
  return {...initialState, valuesShown: true, document, network, room}
}

const labels = (state: PageState) =>
  valueLabels(state, words.why, measures).map(({definition, text, isOld}) => [definition.name, text, isOld])

const pressed = "Bumper CenterBumper Pressed → Memory True"

describe("values at a moment", () => {
  it("are what each function took last and gave, and what a memory holds", () => {
    const state = stateOf(
      frame(0),
      frame(0.5, [firing(1, 0.48)], {memory: [{type: "Memory Hit", value: "True"}]}),
    )
    expect(labels(state)).toEqual([
      ["Hit", "True", false],
      ["bump", pressed, false],
      ["drive", "not yet", true],
    ])
  })

  it("are those of then when the learner looks back", () => {
    const state = stateOf(
      frame(0),
      frame(0.5, [firing(1, 0.5)]),
      frame(1, [firing(2, 1, {gave: [{to: "memory", value: "False", type: "Memory Hit", event: null}]})]),
    )
    const at = (lookedAt: number | null) =>
      labels({...state, room: {...state.room, lookedAt}}).find(([name]) => name === "bump")
    expect(at(0.2)).toEqual(["bump", "not yet", true])
    expect(at(0.7)).toEqual(["bump", pressed, false])
    expect(at(null)).toEqual(["bump", "Bumper CenterBumper Pressed → Memory False", false])
  })

  it("ask why they are so, shown or not", () => {
    const memory = [{type: "Memory Hit", value: "True"}]
    const state = {...stateOf(frame(0), frame(0.5, [firing(1, 0.48)], {memory})), valuesShown: false}
    expect(names.map((_, i) => definitionQuestion(state, `b${i}`))).toEqual([
      {kind: "memory", type: "Memory Hit", time: 0.5},
      {kind: "run", function: "bump", time: 0.5},
      {kind: "not", function: "drive", command: "", since: 0, until: 0.5},
      null,
    ])
    const before = {...state, room: {...state.room, lookedAt: 0.2}}
    expect(definitionQuestion(before, "b1")).toMatchObject({kind: "not", function: "bump", until: 0.2})
    expect(definitionQuestion(initialState, "b1")).toBeNull()
  })

  it("that are older than a second are grey and have their time", () => {
    const [label] = labels(stateOf(frame(0), frame(2, [firing(1, 0.5, {took: []})])))
    expect(label).toEqual(["bump", "→ Memory True  0.50 s", true])
  })

  it.each<[string, Partial<FiringShown>]>([
    ["→ nothing", {took: [], gave: []}],
    [
      "→ Velocity 0.5 0.0",
      {took: [], gave: [{to: "command", value: "Velocity 0.5 0.0", type: "", event: null}]},
    ],
    [
      "Seconds 0.3 → Memory (Velocity 1.0 0.0)",
      {
        took: [
          {
            from: "time",
            value: "Seconds 0.30000000000000004",
            type: "",
            firing: null,
            channel: "",
            instant: null,
            read: null,
          },
        ],
        gave: [{to: "memory", value: "Velocity 1.0 0.0", type: "Memory Velocity", event: null}],
      },
    ],
    [
      "Memory (Int -> Int) → Step, Done",
      {
        took: [
          {
            from: "memory",
            value: "_",
            type: "Memory (Int -> Int)",
            firing: null,
            channel: "",
            instant: null,
            read: null,
          },
        ],
        gave: [
          {to: "event", value: "_", type: "Step", event: null},
          {to: "done", value: "", type: "", event: null},
        ],
      },
    ],
  ])("are written as %s", (text, more) => {
    expect(labels(stateOf(frame(0), frame(0.5, [firing(1, 0.5, more)])))[0]).toEqual(["bump", text, false])
  })

  it("of a memory stand at the synonym of its type", () => {
    const text = "type Hit = Bool\n"
    const hit = {name: "Hit", start: 0, end: 15, block: "b0"}
    const state = stateOf(frame(0), frame(0.5, [], {memory: [{type: "Memory Bool", value: "False"}]}))
    const program = {...state.document.program, text, definitions: [hit]}
    expect(labels({...state, document: {...state.document, program}})).toEqual([["Hit", "False", false]])
  })

  it("that are long are folded, and told whole", () => {
    const value = `Path [${Array.from({length: 40}, (_, i) => i).join(", ")}]`
    const state = stateOf(
      frame(0),
      frame(0.5, [
        firing(1, 0.5, {
          took: [{from: "event", value, type: "", firing: null, channel: "", instant: null, read: null}],
        }),
      ]),
    )
    const [label] = valueLabels(state, words.why, measures)
    expect(label?.text).toBe("Path [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 1… → Memory True")
    expect(label?.text.length).toBeLessThanOrEqual(longestText)
    expect(label?.whole).toBe(`${value} → Memory True`)
  })

  it("are not claimed where they were not recorded", () => {
    const state = stateOf(frame(0), frame(0.5, [], {fired: ["bump"]}))
    expect(labels(state)).toEqual([["drive", "not yet", true]])
  })

  it("are not there while they are not shown, before a run and for a program without mistakes unknown", () => {
    const state = stateOf(frame(0), frame(0.5, [firing(1, 0.5)]))
    expect(labels({...state, valuesShown: false})).toEqual([])
    expect(labels({...state, room: {...state.room, run: null}})).toEqual([])
    expect(labels({...state, network: null})).toEqual([["bump", pressed, false]])
  })
})
