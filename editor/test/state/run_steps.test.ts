/// Steps of a recorded run, and the blocks that run at one of them.

import {expect, it} from "vitest"
import {emptyProgram} from "../../src/program/program.ts"
import type {Frame} from "../../src/state/messages/messages.ts"
import {initialState} from "../../src/state/page_state.ts"
import {emptyRecording, record} from "../../src/state/runs/recording.ts"
import {begunAt, stepAfter, stepBefore, stepsOf} from "../../src/state/runs/run_steps.ts"
import {runningBlocks} from "../../src/values/running_blocks.ts"

/// One frame for each list of functions, `every` steps of 20 ms apart.
function recorded(frames: readonly (readonly string[])[], every = 1) {
  return frames
    .map((fired, i): Frame => {
      const step = i * every
      return {run: 1, step, time: step / 50, x: 0, y: 0, theta: 0, channels: {}, fired} as unknown as Frame
    })
    .reduce(record, emptyRecording)
}
const times = (...args: Parameters<typeof recorded>) =>
  stepsOf(recorded(...args)).map(({time, names}) => `${time} ${names.join(" ")}`)

it("a step is where another function begins to fire", () => {
  expect(times([["drive"], ["drive"], ["drive", "turn"], ["turn"], ["turn"], ["turn", "drive"]])).toEqual([
    "0 drive",
    "0.04 turn",
    "0.1 drive",
  ])
})

it("two steps of the same name are two, at the speed of the run", () => {
  expect(times([["drive"], ["drive"], ["drive", "drive"], ["drive"]])).toEqual(["0 drive", "0.04 drive"])
  // A fast run tells of several firings in each frame.
  expect(times([["drive"], ["drive", "drive"], ["drive"]], 8)).toEqual(["0 drive"])
})

it("a reaction begins anew after a pause, and not for a gap of a frame", () => {
  const silence = Array<readonly string[]>(8).fill([])
  expect(times([["bump"], [], ["bump"], ...silence, ["bump"]])).toEqual(["0 bump", "0.22 bump"])
})

it("says of each frame what begins in it, as the steps of the whole run do", () => {
  for (const every of [1, 8]) {
    const silence = Array<readonly string[]>(4).fill([])
    const frames = [["a"], ["a"], ["a", "b"], ["b"], ["b", "b"], ...silence, ["a"], [], ["a"]]
    const recording = recorded(frames, every)
    const begun = frames.map((_, i) => begunAt(recording, (i * every) / 50))
    const steps = frames.map((_, i) => stepsOf(recording).find(step => step.time === (i * every) / 50))
    expect(begun).toEqual(steps.map(step => step?.names ?? []))
  }
})

it("goes to the step before and after a moment, also from between two", () => {
  const recording = recorded([["drive"], ["drive"], ["turn"], ["turn"]])
  expect(stepAfter(recording, 0)?.time).toBe(0.04)
  expect(stepAfter(recording, 0.04)).toBeNull()
  expect(stepBefore(recording, 0.06)?.time).toBe(0.04)
  expect(stepBefore(recording, 0.04)?.time).toBe(0)
  expect(stepBefore(recording, 0)).toBeNull()
})

it("the block of the step that begins runs: a definition, or the call of a ready-made task with what it takes", () => {
  const text = "path = drive 50 >> turn 90 >> driver\n"
  const program = {
    ...emptyProgram,
    text,
    definitions: [{name: "path", start: 0, end: text.length, block: "path"}],
    spans: [
      {start: 7, end: 15, block: "drive 50"},
      {start: 7, end: 12, block: "name"},
      {start: 19, end: 26, block: "turn 90"},
      {start: 30, end: 36, block: "driver"},
    ],
  }
  const at = (lookedAt: number | null, source = text) => {
    const recording = recorded([["drive"], ["drive"], ["drive", "turn"], ["path"]])
    const room = {...initialState.room, recording, lookedAt, source, frame: null}
    return runningBlocks({room, document: {...initialState.document, program}})
  }
  expect(at(0.02)).toEqual({blocks: ["drive 50"], ranges: [{start: 7, end: 15}], isAtStep: false})
  expect(at(0.04)).toEqual({blocks: ["turn 90"], ranges: [{start: 19, end: 26}], isAtStep: true})
  expect(at(0.06).blocks).toEqual(["path"])
  expect(at(null).blocks).toEqual([])
  expect(at(0.04, "another text").blocks).toEqual([])
})
