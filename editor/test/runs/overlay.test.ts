/// Two runs in one picture: what is drawn of the other one, and both curves of a chart in the same scale.

import {describe, expect, it} from "vitest"
import {table as french} from "../../../languages/fr/page/index.ts"
import {changeSentence} from "../../src/features/runs/change_sentence.ts"
import {factsOf, picturePath} from "../../src/features/runs/run_facts.ts"
import {openCurves, unitedWindow, windowOf, withSameScale} from "../../src/page/panels/chart_data.ts"
import type {Frame} from "../../src/state/messages/messages.ts"
import {addFrame, clearRoom, emptyRoom, type RoomState} from "../../src/state/runs/room_state.ts"
import {beginRun, compareWith, noRuns} from "../../src/state/runs/run_tree.ts"
import {quantities} from "../../src/values/quantities.ts"
import {overlayOf} from "../../src/views/room/overlay.ts"
import {words} from "../../src/words/index.ts"

/// A run of so many seconds along the x axis, with a frame for each.
function driven(run: number, seconds: number, speed: number): RoomState {
  let room = clearRoom(emptyRoom, run)
  for (let time = 0; time <= seconds; time += 1)
    room = addFrame(room, {
      run,
      step: 50 * time,
      time,
      x: speed * time,
      y: 0,
      theta: 0,
      channels: {},
      fired: [],
      sensed: [],
      boxes: null,
      ghost: null,
      memory: null,
    } satisfies Frame)
  return room
}
const first = driven(1, 8, 0.2)
const second = driven(2, 4, 0.5)
const begin = {from: null, text: "", seed: 1}
const tree = compareWith(
  beginRun(
    beginRun(noRuns, {room: emptyRoom, lines: []}, {run: 1, ...begin}),
    {room: first, lines: []},
    {
      run: 2,
      ...begin,
    },
  ),
  1,
)

describe("two runs in one picture", () => {
  it("at their ends, or both at the displayed moment", () => {
    expect(overlayOf({runTree: tree, room: second})).toMatchObject({
      shown: {number: 2},
      compared: {number: 1},
      until: null,
      pose: {x: 1.6},
    })
    const back = {...second, lookedAt: 2.5}
    expect(overlayOf({runTree: tree, room: back})).toMatchObject({until: 2.5, pose: {x: 0.4}})
    expect(overlayOf({runTree: {...tree, compared: null}, room: second})).toBeNull()
  })

  it("in charts that are as long and as high as both need", () => {
    const shown = unitedWindow(windowOf(second.recording, null, "all"), first.recording, "all")
    expect(shown).toEqual({from: 0, to: 8})
    const x = quantities.find(({key}) => key === "x")
    if (x === undefined) throw new Error("expected the quantity x")
    const curves = [second, first].map(({recording}) => openCurves().of(recording, x, shown))
    const [a, b] = withSameScale(curves[0] as (typeof curves)[0], curves[1] as (typeof curves)[0])
    expect([a.high, b.high]).toEqual([2, 2])
  })

  it("with their lengths and ways", () => {
    expect(factsOf(first)).toEqual({length: 8, way: expect.closeTo(1.6), goals: []})
    expect(picturePath(first.trail)).toHaveLength(9)
  })
})

describe("changes in words", () => {
  const value = {kind: "value", name: "drive", before: "0.3", after: "0.5"} as const
  const added = {kind: "added", name: "backOff", what: "function"} as const
  it.each([
    [[value], "drive: 0.3 → 0.5"],
    [[added], "new function backOff"],
    [[value, added], "drive: 0.3 → 0.5, new function backOff"],
    [[value, added, value], "drive: 0.3 → 0.5, new function backOff and one more change"],
    [[], "the same program"],
  ])("%j: %s", (changes, sentence) => expect(changeSentence(changes, words.runs.changes)).toBe(sentence))

  it("in French", () => {
    const {changes} = french.page.runs
    expect(changeSentence([added], changes as typeof words.runs.changes)).toBe("nouvelle fonction backOff")
  })
})
