/// Units on constructor blocks are those of the robot's description.

import {readFileSync} from "node:fs"
import {expect, test} from "vitest"
import {labelsOf, units} from "../src/blocks/spec/constructor_labels.ts"

interface Field {
  readonly type: string
  readonly unit?: string
}
const kobuki: {readonly types: readonly {readonly name: string; readonly fields?: readonly Field[]}[]} =
  JSON.parse(readFileSync(new URL("../../protocol/robots/kobuki.json", import.meta.url), "utf8"))

test("every unit of the robot's description stands on its block, and no other", () => {
  const described = kobuki.types.flatMap(({name, fields}): [string, readonly (string | undefined)[]][] =>
    fields?.some(f => f.unit !== undefined) ? [[name, fields.map(f => f.unit)]] : [],
  )
  expect(described.length).toBeGreaterThan(2)
  for (const [name, wanted] of described) expect([name, units[name]]).toEqual([name, wanted])
})

test("each part has one unit", () => {
  for (const [name, of] of Object.entries(units))
    expect([name, of.length]).toEqual([name, labelsOf(name).parts.length])
})
