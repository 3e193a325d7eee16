/// Tasks as chains of steps: what edits of them write, why they are refused, and the tasks that the network reports.

import {beforeAll, describe, expect, test} from "vitest"
import {
  type NetworkAction,
  networkEdit,
  refusalSentence,
  type WrittenTask,
  writtenNetwork,
} from "../src/network_edits/index.ts"
import {openView, type Reader, type View, workspaceOf} from "../src/reader/index.ts"
import type {BlockId} from "../src/serialized_blocks.ts"
import {testReader} from "./reader/open.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

/// The steps of a program, in the order of the text, each once.
const stepsOf = (view: View): readonly WrittenTask[] => {
  const inside = (task: WrittenTask): readonly WrittenTask[] => [task, ...task.steps.flatMap(inside)]
  return (writtenNetwork(workspaceOf(view)).tasks ?? []).flatMap(inside)
}

/// An edit, with the names of functions or kinds of charts in the place of steps: `drive`, `wait 2` for the second one.
type Named = (step: (name: string) => BlockId) => NetworkAction

function edit(text: string, named: Named) {
  const view = openView(reader, text)
  const action = named(name => {
    const [, word, which] = /^(\S+)(?: (\d))?$/.exec(name) ?? []
    const found = stepsOf(view).filter(one => one.name === word || (one.name === "" && one.kind === word))
    const step = found[Number(which ?? 1) - 1]
    if (step === undefined) throw new Error(`expected the step ${name} in ${text}`)
    return step.block
  })
  return networkEdit(reader, view, action)
}

const main = (...lines: readonly string[]) => `main :: IO ()\nmain = simulate ${lines.join("\n")}\n`
const two = main("$ do", "  drive 50 -- ahead", "  turn 90")
const add = (
  at: string | null,
  where: "before" | "after" | "inside",
  kind: "wait" | "driveUntilBump" = "wait",
): Named => {
  return step => ({kind: "add-step", at: at === null ? null : step(at), where, step: {kind}})
}
const loop = (from: string, to: string, turns: number | null = null): Named => {
  return step => ({kind: "loop-steps", from: step(from), to: step(to), turns})
}
const beside = (one: string, other: string, as: "parallel" | "race"): Named => {
  return step => ({kind: "put-beside", step: step(one), with: step(other), as})
}
const move = (from: string, to: string, where: "before" | "after"): Named => {
  return step => ({kind: "move-step", step: step(from), at: step(to), where})
}
const apart = (one: string): Named => {
  return step => ({kind: "take-apart", step: step(one)})
}
const remove = (one: string): Named => {
  return step => ({kind: "delete-step", step: step(one)})
}

const square = `go :: Task ()
go = replicateM_ 4 $ do
  drive 50
  turn 90

main = simulate go
`

describe("an edit of a task writes what a person would write:", () => {
  test.each<[string, string, Named, string]>([
    ["the first step of an empty program", main("_"), add(null, "after"), main("(wait 1)")],
    [
      "a step at the end of the program",
      two,
      add(null, "after"),
      main("$ do", "  drive 50 -- ahead", "  turn 90", "  wait 1"),
    ],
    ["a second step", main("(drive 50)"), add("drive", "after"), main("$ do", "  drive 50", "  wait 1")],
    [
      "a step between two",
      two,
      add("drive", "after"),
      main("$ do", "  drive 50 -- ahead", "  wait 1", "  turn 90"),
    ],
    [
      "a step before the first",
      two,
      add("drive", "before"),
      main("$ do", "  wait 1", "  drive 50 -- ahead", "  turn 90"),
    ],
    [
      "a task beside a function",
      "f :: Velocity\nf = Velocity 0.1 0\n\nmain = simulate f\n",
      add(null, "after"),
      "f :: Velocity\nf = Velocity 0.1 0\n\nmain = simulate (f, wait 1)\n",
    ],
    ["a step in a loop", square, add("turn", "before"), square.replace("  turn", "  wait 1\n  turn")],
    [
      "a step at the end of a loop that has a name",
      square,
      add("go", "inside"),
      square.replace("turn 90\n", "turn 90\n  wait 1\n"),
    ],
    [
      "a second step in a loop of one",
      main("(forever (turn 3))"),
      add("turn", "after"),
      "main :: IO ()\nmain =\n  simulate\n    (forever $ do\n      turn 3\n      wait 1)\n",
    ],
    ["a step moved", two, move("turn", "drive", "before"), main("$ do", "  turn 90", "  drive 50 -- ahead")],
    [
      "a step moved out of a loop",
      main("$ do", "  drive 50", "  forever $ do", "    turn 90", "    wait 2"),
      move("turn", "drive", "after"),
      main("$ do", "  drive 50", "  turn 90", "  forever (wait 2)"),
    ],
    [
      "a task of its own after another one",
      "go :: Task ()\ngo = drive 10\n\nback :: Task ()\nback = drive (-10)\n\nmain = simulate (go, back)\n",
      move("back", "go", "after"),
      "go :: Task ()\ngo = drive 10\n\nback :: Task ()\nback = drive (-10)\n\nmain = simulate $ do\n  go\n  back\n",
    ],
    ["a step deleted", two, remove("drive"), main("(turn 90)")],
    ["the only step of the program deleted", main("(drive 50)"), remove("drive"), main("_")],
    ["a loop of all", two, loop("turn", "drive"), main("(forever $ do", "  drive 50 -- ahead", "  turn 90)")],
    [
      "a loop of one",
      two,
      loop("turn", "turn", 3),
      main("$ do", "  drive 50 -- ahead", "  replicateM_ 3 (turn 90)"),
    ],
    ["a loop taken away", square, apart("go"), square.replace("replicateM_ 4 $ do", "do")],
    [
      "two side by side",
      main("$ do", "  drive 5", "  wait 2", "  turn 3"),
      beside("wait", "drive", "race"),
      main("$ do", "  race (drive 5) (wait 2)", "  turn 3"),
    ],
    [
      "two side by side where their results are not wanted",
      "go :: Task ()\ngo = do\n  drive 5\n  wait 2\n\nmain = simulate go\n",
      beside("drive", "wait", "parallel"),
      "go :: Task ()\ngo = void (parallel (drive 5) (wait 2))\n\nmain = simulate go\n",
    ],
    [
      "two that were side by side",
      main("(race (wait 10) (do", "  drive 5", "  turn 3))"),
      apart("race"),
      main("(do", "  wait 10", "  drive 5", "  turn 3)"),
    ],
  ])("%s", (_, before, named, after) => {
    const outcome = edit(before, named)
    expect(outcome.ok ? outcome.text : refusalSentence(outcome.refusal)).toBe(after)
    // The blocks of the new text still say what is simulated, and its tasks can be edited again.
    const {hasSimulate, tasks} = writtenNetwork(workspaceOf(openView(reader, after)))
    expect([hasSimulate, tasks === null]).toEqual([true, false])
  })
})

describe("an edit of a task is refused with its cause:", () => {
  test.each<[string, Named, string]>([
    [main("(forever (turn 3))"), remove("turn"), "only-step"],
    [two, apart("drive"), "not-composed"],
    [main("$ do", "  drive 5", "  forever (turn 3)"), loop("drive", "turn"), "other-chain"],
    [main("$ do", "  drive 5", "  forever (turn 3)"), move("repeat", "turn", "after"), "inside-itself"],
    [main("$ do", "  x <- dice 6", "  say (show x)"), loop("dice", "dice"), "does-not-fit"],
    [main("$ do", "  x <- dice 6", "  say (show x)"), move("say", "dice", "before"), "does-not-fit"],
    [
      "f :: Velocity\nf = Velocity 0.1 0\n\nmain = simulate f\n",
      () => ({kind: "delete-step", step: "t1"}),
      "no-such-step",
    ],
  ])("%#", (text, named, cause) => {
    const outcome = edit(text, named)
    expect(outcome.ok ? outcome.text : outcome.refusal.kind).toBe(cause)
    if (!outcome.ok) expect(refusalSentence(outcome.refusal)).toMatch(/\.$/)
  })
})
