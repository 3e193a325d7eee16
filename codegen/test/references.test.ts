/// What a definition leaves behind when it is dropped on a socket, numbers where commands are sent, and stacks without a step.

import {expect, test} from "vitest"
import type {SavedBlock, SavedWorkspace} from "../src/index.ts"
import {checker, infer, newWorkspace, referenceTo, toHaskell} from "../src/index.ts"
import {call, con, make, num, text} from "../src/workspace/toolbox/block_builders.ts"

const define = (name: string, body: SavedBlock, signature?: string): SavedBlock => ({
  ...make(
    "define",
    {name, arity: 0, equations: [{}], ...(signature === undefined ? {} : {signature})},
    {E0_0: body},
  ),
  id: name,
})

function program(...definitions: SavedBlock[]): SavedWorkspace {
  return {blocks: {languageVersion: 0, blocks: [...newWorkspace().blocks.blocks, ...definitions]}}
}

const run = {block: "main", input: "R0"}
const go = define("go", con("Velocity", num("0.2"), num("0")))

test("a function leaves its bare name in simulate, whether it is in the program or new", () => {
  const reference = {fits: true, block: {type: "name", extraState: {name: "go", args: 0}}}
  expect(referenceTo(program(go), run, "go")).toEqual(reference)
  expect(referenceTo(program(), run, go)).toEqual(reference)
})

test("a function leaves a call with open inputs where its answer is wanted", () => {
  const half: SavedBlock = {
    ...make("define", {name: "half", arity: 1, equations: [{}], signature: "Double -> Double"}, {}),
    id: "half",
  }
  const velocity: SavedBlock = {...make("construct", {con: "Velocity", args: 2}, {}), id: "velocity"}
  const answer = referenceTo(program(half, define("go", velocity)), {block: "velocity", input: "A0"}, "half")
  expect(answer).toMatchObject({fits: true, block: {extraState: {name: "half", args: 1}}})
})

test.each([
  ["a definition of another type", define("word", text("hello"))],
  ["a number", define("five", num("5"))],
  ["a type", {...make("synonym", {name: "Speed", type: "Double"}), id: "speed"}],
])("%s is refused with a reason", (_, block) => {
  const answer = referenceTo(program(block), run, block.id ?? "")
  expect(answer.fits).toBe(false)
  if (!answer.fits) expect(answer.why).not.toBe("")
})

test("an own type leaves its first constructor that fits, as a value and as a pattern, and none in simulate", () => {
  const knock: SavedBlock = {
    ...make("data", {name: "Knock", constructors: [{name: "Knock", fields: []}]}),
    id: "knock",
  }
  const open: SavedBlock = {...make("define", {name: "react", arity: 1, equations: [{}]}), id: "react"}
  const at = (input: string) => referenceTo(program(open), {block: "react", input}, knock)
  const extraState = {con: "Knock", args: 0}
  expect(at("E0_0")).toEqual({fits: true, block: {type: "construct", extraState}})
  expect(at("P0_0")).toEqual({fits: true, block: {type: "pattern_construct", extraState}})
  expect(referenceTo(program(), run, knock).fits).toBe(false)
})

test("simulate refuses a number and names what goes there instead", () => {
  const verdict = checker(program()).fits(run, num("5"))
  expect(verdict.fits ? "" : verdict.why).toBe(
    "A number is not a command; put `Velocity` here, with the number in it.",
  )
  expect(checker(program(go)).fits(run, call("go", 0)).fits).toBe(true)
})

test("a task keeps its type without its last step", () => {
  const task = program(define("square", {...make("do"), id: "steps"}))
  expect(infer(task).definitions.get("square")).toMatchObject({type: "Task ()", family: "task"})
  expect(toHaskell(task).text).toContain("square :: Task ()")
})
