/// The lessons of the diagram: the connections that their steps ask for, with the equations that they want, are their reference solutions.

import {readFileSync} from "node:fs"
import {beforeAll, expect, test} from "vitest"
import {
  definitionEdit,
  type NetworkAction,
  type NetworkEdit,
  networkEdit,
  refusalSentence,
} from "../src/network_edits/index.ts"
import {openView, type Reader} from "../src/reader/index.ts"
import {testReader} from "./reader/open.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

const file = (path: string) =>
  readFileSync(new URL(`../../examples/lessons/${path}`, import.meta.url), "utf8")

const textOf = (outcome: NetworkEdit): string => {
  if (!outcome.ok) throw new Error(refusalSentence(outcome.refusal))
  return outcome.text
}

/// The program after the connections, and with these definitions written anew.
function built(
  program: string,
  actions: readonly NetworkAction[],
  definitions: {readonly [name: string]: string} = {},
): string {
  const connected = actions.reduce(
    (before, action) => textOf(networkEdit(reader, openView(reader, before), action)),
    program,
  )
  return Object.entries(definitions).reduce(
    (before, [name, text]) => textOf(definitionEdit(reader, openView(reader, before), name, text)),
    connected,
  )
}

const backOff = "backOff :: Bumper -> Velocity\nbackOff (Bumper side status) = Velocity (-0.2) 0"

const connect = (sensor: string, actuator: string, name: string): NetworkAction => ({
  kind: "connect-sensor-to-actuator",
  sensor,
  actuator,
  name,
})

test("a reflex is wired beside what is there", () => {
  const program = built(file("wire-a-reflex/start.hs"), [connect("Bumper", "Velocity", "backOff")], {backOff})
  expect(program).toBe(file("wire-a-reflex/solutions/reflex/reference.hs"))
})

test("a reflex and driving on are wired from an empty program; the repair of the conflict lets the reflex go first", () => {
  const program = built(
    // The new functions take the place of the hole of `simulate`.
    file("wire-a-reflex/empty.hs"),
    [connect("Bumper", "Velocity", "backOff"), connect("()", "Velocity", "go")],
    {backOff, go: "go :: Velocity\ngo = Velocity 0.3 0"},
  )
  expect(program.replace("(backOff, go)", "(priority 1 backOff go)")).toBe(
    file("wire-a-reflex/solutions/first/reference.hs"),
  )
})

test("a sensor is wired to the memory of a machine, and the memory to the function that then knows the state", () => {
  const bump = built(file("three-states/start.hs"), [connect("Bumper", "Memory State", "bump")], {
    bump: "bump :: Bumper -> Memory State\nbump (Bumper side status) = Memory Back",
  })
  expect(bump).toBe(file("three-states/solutions/bump/reference.hs"))
  const reads = built(bump, [{kind: "add-input", function: "button", type: "Memory State", as: "all"}])
  const cases =
    "button (Button _ Pressed) (Memory Stand) = Memory Go\nbutton (Button _ Pressed) (Memory Back) = Memory Stand\nbutton _ state = state\n"
  expect(reads.replace("button _ (Memory state) = Memory Go\n", cases)).toBe(
    file("three-states/solutions/machine/reference.hs"),
  )
})
