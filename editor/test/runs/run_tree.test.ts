/// The tree of runs: origins, bounds, and what is shown or compared.

import * as fc from "fast-check"
import {describe, expect, it} from "vitest"
import type {Frame} from "../../src/state/messages/messages.ts"
import {addFrame, clearRoom, emptyRoom} from "../../src/state/runs/room_state.ts"
import {
  beginRun,
  comparedRun,
  compareWith,
  maxRuns,
  noRuns,
  originOf,
  type RunTree,
  runRows,
  type ShownRun,
  storeShown,
  takeRun,
  withoutRun,
} from "../../src/state/runs/run_tree.ts"

const frame = (run: number, step: number): Frame => ({
  run,
  step,
  time: step / 50,
  x: step / 50,
  y: 0,
  theta: 0,
  channels: {},
  fired: [],
  sensed: [],
  boxes: null,
  ghost: null,
  memory: null,
})
/// What the page shows of a run of some steps.
const shown = (run: number | null, steps: number): ShownRun => {
  let room = clearRoom(emptyRoom, run)
  for (let step = 0; step < steps && run !== null; step += 1) room = addFrame(room, frame(run, step))
  return {room, lines: []}
}
const program = (speed: number) => `drive = Velocity ${speed} 0\n\nmain = simulate drive\n`

/// Runs from the start, each with its program; three frames of each were shown.
function ran(...texts: readonly string[]): RunTree {
  return texts.reduce((tree, text, i) => {
    const from = originOf(tree, i === 0 ? null : i, text)
    return beginRun(tree, shown(i === 0 ? null : i, 3), {run: i + 1, from, text, seed: 1})
  }, noRuns)
}
const outline = (tree: RunTree) =>
  runRows(tree).map(({node, level, place, siblings}) => `${node.number}: ${level}, ${place}/${siblings}`)

describe("the tree of runs", () => {
  it("puts a changed program below the run before, and the same program beside it", () => {
    expect(outline(ran(program(0.3), program(0.5), program(0.5), program(0.7)))).toEqual([
      "1: 1, 1/1",
      "2: 2, 1/2",
      "3: 2, 2/2",
      "4: 3, 1/1",
    ])
  })

  it("names what was changed, and from where a run was continued", () => {
    const first = ran(program(0.3))
    const from = {run: 1, at: 1.5}
    const tree = beginRun(first, shown(1, 3), {run: 2, from, text: program(0.5), seed: 1})
    expect(runRows(tree).map(({changes, continued}) => ({changes, continued}))).toEqual([
      {changes: null, continued: null},
      {
        changes: [{kind: "value", name: "drive", before: "0.3", after: "0.5"}],
        continued: {number: 1, at: 1.5},
      },
    ])
  })

  it("forgets a run of which nothing was shown", () => {
    const tree = beginRun(ran(program(0.3)), shown(1, 0), {run: 2, from: null, text: "", seed: 1})
    expect(outline(tree)).toEqual(["2: 1, 1/1"])
  })

  it("shows a run again, and stores the one that was shown", () => {
    const tree = ran(program(0.3), program(0.5))
    const taken = takeRun(tree, shown(2, 5), 1)
    expect(taken?.node.kept.room.recording.length).toBe(3)
    expect(taken?.tree.nodes.map(({kept}) => kept?.room.recording.length)).toEqual([undefined, 5])
    expect(takeRun(tree, shown(2, 5), 7)).toBeNull()
  })

  it("compares with a stored run only, and exchanges the two when that one is shown", () => {
    const tree = ran(program(0.3), program(0.5))
    expect(compareWith(tree, 2).compared).toBeNull()
    const compared = compareWith(tree, 1)
    expect(comparedRun(compared)?.number).toBe(1)
    expect(comparedRun(takeRun(compared, shown(2, 5), 1)?.tree ?? noRuns)?.number).toBe(2)
  })

  it("hangs the runs of one that is dropped on its origin", () => {
    const tree = withoutRun(ran(program(0.3), program(0.5), program(0.7)), 2)
    expect(outline(tree)).toEqual(["1: 1, 1/1", "3: 2, 1/1"])
    expect(runRows(tree)[1]?.changes).toEqual([{kind: "value", name: "drive", before: "0.3", after: "0.7"}])
  })

  it("stays within its bounds, and keeps what is shown or compared", () => {
    fc.assert(
      fc.property(fc.integer({min: 1, max: 60}), fc.integer({min: 1, max: 10}), (runs, compared) => {
        let tree = ran(program(0))
        for (let run = 2; run <= runs; run += 1) {
          tree = beginRun(tree, shown(run - 1, 2), {
            run,
            from: {run: run - 1, at: null},
            text: `${run}`,
            seed: 1,
          })
          if (run === compared + 1) tree = compareWith(tree, compared)
        }
        expect(tree.nodes.length).toBe(Math.min(runs, maxRuns))
        expect(tree.dropped).toBe(runs - tree.nodes.length)
        expect(tree.nodes.at(-1)?.run).toBe(runs)
        expect(comparedRun(tree)?.run).toBe(runs > compared ? compared : undefined)
        expect(runRows(tree).length).toBe(tree.nodes.length)
      }),
    )
  })

  it("stores what was shown before a reset", () => {
    const tree = storeShown(ran(program(0.3)), shown(1, 4))
    expect(originOf(tree, null, program(0.5))).toEqual({run: 1, at: null})
    expect(tree.nodes[0]?.kept?.room.recording.length).toBe(4)
  })
})
