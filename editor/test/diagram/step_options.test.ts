/// What can be done with steps of tasks, and what a drag of one can mean.

import type {WrittenTask} from "@rosy/codegen/network-edits"
import {describe, expect, it} from "vitest"
import {
  additions,
  dragOptions,
  newStep,
  stepAround,
  stepOptions,
} from "../../src/views/diagram/network/step_options.ts"

const task = (kind: WrittenTask["kind"], block: string, ...steps: readonly WrittenTask[]): WrittenTask => ({
  kind,
  block,
  name: kind === "step" ? block : "",
  turns: null,
  steps,
  result: null,
})
const step = (block: string) => task("step", block)
const tasks = [
  task(
    "sequence",
    "all",
    step("a"),
    task("repeat", "loop", step("b"), step("c")),
    task("race", "race", step("d"), step("e")),
  ),
]
const names = (options: readonly {readonly as: string}[]) => options.map(({as}) => as).join(" ")

describe("what can be done with a step", () => {
  it.each([
    ["a", "later forever twice parallel race remove"],
    ["loop", "earlier later forever twice parallel race apart remove"],
    ["race", "earlier forever twice apart remove"],
    ["c", "earlier forever twice remove"],
    ["d", "forever twice remove"],
    ["all", "forever twice"],
    ["gone", ""],
  ])("%s", (block, options) => {
    expect(names(stepOptions(tasks, block))).toBe(options)
  })

  it("a new step goes before or behind a step, and to the end of a chain", () => {
    const add = (block: string) => names(additions(tasks, block, {kind: "wait"}))
    expect([add("a"), add("loop"), add("all"), add("gone")]).toEqual([
      "before after",
      "before after inside",
      "inside",
      "",
    ])
  })
})

it("a block that is selected belongs to the step with the shortest text around it", () => {
  const ranges: {readonly [block: string]: readonly [number, number]} = {
    all: [0, 90],
    loop: [10, 40],
    b: [20, 25],
    number: [23, 25],
    do: [10, 40],
    main: [0, 100],
  }
  const rangeOf = (block: string) => {
    const [start, end] = ranges[block] ?? []
    return start === undefined || end === undefined ? null : {start, end}
  }
  const around = (block: string | null) => stepAround(tasks, block, rangeOf)?.block
  expect(["b", "number", "do", "c", "main", "gone", null].map(around)).toEqual([
    "b",
    "b",
    "loop",
    "c",
    undefined,
    undefined,
    undefined,
  ])
})

describe("a drag", () => {
  const drag = (from: string, to: string) =>
    names(dragOptions(tasks, {kind: "step", type: from}, {kind: "step", type: to}))

  it("from a step to an earlier one makes a loop, and to a later one moves it", () => {
    expect(drag("c", "b")).toBe("forever twice moveBefore parallel race")
    expect(drag("b", "c")).toBe("moveAfter parallel race")
    expect(dragOptions(tasks, {kind: "step", type: "c"}, {kind: "step", type: "b"})[0]?.action).toEqual({
      kind: "loop-steps",
      from: "b",
      to: "c",
      turns: null,
    })
  })

  it("to another chain, or of what runs side by side, moves the step", () => {
    expect(drag("a", "c")).toBe("moveAfter")
    expect(drag("d", "e")).toBe("moveAfter")
    expect(drag("a", "a")).toBe("")
  })

  it("of a new step adds it where it is dropped", () => {
    const drop = (kind: "step" | "chart" | "program", type: string) =>
      dragOptions(tasks, {kind: "new-step", type: "task go"}, {kind, type}).map(({action}) => action)
    const added = {kind: "add-step", step: {kind: "task", name: "go"}}
    expect(drop("step", "a")).toEqual([{...added, at: "a", where: "after"}])
    // The arrow behind a loop is not its end.
    expect(drop("step", "loop")).toEqual([{...added, at: "loop", where: "after"}])
    expect(drop("chart", "loop")).toEqual([{...added, at: "loop", where: "inside"}])
    expect(drop("program", "")).toEqual([{...added, at: null, where: "after"}])
    expect(newStep("wait")).toEqual({kind: "wait"})
  })
})
