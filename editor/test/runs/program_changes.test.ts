/// Names of changes between two programs: what a person would say.

import * as fc from "fast-check"
import {describe, expect, it} from "vitest"
import {type ProgramChange, programChanges} from "../../src/state/runs/program_changes.ts"

const drive = (body: string) => `drive :: Velocity\ndrive = ${body}\n\nmain = simulate drive\n`
const before = drive("Velocity 0.3 0")
const backOff = "backOff :: Bumper -> Velocity\nbackOff _ = Velocity (-0.2) 0\n\n"

describe("a change is named by", () => {
  it.each<[string, string, string, readonly ProgramChange[]]>([
    ["nothing", before, before, []],
    [
      "a number",
      before,
      drive("Velocity 0.5 0"),
      [{kind: "value", name: "drive", before: "0.3", after: "0.5"}],
    ],
    [
      "a negative number",
      before,
      drive("Velocity (-0.3) 0"),
      [{kind: "value", name: "drive", before: "0.3", after: "-0.3"}],
    ],
    [
      "neighbouring values",
      before,
      drive("Velocity 0.5 0.2"),
      [{kind: "value", name: "drive", before: "0.3 0", after: "0.5 0.2"}],
    ],
    [
      "a new function",
      before,
      backOff + before.replace("simulate drive", "simulate (drive, backOff)"),
      [{kind: "added", name: "backOff", what: "function"}],
    ],
    ["a function that went", backOff + before, before, [{kind: "removed", name: "backOff"}]],
    [
      "a new name",
      before,
      before.replaceAll("drive", "go"),
      [{kind: "renamed", before: "drive", after: "go"}],
    ],
    [
      "a new name and a number",
      before,
      before.replaceAll("drive", "go").replace("0.3", "0.5"),
      [
        {kind: "added", name: "go", what: "function"},
        {kind: "removed", name: "drive"},
      ],
    ],
    [
      "another function in main",
      before,
      before.replace("simulate drive", "simulate (drive, drive)"),
      [{kind: "value", name: "main", before: "drive", after: "(drive, drive)"}],
    ],
    [
      "a new type",
      before,
      `data Mood = Calm | Wild\n${before}`,
      [{kind: "added", name: "Mood", what: "type"}],
    ],
    [
      "something long",
      before,
      drive("if fast then Velocity 0.7 0 else Velocity 0.1 0.5"),
      [{kind: "changed", name: "drive"}],
    ],
    [
      "a text",
      'a = Say "one -- two"\n',
      'a = Say "one -- three"\n',
      [{kind: "value", name: "a", before: '"one -- two"', after: '"one -- three"'}],
    ],
    ["a comment", before, `-- faster\n${before}`, [{kind: "layout"}]],
    ["layout", before, drive("Velocity\n  0.3   0"), [{kind: "layout"}]],
    [
      "a signature",
      before,
      before.replace(":: Velocity", ":: Maybe Velocity"),
      [{kind: "changed", name: "drive"}],
    ],
  ])("%s", (_, old, now, changes) => {
    expect(programChanges(old, now)).toEqual(changes)
  })

  it("every change of one number in one function, and nothing else", () => {
    const number = fc.integer({min: -99, max: 99}).map(n => n / 10)
    const written = (n: number) => (n < 0 ? `(${n})` : `${n}`)
    const program = (values: readonly number[]) =>
      `${values.map((n, i) => `f${i} :: Velocity\nf${i} = Velocity ${written(n)} 1`).join("\n\n")}\n`
    fc.assert(
      fc.property(
        fc.array(number, {minLength: 1, maxLength: 5}),
        fc.nat(),
        number,
        (values, place, other) => {
          const at = place % values.length
          fc.pre(values[at] !== other)
          const changed = values.map((n, i) => (i === at ? other : n))
          expect(programChanges(program(values), program(changed))).toEqual([
            {kind: "value", name: `f${at}`, before: `${values[at]}`, after: `${other}`},
          ])
        },
      ),
    )
  })
})
