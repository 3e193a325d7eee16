/// The lessons of the diagram: the connections that their steps ask for, with the empty places filled, are their reference solutions.

import {readFileSync} from "node:fs"
import {beforeAll, expect, test} from "vitest"
import {type NetworkAction, networkEdit, refusalSentence} from "../src/network_edits/index.ts"
import {openView, type Reader} from "../src/reader/index.ts"
import {testReader} from "./reader/open.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

const file = (path: string) =>
  readFileSync(new URL(`../../examples/lessons/${path}`, import.meta.url), "utf8")

/// The program after the connections; each empty place then holds the next of the answers.
function built(program: string, actions: readonly NetworkAction[], answers: readonly string[]): string {
  const connected = actions.reduce((before, action) => {
    const outcome = networkEdit(reader, openView(reader, before), action)
    if (!outcome.ok) throw new Error(refusalSentence(outcome.refusal))
    return outcome.text
  }, program)
  return answers.reduce((text, answer) => text.replace("= _\n", `= ${answer}\n`), connected)
}

const connect = (sensor: string, actuator: string, name: string): NetworkAction => ({
  kind: "connect-sensor-to-actuator",
  sensor,
  actuator,
  name,
})

test("a reflex is wired beside what is there", () => {
  const program = built(
    file("wire-a-reflex/start.hs"),
    [connect("Bumper", "Velocity", "backOff")],
    ["Velocity (-0.2) 0"],
  )
  expect(program).toBe(file("wire-a-reflex/solutions/reflex/reference.hs"))
})

test("a reflex and driving on are wired from an empty program; the repair of the conflict lets the reflex go first", () => {
  const program = built(
    // The new functions take the place of the hole of `simulate`.
    file("wire-a-reflex/empty.hs"),
    [connect("Bumper", "Velocity", "backOff"), connect("()", "Velocity", "go")],
    ["Velocity (-0.2) 0", "Velocity 0.3 0"],
  )
  expect(program.replace("(backOff, go)", "(priority 1 backOff go)")).toBe(
    file("wire-a-reflex/solutions/first/reference.hs"),
  )
})

test("a sensor is wired to the memory of a machine, and the memory to the function that then knows the state", () => {
  const bump = built(
    file("three-states/start.hs"),
    [connect("Bumper", "Memory State", "bump")],
    ["Memory Back"],
  )
  expect(bump).toBe(file("three-states/solutions/bump/reference.hs"))
  const reads = built(bump, [{kind: "add-input", function: "button", type: "Memory State", as: "all"}], [])
  const cases =
    "button (Button _ Pressed) (Memory Stand) = Memory Go\nbutton (Button _ Pressed) (Memory Back) = Memory Stand\nbutton _ state = state\n"
  expect(reads.replace("button _ (Memory state) = Memory Go\n", cases)).toBe(
    file("three-states/solutions/machine/reference.hs"),
  )
})
