/// Functions of a causal path when sentences name some that are not among its firings.

import {describe, expect, it} from "vitest"
import {causalPath} from "../../src/views/diagram/network/causal_path.ts"
import {because} from "../../src/wire/page/explanations.generated.ts"

const functionsOf = (...said: readonly object[]) => [
  ...causalPath(
    because(
      {
        op: "because",
        id: 1,
        time: 2.6,
        sentences: said.map(one => ({said: one, time: 2.6})),
        path: [{n: 1, time: 2.56, function: "runMove", task: 0, cause: {by: "tick"}, took: [], gave: []}],
      },
      "",
    ),
  ).functions,
]

describe("the functions of a causal path", () => {
  it("are those that ran", () => {
    expect(functionsOf({id: "run-over", time: 2.6})).toEqual(["runMove"])
  })

  it("include the function that a sentence is about", () => {
    expect(functionsOf({id: "task-waits", function: "runTurn", until: 2.6})).toEqual(["runMove", "runTurn"])
  })

  it("include a function that replaced the command", () => {
    const said = {id: "replaced", time: 2.56, since: 2.6, other: "runTurn", value: "Velocity 0.0 0.5"}
    expect(functionsOf(said)).toEqual(["runMove", "runTurn"])
  })

  it("include the functions that could have sent a message", () => {
    const said = {id: "never-sent", type: "M1 Velocity", functions: ["safetyControl", "button"]}
    expect(functionsOf(said)).toEqual(["runMove", "safetyControl", "button"])
  })
})
