/// What an answer marks in the diagram.

import {describe, expect, it} from "vitest"
import {nextInList} from "../../src/views/diagram/list_navigation.ts"
import {causalPath} from "../../src/views/diagram/network/causal_path.ts"
import {explained} from "../../src/views/diagram/network/explained.ts"
import {outline} from "../../src/views/diagram/network/outline.ts"
import {because} from "../../src/wire/page/explanations.generated.ts"
import {words} from "../../src/words/index.ts"
import {readGraph} from "./graphs.ts"

describe("the path of an answer in the diagram", () => {
  it("goes from the bumper through the memory to the velocity", () => {
    const network = readGraph("forwardBackward")
    const path = causalPath(
      because(
        {
          op: "because",
          id: 1,
          time: 3.5,
          sentences: [],
          path: [
            {
              n: 1,
              time: 3.42,
              function: "bump",
              task: 0,
              cause: {by: "message", value: "Bumper CenterBumper Pressed", instant: 5},
              took: [{from: "event", value: "Bumper CenterBumper Pressed"}],
              gave: [{to: "memory", type: "Memory Bool", value: "True"}],
            },
            {
              n: 2,
              time: 3.5,
              function: "forwardBackward",
              task: 0,
              cause: {by: "message", value: "Odometry", instant: 9},
              took: [
                {from: "memory", type: "Memory Bool", value: "Memory True", firing: 1},
                {from: "state", channel: "Odometry", value: "Velocity 0.5 0.0"},
              ],
              gave: [{to: "command", type: "Velocity", value: "Velocity 0.0 0.0"}],
            },
          ],
        },
        "",
      ),
    )
    const {marked, lines} = explained(network, path)
    const names = network.nodes.filter(node => marked.has(node.id)).map(({kind, key}) => `${kind} ${key}`)
    expect(names.sort()).toEqual([
      "command Velocity",
      "event Bumper",
      "function bump",
      "function forwardBackward",
      "state Velocity",
      "store Memory Bool",
    ])
    expect(lines.size).toBe(network.edges.length)
    expect(path.moments).toEqual([3.42, 3.5])
  })

  it("is told in the list form, and the keys go along it", () => {
    const network = readGraph("forwardBackward")
    const marked = new Set(
      network.nodes.filter(({key}) => key === "Bumper" || key === "bump").map(({id}) => id),
    )
    const lines = outline(network, words.diagram.list, marked)
    const told = lines.filter(({text}) => text.endsWith("; part of the answer"))
    expect(told).toEqual(lines.filter(({isMarked}) => isMarked))
    expect(told.map(({id}) => id).sort()).toEqual([...marked].sort())
    const way = lines.map(({isMarked}) => isMarked)
    const [first = -1, second = -1] = way.flatMap((isMarked, i) => (isMarked ? [i] : []))
    expect(nextInList(way, -1, 1)).toBe(first)
    expect(nextInList(way, first, 1)).toBe(second)
    expect(nextInList(way, second, 1)).toBeNull()
    expect(nextInList(way, second, -1)).toBe(first)
    // Without an answer each line is a stop.
    expect(nextInList([false, false], 0, 1)).toBe(1)
  })

  it("is empty without one", () => {
    const network = readGraph("forwardBackward")
    const {marked, lines} = explained(
      network,
      causalPath(because({op: "because", id: 1, time: 0, sentences: [], path: []}, "")),
    )
    expect([...marked, ...lines]).toEqual([])
  })
})
