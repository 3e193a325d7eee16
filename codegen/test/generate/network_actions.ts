/// Random edits of a program's network: its functions, and the steps of its tasks.

import {readdirSync, readFileSync} from "node:fs"
import type {NetworkAction, NewStep, WrittenTask} from "../../src/network_edits/index.ts"
import {writtenNetwork} from "../../src/network_edits/index.ts"
import type {View} from "../../src/reader/index.ts"
import {workspaceOf} from "../../src/reader/index.ts"
import {everyBlock} from "../reader/agreement.ts"
import type {Dice} from "./random.ts"

const examples = new URL("../../../examples/", import.meta.url)

/// The names and texts of the examples.
export const exampleTexts = readdirSync(examples)
  .filter(name => /^[a-z]\w*$/.test(name) && name !== "lessons")
  .flatMap(name => {
    const file = readdirSync(new URL(`${name}/`, examples)).find(one => one.endsWith(".hs"))
    return file === undefined
      ? []
      : [[name, readFileSync(new URL(`${name}/${file}`, examples), "utf8")] as const]
  })

/// An edit of a program, and the definitions that it may change.
export function drawnAction(view: View, dice: Dice): [NetworkAction, readonly string[]] {
  const {functions, tasks} = writtenNetwork(workspaceOf(view))
  const names = functions.map(f => f.name)
  const steps = (tasks ?? []).flatMap(everyStep)
  if (steps.length > 0 && dice.once(2)) return stepAction(view, steps, dice)
  const fn = names.length === 0 ? "none" : dice.pick(names)
  const other = names.length === 0 ? "none" : dice.pick(names)
  const type = dice.pick(["Bumper", "Cliff", "Velocity", "Seconds", "Memory Int", "Button"])
  const as = dice.pick(["all", "either"] as const)
  const name = `added${dice.below(100)}`
  return dice.pick<[NetworkAction, readonly string[]]>([
    [
      {
        kind: "connect-sensor-to-actuator",
        sensor: type,
        actuator: dice.pick(["Velocity", "Led1", "Sound"]),
        name,
      },
      [name, "main"],
    ],
    [{kind: "add-input", function: fn, type, as}, [fn]],
    [{kind: "add-output", function: fn, type: dice.pick(["Velocity", "Led2", "Memory Int"])}, [fn]],
    [{kind: "connect-functions", from: fn, to: other, event: "Signal", as}, [fn, other, "Signal"]],
    [{kind: "cut-input", function: fn, type}, [fn]],
    [
      {kind: "cut-output", function: fn, type: dice.pick(["Velocity", "Led1", "Memory Int", "Sound"])},
      [fn, "main"],
    ],
    [{kind: "delete", function: fn}, [fn, "main"]],
    [{kind: "duplicate", function: fn, name}, [name]],
    [{kind: dice.pick(["join", "leave"] as const), function: fn}, ["main"]],
    [{kind: "add-step", at: null, where: "after", step: {kind: "wait"}}, ["main"]],
  ])
}

const everyStep = (task: WrittenTask): readonly WrittenTask[] => [task, ...task.steps.flatMap(everyStep)]

function stepAction(
  view: View,
  steps: readonly WrittenTask[],
  dice: Dice,
): [NetworkAction, readonly string[]] {
  const [one, other] = [dice.pick(steps), dice.pick(steps)]
  const where = dice.pick(["before", "after"] as const)
  const step: NewStep = {kind: dice.pick(["drive", "turn", "wait", "say", "driveUntilBump", "driveBack"])}
  const at = one.block
  const action = dice.pick<NetworkAction>([
    {kind: "add-step", at, where: dice.pick([where, "inside"] as const), step},
    {kind: "move-step", step: at, at: other.block, where},
    {kind: "delete-step", step: at},
    {kind: "loop-steps", from: at, to: other.block, turns: dice.pick([null, 3])},
    {kind: "put-beside", step: at, with: other.block, as: dice.pick(["parallel", "race"])},
    {kind: "take-apart", step: at},
  ])
  // A step that names a definition stands for its steps, too.
  const blocks = new Set([at, other.block])
  const holders = view.declarations.filter(({block}) =>
    everyBlock(block).some(({id}) => blocks.has(id ?? "")),
  )
  return [action, [...holders.map(({name}) => name), one.name, "main"]]
}
