/// The commands that can be asked for, from the types of a function.

import {commands} from "@rosy/codegen/roles"
import {describe, expect, it} from "vitest"
import {commandsOf, commandsToAsk} from "../../src/features/why/commands_of.ts"
import {readParts} from "../diagram/graphs.ts"

describe("the commands of a function", () => {
  it.each([
    ["accelerateAndPlay", "play", ["Sound"]],
    ["safeRandomWalk", "bumper", ["Led1"]],
    ["safeRandomWalk", "wheel", ["Led1", "Led2"]],
    ["safeRandomWalk", "spin", []],
    ["safeRandomWalk", "muxVelocity", ["Velocity"]],
    ["accelerate", "nobody", []],
  ])("%s: %s gives %j", (example, name, commands) => {
    expect(commandsOf(readParts(example), name)).toEqual(commands)
  })

  it("come before those that it never gives when it is asked for them", () => {
    const asked = commandsToAsk(readParts("accelerateAndPlay"), "play")
    expect(asked).toEqual(["Sound", ...[...commands].filter(command => command !== "Sound")])
  })
})
