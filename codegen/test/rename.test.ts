/// Renaming: a program means the same before and after, or the new name is refused.

import {expect, test} from "vitest"
import {packageDatabase} from "../scripts/ghc.ts"
import type {SavedBlock, SavedWorkspace} from "../src/index.ts"
import {blockView, infer, rename, toHaskell} from "../src/index.ts"
import {everyBlock} from "../src/workspace/inference/workspace_inference.ts"
import {cases, seed as firstSeed, isNightly} from "./extent.ts"
import {generateProgram} from "./generate/program.ts"
import {Dice} from "./generate/random.ts"
import type {Candidate} from "./ghc.ts"
import {compileAll} from "./ghc.ts"
import {breathe} from "./process.ts"
import {candidate} from "./soundness.ts"

const database = packageDatabase()

interface Binder {
  readonly block: SavedBlock
  readonly key: string
  readonly name: string
}

/// Everything in a program that has a name of the learner's, and stands for a value.
function bindersOf(workspace: SavedWorkspace): Binder[] {
  return [...everyBlock(workspace)].flatMap(block =>
    (blockView(block.type)?.shape(block.extraState ?? {}).rows ?? [])
      .flat()
      .flatMap(item =>
        item.kind === "binder" && item.ofType !== true ? [{block, key: item.key, name: item.value}] : [],
      ),
  )
}

function renamed(workspace: SavedWorkspace, {block, key}: Binder, name: string): SavedWorkspace | string {
  const renaming = rename(workspace, block.id ?? "", key, name)
  if (!renaming.ok) return renaming.why
  const changes = new Map(renaming.changes.map(c => [c.block, c.extra]))
  const copy = structuredClone(workspace)
  for (const b of everyBlock(copy)) {
    const extra = changes.get(b.id ?? "")
    if (extra !== undefined) b.extraState = extra
  }
  return copy
}

/// Types on the headers, in the order of their blocks. Names of types are not renamed here, so they stay.
function typesOf(workspace: SavedWorkspace): string[] {
  return [...infer(workspace).definitions.values()].map(d => d.type)
}

const names = [
  "fresh",
  "x",
  "x0",
  "x1",
  "x2",
  "f0",
  "f1",
  "map",
  "lookup",
  "say",
  "velocityLinear",
  "pi",
  "where",
  "T1C0",
  "Fresh",
  "Just",
  "Bumper",
  "t1c0a",
]

test.skipIf(database === undefined)("a renamed program means what it meant", async () => {
  let done = 0
  let refused = 0
  const candidates: Candidate[] = []
  const [first, programs] = [firstSeed, cases(7)]
  for (let seed = first; seed < first + programs; seed++) {
    if (seed % 10 === 0) await breathe()
    const {workspace, whole} = generateProgram(seed, 12 + (seed % 30))
    if (!whole) continue
    const dice = new Dice(seed)
    const binders = bindersOf(workspace)
    const text = toHaskell(workspace).text
    for (let i = 0; i < 6; i++) {
      const binder = dice.pick(binders)
      const name = dice.pick(dice.once(3) ? binders.map(b => b.name) : names)
      if (name === binder.name || binder.name === "main") continue
      const after = renamed(workspace, binder, name)
      const what = `seed ${seed}: ${binder.name} to ${name}\n${text}`
      if (typeof after === "string") {
        refused++
        // A name that nothing else has is never refused.
        expect(["fresh", "Fresh"].includes(name) && after.includes("already"), `${what}\n${after}`).toBe(
          false,
        )
        continue
      }
      done++
      // Generated functions may override each other's commands, under either name.
      expect(
        infer(after).problems.filter(p => p.kind !== "conflict"),
        what,
      ).toEqual([])
      expect(typesOf(after), what).toEqual(typesOf(workspace))
      // The way back leads home: nothing was caught on the way.
      const home = renamed(after, binder, binder.name)
      expect(typeof home === "string" ? home : toHaskell(home).text, what).toBe(text)
      candidates.push(candidate(`N${seed}x${i}`, after))
    }
  }
  const complaints = [...(await compileAll(database ?? "", candidates))]
  expect(
    complaints.map(([name, complaint]) => `${candidates.find(c => c.name === name)?.text}\n${complaint}`),
  ).toEqual([])
  expect(done).toBeGreaterThan(2 * programs)
  if (isNightly) expect(refused).toBeGreaterThan(40)
})

test("a type's new name stands wherever a type is written, and constructors keep theirs", () => {
  const block = (
    id: string,
    type: string,
    extraState: NonNullable<SavedBlock["extraState"]>,
  ): SavedBlock => ({
    id,
    type,
    x: 0,
    y: 0,
    extraState,
  })
  const workspace: SavedWorkspace = {
    blocks: {
      languageVersion: 0,
      blocks: [
        block("type", "data", {name: "Way", constructors: [{name: "Way", fields: [{type: "Double"}]}]}),
        block("other", "synonym", {name: "Ways", type: "[Way]"}),
        block("use", "define", {name: "go", arity: 1, equations: [{}], signature: "Way -> Memory Way"}),
      ],
    },
  }
  const binder: Binder = {block: workspace.blocks.blocks[0]!, key: "name", name: "Way"}
  const after = renamed(workspace, binder, "Path")
  expect(typeof after === "string" ? after : after.blocks.blocks.map(b => b.extraState)).toEqual([
    {name: "Path", constructors: [{name: "Way", fields: [{type: "Double"}]}]},
    {name: "Ways", type: "[Path]"},
    {name: "go", arity: 1, equations: [{}], signature: "Path -> Memory Path"},
  ])
  expect(renamed(workspace, binder, "Ways")).toBe("There is another `Ways` already.")
  expect(renamed(workspace, binder, "way")).toBe("This name is one word that starts with a capital letter.")
})

test("a pattern's name is a word, and what an instance defines keeps the name that its class gave it", () => {
  const define = (id: string, name: string, inputs: SavedBlock["inputs"]): SavedBlock => ({
    type: "define",
    id,
    extraState: {name, arity: 1, equations: [{}]},
    inputs: inputs ?? {},
  })
  const workspace: SavedWorkspace = {
    blocks: {
      languageVersion: 0,
      blocks: [
        define("f", "f", {P0_0: {block: {type: "pattern_name", id: "x", extraState: {name: "x"}}}}),
        {type: "data", id: "m", extraState: {name: "M", constructors: [{name: "M", fields: []}]}},
        {
          type: "instance",
          id: "i",
          extraState: {head: "instance Show M"},
          inputs: {
            D: {
              block: define("show", "show", {
                E0_0: {block: {type: "text", id: "t", extraState: {value: ""}}},
              }),
            },
          },
        },
      ],
    },
  }
  expect(rename(workspace, "x", "name", "<>")).toMatchObject({ok: false})
  expect(rename(workspace, "f", "name", "<>")).toMatchObject({ok: true})
  expect(rename(workspace, "show", "name", "tell")).toEqual({
    ok: false,
    why: "`tell` is no part of `Show`.",
  })
})
