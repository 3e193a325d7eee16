/// The toolbox of a robot without some sensors and commands.

import {expect, it, vi} from "vitest"
import {robot} from "../src/robot/description.generated.ts"
import {usableItems, usableWith, withoutMissingParts} from "../src/workspace/toolbox/missing_parts.ts"
import {toolbox} from "../src/workspace/toolbox/toolbox.ts"
import {libraryItems} from "../src/workspace/toolbox/toolbox_search.ts"

const {kobuki, turtlebot3} = robot.simulated
const namesOf = (lacks: readonly string[]) =>
  withoutMissingParts(toolbox("haskell"), lacks).flatMap(category =>
    category.items.flatMap(({block}) => [block.extraState?.con ?? block.extraState?.name ?? block.type]),
  )

it("has everything for Kobuki", () => {
  expect(withoutMissingParts(toolbox("reactions"), kobuki.lacks)).toEqual(toolbox("reactions"))
})

it("has the scanner, the buttons and the motors of TurtleBot 3, and neither bumpers nor lights", () => {
  const names = namesOf(turtlebot3.lacks)
  expect(names).toEqual(expect.arrayContaining(["Velocity", "lookAround", "onButton", "Say", "accelerate"]))
  for (const missing of ["onBump", "onCliff", "onLift", "Led1", "Bumper", "Cliff", "Wheel"])
    expect(names).not.toContain(missing)
})

it("leaves out a ready-made task that calls one which needs a missing part", () => {
  const usable = usableWith(turtlebot3.lacks)
  const call = (name: string) => ({type: "name", extraState: {name, args: 0}})
  expect(["drive", "turn", "goTo"].map(name => usable(call(name)))).toEqual([true, true, true])
  expect(["driveUntilBump", "curveUntilObstacle", "blink"].map(name => usable(call(name)))).toEqual([
    false,
    false,
    false,
  ])
})

it("reads the definitions of the library a few times for all that the search finds, and never for Kobuki", () => {
  const items = libraryItems()
  expect(usableItems(items, kobuki.lacks)).toBe(items)
  const read = vi.spyOn(JSON, "stringify")
  const usable = usableItems(items, turtlebot3.lacks)
  const reads = read.mock.calls.length
  read.mockRestore()
  expect(reads).toBeLessThan(5 * items.length)
  expect(usable.length).toBeLessThan(items.length)
})
