/// Limits of size and depth: editing, saving and reopening a long or deep program loses nothing.

import {afterEach, beforeAll, describe, expect, it} from "vitest"
import {blockView} from "../../src/blocks/block_registry.ts"
import {everyNode} from "../../src/model/child_nodes.ts"
import type {Reader, View} from "../../src/reader/index.ts"
import {layoutOf, openView, reasons, syncBlocks, syncText, workspaceOf} from "../../src/reader/index.ts"
import type {SavedBlock, SavedWorkspace} from "../../src/serialized_blocks.ts"
import {toHaskell} from "../../src/workspace/inference/code_generation.ts"
import {everyBlock, infer} from "../../src/workspace/inference/workspace_inference.ts"
import {newProject, parseProject, saveProject} from "../../src/workspace/project_file.ts"
import {rename} from "../../src/workspace/renaming/renaming.ts"
import {breathe} from "../process.ts"
import {testReader} from "./open.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

afterEach(breathe)

const main = "\n\nmain = simulate f\n"
const many = (count: number, part: (i: number) => string, between: string) =>
  Array.from({length: count}, (_, i) => part(i)).join(between)

/// Every value of a program as it is printed: numbers, names, constructors.
const values = (text: string) => text.match(/[\p{L}_][\p{L}\p{N}_']*|\d[\d.]*/gu) ?? []

function saved(view: View): View {
  const file = saveProject({...newProject("p"), haskell: view.text, layout: layoutOf(view)})
  const outcome = parseProject(file)
  if (!outcome.ok) throw new Error(outcome.message)
  expect(outcome.notice).toBeUndefined()
  return openView(reader, outcome.project.haskell, outcome.project.layout)
}

/// The workspace with one block changed.
function edited(view: View, change: (block: SavedBlock) => boolean): SavedWorkspace {
  const workspace = structuredClone(workspaceOf(view))
  for (const block of everyBlock(workspace)) if (change(block)) return workspace
  throw new Error("nothing to edit")
}

function drawable(workspace: SavedWorkspace): void {
  let deepest = 0
  const visit = (block: SavedBlock, depth: number): void => {
    deepest = Math.max(deepest, depth)
    for (const input of Object.values(block.inputs ?? {}))
      for (let b = input.block; b !== undefined; b = b.next?.block) visit(b, depth + 1)
  }
  for (const block of workspace.blocks.blocks) visit(block, 0)
  expect(deepest).toBeLessThan(300)
  expect([...everyBlock(workspace)].length).toBeLessThan(1000)
}

const firstNumber = (block: SavedBlock): boolean => {
  if (block.type !== "number" || block.extraState?.value !== "7") return false
  block.extraState = {value: "8"}
  return true
}

describe("brackets and layout blocks that are nested too deep are not parsed", () => {
  const nested: readonly (readonly [
    what: string,
    open: string,
    close: string,
    around: (text: string) => string,
  ])[] = [
    ["in an expression", "(1 + ", ")", text => `f = ${text}`],
    ["in lists", "[", "]", text => `f = ${text}`],
    ["over lines", "(\n  ", "\n  )", text => `f =\n  ${text}`],
    ["of steps", "(do ", ")", text => `f = ${text}`],
    ["in a pattern", "(Just ", ")", text => `f ${text} = 7`],
    ["in records", "R {a = ", "}", text => `f = ${text}`],
    ["that never close", "(g (", "", text => `f = ${text}`],
    ["in a type of data", "(Maybe ", ")", text => `data T = T ${text}`],
    ["with no bracket but alternatives", "case 1 of x -> ", "", text => `f = ${text}`],
    ["with no bracket but steps", "do ", "", text => `f = ${text}`],
  ]

  it.each(nested)("%s", (_, open, close, around) => {
    let parses = 0
    const counted = Object.create(reader, {
      parse: {
        value: (...given: unknown[]) => {
          parses += 1
          return (reader as unknown as {parse: (...given: unknown[]) => unknown}).parse(...given)
        },
      },
    }) as Reader
    const text = `${around(`${open.repeat(2000)}7${close.repeat(2000)}`)}\n`
    const view = openView(counted, text)
    expect(view.text).toBe(text)
    const [definition] = view.module.pieces
    expect(definition?.declaration).toMatchObject({kind: "raw-declaration", reason: reasons.deep})
    expect(parses).toBe(0)
  })

  it("but those in texts do not count", () => {
    const [definition] = openView(reader, `f = Say "${"(".repeat(2000)}" -- ${"[".repeat(2000)}\n`).module
      .pieces
    expect(definition?.declaration?.kind).toBe("function")
  })
})

describe("what is nested up to the limit of the grammar and deeper is never called wrong", () => {
  const nested: readonly (readonly [what: string, open: string, close: string, perLevel: number])[] = [
    ["brackets", "(", ")", 1],
    ["lists", "[", "]", 1],
    ["steps", "do ", "", 1],
    ["steps in brackets", "(do ", ")", 2],
    ["steps in braces", "do { ", "}", 1],
    ["alternatives", "case 1 of x -> ", "", 1],
    ["alternatives in brackets", "(case 1 of x -> ", ")", 2],
    ["alternatives with steps", "case 1 of x -> do ", "", 2],
    ["functions of alternatives", "\\case x -> ", "", 1],
    ["conditions", "if | x -> ", "", 1],
    ["definitions in definitions", "let a = ", " in a", 1],
    ["definitions behind definitions", "(let a = 1 in ", ")", 1],
    ["definitions below definitions", "x where {a = ", "}", 1],
  ]
  const text = (open: string, close: string, depth: number) =>
    `f = ${open.repeat(depth)}7${close.repeat(depth)}\n`
  it.each(nested)("%s", (_, open, close, perLevel) => {
    for (const contexts of [100, 120, 121, 122, 124, 126, 128, 150, 200, 280]) {
      const [piece] = reader.read(text(open, close, Math.ceil(contexts / perLevel))).pieces
      expect([contexts, piece?.broken]).toEqual([contexts, false])
    }
  })
  it.each(nested)("but what is wrong in less is called so: %s", (_, open, close) => {
    const wrong = text(open, close, 20).replace("7", "7 = =")
    expect(reader.read(wrong).pieces[0]?.broken).toBe(true)
  })
  it("many blocks that do not stand in one another are not deep", () => {
    const steps = many(300, i => `  forM_ x (\\y -> do\n    when y $ do\n      z ${i})`, "\n")
    expect(reader.read(`f = do\n${steps}\n  = =\n`).pieces[0]?.broken).toBe(true)
    const cases = many(300, i => `  ${i} -> case y of\n    0 -> do\n      z`, "\n")
    expect(reader.read(`f x = case x of\n${cases}\n  = =\n`).pieces[0]?.broken).toBe(true)
  })
})

describe("up to 10,000 of a kind", () => {
  const long: readonly (readonly [what: string, text: (count: number) => string])[] = [
    ["equations", count => `${many(count, i => `f ${i} = ${i === 0 ? 7 : 1}`, "\n")}`],
    ["alternatives", count => `f x = case x of\n${many(count, i => `  ${i} -> ${i === 0 ? 7 : 1}`, "\n")}`],
    ["items", count => `f = [${many(count, i => (i === 0 ? "7" : "1"), ", ")}]`],
    ["items of a tuple", count => `f = (${many(count, i => (i === 0 ? "7" : "1"), ", ")})`],
    ["arguments", count => `f = g ${many(count, i => (i === 0 ? "7" : "1"), " ")}`],
    ["parameters", count => `f ${many(count, i => `a${i}`, " ")} = 7`],
    ["parameters of a lambda", count => `f = \\${many(count, () => "_", " ")} -> 7`],
    ["items of a pattern", count => `f [${many(count, () => "_", ", ")}] = 7`],
    ["conditions", count => `f x\n${many(count, i => `  | x == ${i} = ${i === 0 ? 7 : 1}`, "\n")}`],
    ["steps", count => `f = do\n${many(count, i => `  w ${i === 0 ? 7 : 1}`, "\n")}`],
    ["local definitions", count => `f = 7\n  where\n${many(count, i => `    a${i} = 1`, "\n")}`],
  ]
  it.each(long.map(([what, text]) => [10_000, what, text(10_000)] as const))(
    "%d %s: reading, editing one and printing loses nothing",
    (_, __, text) => {
      const view = openView(reader, text + main)
      drawable(workspaceOf(view))
      const again = saved(view)
      expect(again.text).toBe(text + main)
      const [definition] = view.module.pieces
      if (definition?.declaration?.kind !== "raw-declaration") {
        const after = syncBlocks(reader, again, edited(again, firstNumber))
        expect(values(after.text).filter(v => v !== "f")).toEqual(
          values((text + main).replace(/\b7\b/, "8")).filter(v => v !== "f"),
        )
        drawable(workspaceOf(after))
      }
    },
  )

  it("constructors and fields", () => {
    const types = [
      `data T = ${many(4000, i => `C${i}`, " | ")}`,
      `data T = C ${many(10_000, () => "I", " ")}`,
      `data T = C {${many(2000, i => `f${i} :: I`, ", ")}}`,
    ]
    for (const type of types) {
      const view = saved(openView(reader, type + main))
      drawable(workspaceOf(view))
      expect(view.module.pieces[0]?.declaration?.kind).toBe("data")
      const workspace = edited(view, block => {
        if (block.type !== "data") return false
        block.extraState = {...block.extraState, name: "U"}
        return true
      })
      const after = syncBlocks(reader, view, workspace)
      expect(values(after.text)).toEqual(values((type + main).replace("T", "U")))
    }
  })
})

describe("61 and more of a kind, as blocks", () => {
  const view = (text: string) => openView(reader, text + main)

  it("show the first sixty and how many more there are", () => {
    const [top] = workspaceOf(view(`f = [${many(100, i => String(i), ", ")}]`)).blocks.blocks
    const list = top?.inputs?.E0_0?.block
    expect(list?.type).toBe("list")
    const items =
      blockView("list")
        ?.shape(list?.extraState ?? {})
        .rows.flat() ?? []
    expect(items.filter(i => i.kind === "socket")).toHaveLength(60)
    expect(items.filter(i => i.kind === "button")).toHaveLength(0)
    expect(items).toContainEqual({kind: "label", text: "… and 40 more"})
    expect(Object.keys(list?.extraState?.folded ?? {})).toHaveLength(40)
  })

  it("have their types inferred in full", () => {
    const workspace = workspaceOf(view(`f = [${many(100, i => (i === 99 ? "'c'" : "True"), ", ")}]`))
    const {problems} = infer(workspace)
    expect(problems.map(p => p.kind)).toContain("type-mismatch")
    // They are told of the block that is drawn.
    const drawn = new Set([...everyBlock(workspace)].map(b => b.id))
    for (const {block} of problems) if (block !== undefined) expect(drawn).toContain(block)
  })

  it("are renamed where they are not drawn, too", () => {
    const before = view(`f a = [${many(100, () => "a", ", ")}]`)
    const workspace = workspaceOf(before)
    const pattern = [...everyBlock(workspace)].find(b => b.type === "pattern_name")
    const renaming = rename(workspace, pattern?.id ?? "", "name", "b")
    if (!renaming.ok) throw new Error(renaming.why)
    const changes = new Map(renaming.changes.map(c => [c.block, c.extra]))
    const changed = structuredClone(workspace)
    for (const b of everyBlock(changed)) b.extraState = changes.get(b.id ?? "") ?? b.extraState ?? {}
    expect(toHaskell(changed).text.match(/\bb\b/g)).toHaveLength(101)
    expect(toHaskell(changed).text.match(/\ba\b(?!\s*->|\])/g) ?? []).toHaveLength(0)
  })

  it("keep what is not drawn when a button is pressed or the text is typed", () => {
    const before = view(`f = [${many(100, i => String(i), ", ")}]`)
    const after = syncText(reader, before, before.text.replace("99", "98"))
    expect(workspaceOf(after).blocks.blocks[0]?.id).toBe(workspaceOf(before).blocks.blocks[0]?.id)
    const printed = syncBlocks(
      reader,
      after,
      edited(after, b => {
        if (b.type !== "number" || b.extraState?.value !== "0") return false
        b.extraState = {value: "5"}
        return true
      }),
    )
    expect(values(printed.text).slice(0, 102)).toEqual(values(after.text.replace("[0,", "[5,")).slice(0, 102))
  })
})

describe("deep programs", () => {
  const deep: readonly (readonly [full: number, what: string, text: (depth: number) => string])[] = [
    [301, "terms of a sum", depth => `f = ${many(depth, () => "1", " + ")}`],
    [1500, "terms of a sum", depth => `f = ${many(depth, () => "1", " + ")}`],
    [10_000, "terms of a sum", depth => `f = ${many(depth, () => "1", "+")}`],
    [10_000, "terms of a chain to the right", depth => `f = ${many(depth, () => "1", ":")}`],
    [3000, "mixed operators", depth => `f = ${many(depth, i => `${i} * 2`, " + ")}`],
    [2000, "nested parentheses", depth => `f = ${"(".repeat(depth)}1${")".repeat(depth)}`],
    [2000, "nested lists", depth => `f = ${"[".repeat(depth)}1${"]".repeat(depth)}`],
    [2000, "nested patterns", depth => `f ${"(Just ".repeat(depth)}x${")".repeat(depth)} = x`],
    [5000, "links of a pattern", depth => `f (${many(depth, () => "x", ":")}) = 1`],
    [2000, "nested conditions", depth => `f x = ${many(depth, () => "if x then 1 else", " ")} 2`],
    [2000, "nested functions", depth => `f = ${many(depth, () => "\\x ->", " ")} 1`],
    [2000, "signs", depth => `f = ${"negate (".repeat(depth)}1${")".repeat(depth)}`],
    [2000, "parentheses of a type", depth => `f :: ${"(".repeat(depth)}Int${")".repeat(depth)}\nf = 1`],
    [2000, "arrows of a type", depth => `f :: ${many(depth, () => "Int", " -> ")}\nf = 1`],
  ]
  it.each(deep.map(([depth, what, text]) => [depth, what, text(depth)] as const))(
    "%d %s are read, inferred, saved, opened and edited",
    (_, __, text) => {
      const view = openView(reader, text + main)
      const workspace = workspaceOf(view)
      drawable(workspace)
      expect(infer(workspace).definitions.size).toBeGreaterThan(0)
      const again = saved(view)
      expect(again.text).toBe(text + main)
      const [definition] = again.module.pieces
      expect(
        [...everyNode(definition?.declaration ?? {kind: "raw-declaration", text: ""})].length,
      ).toBeGreaterThan(0)
      // Brackets nested deeper than the grammar reads: the whole definition is text.
      if (definition?.declaration?.kind === "raw-declaration") {
        expect(definition.declaration.reason).toBe(reasons.deep)
        expect(definition.declaration.text).toBe(text)
        return
      }
      // A new name prints the whole definition.
      const renamed = syncBlocks(
        reader,
        again,
        edited(again, b => {
          if (b.type !== "define") return false
          b.extraState = {...b.extraState, name: "g"}
          return true
        }),
      )
      const tokens = (t: string) => t.replace(/\bf\b/g, "g").replace(/[\s()]/g, "")
      expect(tokens(renamed.text.split("main")[0] ?? "")).toBe(tokens(text))
      // Printing again changes nothing.
      const twice = openView(reader, renamed.text)
      drawable(workspaceOf(twice))
    },
  )
})

describe("damaged layouts", () => {
  const text = `f = ${many(20, i => String(i), " + ")}${main}`
  it.each([
    ["a block that is none", {declarations: [{name: "f", hash: "", blocks: 3}]}],
    ["no list", {declarations: 7, loose: "x"}],
    ["nothing", null],
  ])("%s: the text opens, with a notice", (_, layout) => {
    const outcome = parseProject(JSON.stringify({rosy: 1, name: "p", haskell: text, layout, world: "empty"}))
    expect(outcome.ok && outcome.project.haskell).toBe(text)
    expect(outcome.ok && outcome.notice?.message).toContain("The program is whole")
  })

  it("blocks nested too deep are made anew", () => {
    let block: SavedBlock = {type: "number", extraState: {value: "1"}}
    for (let i = 0; i < 500; i++) block = {type: "infix", extraState: {op: "+"}, inputs: {L: {block}}}
    const view = openView(reader, text)
    const [first] = layoutOf(view).declarations
    const layout = {
      declarations: [{...first, blocks: {type: "define", extraState: {name: "f"}, inputs: {E0_0: {block}}}}],
      loose: [],
    }
    const outcome = parseProject(JSON.stringify({rosy: 1, name: "p", haskell: text, layout, world: "empty"}))
    if (!outcome.ok) throw new Error(outcome.message)
    expect(outcome.notice).toBeDefined()
    expect(openView(reader, text, outcome.project.layout).text).toBe(text)
  })

  it("blocks with more parts than they draw are made anew", () => {
    const long = `f = [${many(100, () => "7", ", ")}]${main}`
    const view = openView(reader, long)
    const {declarations} = layoutOf(view)
    const inputs = Object.fromEntries(
      Array.from({length: 100}, (_, i) => [`I${i}`, {block: {type: "number", extraState: {value: "7"}}}]),
    )
    const old = declarations.map((d, i) =>
      i === 0
        ? {
            ...d,
            blocks: {
              type: "define",
              extraState: {name: "f", arity: 0, equations: [{}]},
              inputs: {E0_0: {block: {type: "list", extraState: {items: 100}, inputs}}},
            },
          }
        : d,
    )
    const opened = openView(reader, long, {declarations: old, loose: []})
    const after = syncBlocks(reader, opened, edited(opened, firstNumber))
    expect(after.text.match(/7/g)).toHaveLength(99)
    drawable(workspaceOf(after))
  })
})
