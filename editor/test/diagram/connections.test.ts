/// Connections in the diagram: what each pair of ends means, which action it becomes, and the picture of when the function fires.

import {describe, expect, it} from "vitest"
import {
  actionOf,
  asksName,
  type ConnectionEnd,
  connectionOf,
  firings,
  hasNewMemory,
  joinings,
  newMemory,
  suggestedName,
  withMemory,
} from "../../src/views/diagram/network/connections.ts"
import type {NodeKind} from "../../src/views/diagram/network/network.ts"

const end = (kind: NodeKind, type: string): ConnectionEnd => ({kind, type})
const bumper = end("event", "Bumper")
const velocity = end("command", "Velocity")
const memory = end("store", "Memory Hit")
const go = end("function", "go")
const none = () => []

describe("a connection", () => {
  it.each<[ConnectionEnd, ConnectionEnd, unknown]>([
    [bumper, velocity, {kind: "new-function", sensor: "Bumper", actuator: "Velocity"}],
    [end("sample", "()"), velocity, {kind: "new-function", sensor: "()", actuator: "Velocity"}],
    [bumper, memory, {kind: "new-function", sensor: "Bumper", actuator: "Memory Hit"}],
    [memory, velocity, {kind: "new-function", sensor: "Memory Hit", actuator: "Velocity"}],
    [bumper, go, {kind: "input", function: "go", type: "Bumper", isEvent: true}],
    [end("state", "Velocity"), go, {kind: "input", function: "go", type: "Velocity", isEvent: false}],
    [memory, go, {kind: "input", function: "go", type: "Memory Hit", isEvent: false}],
    [go, velocity, {kind: "output", function: "go", type: "Velocity"}],
    [go, memory, {kind: "output", function: "go", type: "Memory Hit"}],
    [go, end("function", "stop"), {kind: "functions", from: "go", to: "stop", event: null}],
    [velocity, go, "starts-at-command"],
    [end("done", "Done ()"), go, "starts-at-command"],
    [go, bumper, "ends-at-sensor"],
    [bumper, end("state", "Pose"), "ends-at-sensor"],
    [bumper, end("task", "walk"), "not-here"],
    [end("step", "drive 10"), go, "not-here"],
  ])("from %o to %o", (from, to, connection) => {
    expect(connectionOf(from, to, none)).toEqual(connection)
  })

  it("with a new memory gets its type later", () => {
    const made = connectionOf(bumper, end("store", newMemory), none)
    const read = connectionOf(end("store", newMemory), go, none)
    const known = connectionOf(memory, go, none)
    if (typeof made === "string" || typeof read === "string" || typeof known === "string")
      throw new Error("expected connections")
    expect([made, read, known].map(hasNewMemory)).toEqual([true, true, false])
    expect(withMemory(made, "Memory Mode")).toEqual({
      kind: "new-function",
      sensor: "Bumper",
      actuator: "Memory Mode",
    })
    expect(withMemory(read, "Memory Mode")).toEqual({
      kind: "input",
      function: "go",
      type: "Memory Mode",
      isEvent: false,
    })
  })

  it("between functions takes the event that the first one sends already, and asks for a name where there is none", () => {
    const known = connectionOf(go, end("function", "stop"), () => ["Hit"])
    const fresh = connectionOf(go, end("function", "stop"), none)
    if (typeof known === "string" || typeof fresh === "string") throw new Error("expected connections")
    expect([asksName(known), asksName(fresh)]).toEqual([null, "event"])
    expect(actionOf(known, "", "either")).toEqual({
      kind: "connect-functions",
      from: "go",
      to: "stop",
      event: "Hit",
      as: "either",
    })
    expect(suggestedName(fresh, new Set(["FromGo"]), () => undefined)).toBe("FromGo2")
    expect(joinings(fresh)).toEqual(["all", "either"])
  })

  it("with a state, a sample or a memory is never an alternative: they trigger nothing by themselves", () => {
    const connection = connectionOf(end("state", "Pose"), go, none)
    if (typeof connection === "string") throw new Error("expected a connection")
    expect(joinings(connection)).toEqual(["all"])
  })
})

describe("a function fires", () => {
  it.each<["all" | "either", boolean, readonly number[]]>([
    // Rule R1: an unused value of every event.
    ["all", true, [3, 6]],
    // Rule R4.
    ["either", true, [1, 3, 4, 6, 9]],
    // Rule R2: a state is read when the event comes.
    ["all", false, [1, 4, 9]],
  ])("as %s, with another event: %s", (as, isEvent, times) => {
    expect(firings(as, [1, 4, 9], [3, 6], isEvent)).toEqual(times)
  })
})
