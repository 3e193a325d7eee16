/// Refusals and their reasons, names and their scope.

import {readFileSync} from "node:fs"
import {describe, expect, test} from "vitest"
import type {SavedBlock, SavedWorkspace} from "../src/index.ts"
import {
  blockTypes,
  blockView,
  fits,
  infer,
  namesInScope,
  newWorkspace,
  openProject,
  parseProject,
  rename,
  setIn,
  toHaskell,
  toolbox,
} from "../src/index.ts"
import {everyBlockIn} from "../src/workspace/inference/workspace_inference.ts"

function example(name: string): SavedWorkspace {
  const outcome = parseProject(
    readFileSync(new URL(`../../examples/${name}/program.rosy`, import.meta.url), "utf8"),
  )
  if (!outcome.ok) throw new Error(outcome.message)
  return openProject(outcome.project).workspace
}

const workspace = example("accelerateAndPlay")
const [accelerate, play] = workspace.blocks.blocks as [SavedBlock, SavedBlock]
const velocity = accelerate.inputs?.E0_0?.block as SavedBlock
const speed = accelerate.inputs?.P0_0?.block?.inputs?.A0?.block as SavedBlock
const led: SavedBlock = {
  type: "construct",
  id: "led",
  extraState: {con: "Led1", args: 1},
  inputs: {A0: {block: {type: "choice", id: "colour", extraState: {of: "LedColor", value: "Orange"}}}},
}
const nameBlock = (name: string): SavedBlock => ({type: "name", id: "n", extraState: {name, args: 0}})
const number: SavedBlock = {type: "number", id: "three", extraState: {value: "3"}}

describe("a block fits", () => {
  test("where its type does", () => {
    expect(fits(workspace, {block: velocity.id ?? "", input: "A1"}, number)).toEqual({fits: true})
    expect(fits(workspace, {block: velocity.id ?? "", input: "A1"}, nameBlock("vl"))).toEqual({fits: true})
  })
  test("anywhere its own place was", () => {
    expect(fits(workspace, {block: accelerate.id ?? "", input: "E0_0"}, velocity.id ?? "")).toEqual({
      fits: true,
    })
  })
})

describe("a refusal says why", () => {
  const why = (block: SavedBlock | string, at: SavedBlock, input: string) => {
    const verdict = fits(workspace, {block: at.id ?? "", input}, block)
    return verdict.fits ? "it fits" : verdict.why
  }
  test("a light is no number", () =>
    expect(why(led, velocity, "A1")).toBe("This socket wants a number, and `Led1` is a light."))
  test("a light is no Maybe Sound", () =>
    expect(why(led, play, "E1_0")).toBe("This socket wants a Maybe Sound, and `Led1` is a light."))
  test("a Maybe Sound is never a number", () =>
    expect(why(number, play, "E1_0")).toBe("A Maybe Sound cannot be a number."))
  test("a name stays inside its function", () =>
    expect(why(nameBlock("vl"), play, "E0_0")).toBe(
      "`vl` is known only inside the function that names it, so it cannot go here.",
    ))
  test("a value is no pattern", () =>
    expect(why(led, play, "P0_0")).toBe("Here goes a name or a pattern, and this block makes a value."))
  test("nothing goes inside itself", () =>
    expect(why(velocity.id ?? "", velocity, "A0")).toBe("A block cannot go inside itself."))
})

describe("names", () => {
  test("are known where they are bound, nearest first", () => {
    const names = namesInScope(workspace, {block: velocity.id ?? "", input: "A1"})
    expect(names.map(n => [n.name, n.type, n.fits])).toEqual([
      ["va", "Double", true],
      ["vl", "Double", true],
      ["play", "Bumper -> Maybe Sound", false],
      ["accelerate", "Velocity -> Velocity", false],
    ])
  })
  test("are renamed with everything that refers to them", () => {
    const renaming = rename(workspace, speed.id ?? "", "name", "speed")
    expect(renaming.ok && renaming.changes.map(c => c.extra.name)).toEqual(["speed", "speed"])
  })
  test("of functions too", () => {
    const renaming = rename(workspace, play.id ?? "", "name", "complain")
    expect(renaming.ok && renaming.changes.length).toBe(2)
  })
  test("are not renamed into one another", () => {
    expect(rename(workspace, speed.id ?? "", "name", "va").ok).toBe(false)
    expect(rename(workspace, play.id ?? "", "name", "accelerate").ok).toBe(false)
    expect(rename(workspace, play.id ?? "", "name", "where")).toEqual({
      ok: false,
      why: "“where” is one of Haskell's own words.",
    })
  })
})

describe("the program's own types", () => {
  const walk = example("randomWalk")
  const mode = walk.blocks.blocks.find(b => b.extraState?.name === "Mode") as SavedBlock
  const wheel = walk.blocks.blocks.find(b => b.extraState?.name === "wheel") as SavedBlock
  const memory = wheel.inputs?.E0_0?.block?.inputs?.I2?.block as SavedBlock
  test("offer their constructors where they fit", () => {
    const names = namesInScope(walk, {block: memory.id ?? "", input: "A0"}).filter(n => n.fits)
    expect(names.map(n => n.name)).toEqual(["Go", "Stop", "Turn"])
    const patterns = namesInScope(walk, {block: wheel.id ?? "", input: "P0_0"})
    expect(patterns.map(n => [n.name, n.fits])).toEqual([
      ["Go", false],
      ["Stop", false],
      ["Turn", false],
      ["ChgDir", false],
    ])
  })
  test("are renamed with every block that says them", () => {
    const renaming = rename(walk, mode.id ?? "", "constructors.1.name", "Wait")
    expect(renaming.ok && renaming.changes.map(c => c.extra.con ?? "type")).toEqual(["type", "Wait", "Wait"])
    expect(rename(walk, mode.id ?? "", "constructors.1.name", "Go").ok).toBe(false)
    expect(rename(walk, mode.id ?? "", "constructors.1.name", "wait").ok).toBe(false)
  })
})

test("an empty socket is a hole in the text and a problem on its block", () => {
  const {text, problems, spans} = toHaskell(newWorkspace())
  expect(text).toBe("main :: IO ()\nmain = simulate _\n")
  expect(problems.map(p => [p.kind, p.block, p.input])).toEqual([["hole", "main", "R0"]])
  const hole = spans.find(s => s.input === "R0")
  expect(text.slice(hole?.start, hole?.end)).toBe("_")
})

test("definitions show their inferred types", () => {
  expect([...infer(workspace).definitions.values()].map(d => `${d.name} ${d.type} ${d.family}`)).toEqual([
    "accelerate Velocity -> Velocity state",
    "play Bumper -> Maybe Sound event",
    "main IO () task",
  ])
})

describe("the toolbox", () => {
  const items = (["tasks", "reactions", "haskell"] as const).flatMap(level =>
    toolbox(level).flatMap(c => c.items),
  )
  test.each(items.map(i => [i.label, i.block] as const))("%s has no type problem", (_, block) => {
    const found = infer({
      blocks: {
        languageVersion: 0,
        blocks: [numbered(block), ...(block.type === "main" ? [] : newWorkspace().blocks.blocks)],
      },
    })
    expect(found.problems.filter(p => !["hole", "loose"].includes(p.kind))).toEqual([])
  })
})

let count = 0
function numbered(block: SavedBlock): SavedBlock {
  return {
    ...block,
    id: `t${count++}`,
    ...(block.inputs === undefined
      ? {}
      : {
          inputs: Object.fromEntries(
            Object.entries(block.inputs).map(([k, i]) => [
              k,
              i.block === undefined ? {} : {block: numbered(i.block)},
            ]),
          ),
        }),
  }
}

test("every kind of block is in the toolbox of the whole language, but for those that only stand for typed Haskell", () => {
  const offered = new Set(
    toolbox("haskell").flatMap(c => c.items.flatMap(i => [...everyBlockIn(i.block)].map(b => b.type))),
  )
  const kept = blockTypes.filter(b => b.onlyFromText === true).map(b => b.type)
  expect(blockTypes.map(b => b.type).filter(type => !offered.has(type))).toEqual(kept)
})

test("a type with named parts offers its values by their parts", () => {
  const goal: SavedBlock = {
    type: "data",
    id: "goal",
    extraState: {name: "Goal", constructors: [{name: "Goal", fields: [{name: "far", type: "Double"}]}]},
  }
  const f: SavedBlock = {
    type: "define",
    id: "f",
    extraState: {name: "f", arity: 0, equations: [{}], signature: "Goal"},
  }
  const names = namesInScope({blocks: {languageVersion: 0, blocks: [goal, f]}}, {block: "f", input: "E0_0"})
  expect(names.filter(n => n.fits).map(n => n.name)).toEqual(["f", "Goal", "Goal {far}", "{far = …}"])
})

test("buttons add and take away sockets at the end", () => {
  const define = blockView("define")
  const more = define?.press({name: "f", arity: 1, equations: [{}]}, "more-cases") ?? {}
  expect(more.equations).toEqual([{}, {}])
  expect(define?.press(more, "fewer-cases")).toEqual({name: "f", arity: 1, equations: [{}]})
  expect(define?.press({name: "f", arity: 1}, "more-guards.0")).toEqual({
    name: "f",
    arity: 1,
    equations: [{guards: 1, otherwise: true}],
  })
})

test("a field is set along its path", () => {
  expect(setIn({constructors: [{name: "A", fields: []}]}, "constructors.0.name", "B")).toEqual({
    constructors: [{name: "B", fields: []}],
  })
})
