/// Worlds from files, good and bad: the page says of each what the service says of it.

import {readdirSync, readFileSync} from "node:fs"
import fc from "fast-check"
import {describe, expect, it} from "vitest"
import {startFault} from "../../src/worlds/start_validation.ts"
import {readWorld} from "../../src/worlds/world_decoder.ts"
import {worldText, writeWorld} from "../../src/worlds/world_encoder.ts"
import {anyWorld} from "./worlds.ts"

interface Line {
  readonly world: unknown
  readonly path?: string
  readonly why?: string
}

const lines = readFileSync(new URL("../../../protocol/goldens/worlds.jsonl", import.meta.url), "utf8")
  .split("\n")
  .filter(line => line !== "")
  .map(line => JSON.parse(line) as Line)

/// What the page says of a world; `null` when it can be used.
function faultOf(value: unknown) {
  const read = readWorld(value)
  return read.kind === "fault" ? read.fault : startFault(read.world)
}

describe("a world from a file", () => {
  it.each(lines.map(line => [JSON.stringify(line.world).slice(0, 120), line] as const))("%s", (_, line) => {
    const {path, why} = line
    expect(faultOf(line.world)).toEqual(path === undefined ? null : {path, why})
  })

  it("names a field of its realism that every object has, as any other that is unknown", () => {
    const realism = JSON.parse('{"toString": 0.06}') as unknown
    expect(faultOf({name: "a", title: "A", size: [6, 5], realism})?.path).toBe("realism.toString")
  })

  it("is the same world after it was written and read again", () => {
    fc.assert(
      fc.property(anyWorld, world => {
        expect(readWorld(writeWorld(world))).toEqual({kind: "world", world})
        expect(readWorld(JSON.parse(worldText(world)))).toEqual({kind: "world", world})
      }),
    )
  })

  it("refuses a robot that the simulator does not have, and names those that it has", () => {
    const room = {size: [4, 4], start: {x: 2, y: 2}, robot: "turtle"}
    expect(faultOf(room)).toMatchObject({
      path: "robot",
      why: "the simulator has no robot 'turtle'; it has kobuki (Kobuki), turtlebot3 (TurtleBot 3).",
    })
    expect(faultOf({...room, robot: 3})).toMatchObject({path: "robot", why: "the robot must be text."})
  })

  const gallery = new URL("../../../sim-service/rosy_sim/worlds/", import.meta.url)
  it.each(readdirSync(gallery).filter(name => name.endsWith(".json")))(
    "%s of the gallery can be opened",
    name => {
      expect(faultOf(JSON.parse(readFileSync(new URL(name, gallery), "utf8")))).toBeNull()
    },
  )
})
