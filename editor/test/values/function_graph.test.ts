/// The graph of a function from its firings: axes, cases, the current point, and the functions that have one.

import {describe, expect, it} from "vitest"
import {addFirings, emptyLog} from "../../src/state/runs/firing_log.ts"
import {axisKey, functionGraph, graphedFunctions} from "../../src/values/function_graph.ts"
import type {Branch} from "../../src/wire/firing.generated.ts"
import type {FiringShown} from "../../src/wire/page/explanations.generated.ts"

const guard = (number: number, text: string): Branch => ({
  in: ["go"],
  kind: "guard",
  number,
  text,
  start: {line: 2 + number, column: 5},
  end: {line: 2 + number, column: 20},
})

const firing = (
  time: number,
  took: string,
  gave: string,
  branches: readonly Branch[] = [],
  name = "go",
): FiringShown => ({
  n: Math.round(time * 50),
  time,
  function: name,
  task: 0,
  cause: {by: "message", value: "", instant: 1, event: null, firing: null},
  took: [{from: "state", value: took, type: "", firing: null, channel: "Odometry", instant: 1, read: null}],
  gave: gave === "" ? [] : [{to: "command", value: gave, type: gave.split(" ")[0] ?? "", event: null}],
  branches,
})

const near = guard(1, "x < 1")
const far = guard(2, "otherwise")
const log = addFirings(emptyLog, [
  firing(0, "Position 0.0 0.0", "Velocity 0.3 0.0", [near]),
  firing(0.2, "Position 1.5 0.0", "Velocity (-0.25) 0.0", [far]),
  firing(0.4, "Position 0.5 0.0", "Velocity 0.3 0.0", [near]),
  firing(0.4, "Position 0.5 0.0", "Velocity 9.0 0.0", [], "other"),
  firing(0.6, "Position 6.4e-2 0.0", "Velocity 0.3 0.0", [near]),
])

describe("the graph of a function", () => {
  it("has its points by the case that was taken, in the order of the program and of the inputs", () => {
    expect(functionGraph(log, "go", 1).cases).toEqual([
      {
        text: "x < 1",
        points: [
          {x: 0, y: 0.3},
          {x: 0.064, y: 0.3},
          {x: 0.5, y: 0.3},
        ],
      },
      {text: "otherwise", points: [{x: 1.5, y: -0.25}]},
    ])
  })

  it("marks the latest firing until the displayed moment, and has no later ones", () => {
    const graph = functionGraph(log, "go", 0.3)
    expect(graph.now).toEqual({x: 1.5, y: -0.25, of: 1})
    expect(graph.cases.flatMap(({points}) => points)).toHaveLength(2)
  })

  it("offers each number that goes in or out, and draws those that vary unless others are chosen", () => {
    const turning = addFirings(emptyLog, [
      firing(0, "Orientation 0.5", "Velocity 0.0 0.5"),
      firing(1, "Orientation 0.7", "Velocity 0.0 0.3"),
    ])
    const graph = functionGraph(turning, "go", 1)
    expect(graph.outputs.map(axisKey)).toEqual(["Velocity 0", "Velocity 1"])
    expect(graph.y).toEqual({type: "Velocity", part: 1, parts: 2})
    expect(functionGraph(turning, "go", 1, {y: "Velocity 0"}).now).toEqual({x: 0.7, y: 0, of: 0})
  })

  it("leaves out firings that gave nothing, digits of names, and numbers in texts", () => {
    const mixed = addFirings(emptyLog, [
      firing(0, "Position 1.0 0.0", ""),
      firing(1, "Position 2.0 0.0", "Led1 Red"),
    ])
    expect(functionGraph(mixed, "go", 1)).toMatchObject({y: null, cases: [], now: null})
    const says = addFirings(emptyLog, [firing(0, "2.0", 'Say "3 and 4"')])
    expect(functionGraph(says, "go", 1)).toMatchObject({x: {type: ""}, y: null})
  })

  it("keeps the first and the last of very many points", () => {
    const many = Array.from({length: 2000}, (_, i) =>
      firing(i / 50, `Position ${i}.0 0.0`, `Velocity ${i}.0 0.0`),
    )
    const points = functionGraph(
      many.reduce((all, one) => addFirings(all, [one]), emptyLog),
      "go",
      99,
    ).cases[0]?.points
    expect(points?.length).toBeLessThanOrEqual(242)
    expect([points?.[0]?.x, points?.at(-1)?.x]).toEqual([0, 1999])
  })
})

it("is offered for a function whose values are numbers, and for one that has not run yet", () => {
  const lights = addFirings(log, [firing(1, "Position 0.0 0.0", "Led1 Red", [], "shine")])
  expect(graphedFunctions(lights, ["go", "shine", "later"])).toEqual(["go", "later"])
})
