/// Renaming in programs that come as text: all that names a definition beside its equations changes with it, and nothing else.

import {beforeAll, describe, expect, test} from "vitest"
import {rename} from "../../src/index.ts"
import type {Reader} from "../../src/reader/index.ts"
import {openView, placesToRename, renameContext, syncBlocks, workspaceOf} from "../../src/reader/index.ts"
import type {SavedBlock} from "../../src/serialized_blocks.ts"
import {words} from "../../src/words/index.ts"
import {everyBlock} from "../../src/workspace/inference/workspace_inference.ts"
import {testReader} from "./open.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

/// The text after a name of the definition that has it was changed.
function renamed(text: string, old: string, name: string, key = "name"): string {
  const view = openView(reader, text)
  const workspace = structuredClone(workspaceOf(view))
  const at = (b: SavedBlock) => key.split(".").reduce<unknown>((v, k) => (v as never)?.[k], b.extraState)
  const block = [...everyBlock(workspace)].find(b => ["define", "data"].includes(b.type) && at(b) === old)
  const renaming = rename(workspace, block?.id ?? "", key, name)
  if (!renaming.ok) throw new Error(renaming.why)
  const changes = new Map(renaming.changes.map(c => [c.block, c.extra]))
  for (const b of everyBlock(workspace)) b.extraState = changes.get(b.id ?? "") ?? b.extraState ?? {}
  return syncBlocks(reader, view, workspace).text
}

describe("a new name is written into", () => {
  test("the export list", () => {
    const text = (f: string) =>
      `module Main (\n    main -- speed\n  , ${f}\n  , module Data.List\n  , speeds) where\nimport Data.List\n\n${f} :: Int\n${f} = 1\n\nspeeds = [${f}]\n\nmain = print speeds\n`
    expect(renamed(text("speed"), "speed", "pace")).toBe(text("pace"))
  })
  test("the export list, as an operator", () => {
    const text = (f: string) =>
      `module Main (main, (${f})) where\n\n(${f}) :: Int -> Int -> Int\na ${f} b = a + b\n\nmain = print (1 ${f} 2)\n`
    expect(renamed(text("<+>"), "<+>", "<->")).toBe(text("<->"))
  })
  test("a signature for several names", () => {
    const text = (f: string) => `low, ${f} :: Int\nlow = 1\n${f} = low\n\nmain = print (low, ${f})\n`
    expect(renamed(text("high"), "high", "top")).toBe(text("top"))
  })
  test("a fixity declaration and a pragma", () => {
    const text = (f: string) =>
      `infixl 6 \`${f}\`, \`minus\`\n\n${f} :: Int -> Int -> Int\n${f} a b = a + b\n{-# INLINE ${f} #-}\n\nminus :: Int -> Int -> Int\nminus a b = a - b\n\nmain = print (1 \`${f}\` 2 \`minus\` 3)\n`
    expect(renamed(text("plus"), "plus", "add")).toBe(text("add"))
  })
})

test("a type's new name is written into the heads of its instances and the signatures of their methods", () => {
  const text = (type: string) =>
    `{-# LANGUAGE InstanceSigs #-}\nnewtype ${type} a = Box a\n\ninstance Functor ${type} where\n  fmap :: (a -> b) -> ${type} a -> ${type} b\n  fmap f (Box a) = Box (f a)\n\ninstance Show a => Show (${type} a) where\n  show (Box a) = show a\n\nmain = print (fmap not (Box True))\n`
  expect(renamed(text("Parcel"), "Parcel", "Crate")).toBe(text("Crate"))
})

test("a type in an export list is not its constructor", () => {
  const text = (type: string) =>
    `module Main (main, ${type} (Mode, Halt)) where\n\ndata ${type} = Mode | Halt\n\nf :: ${type} -> Int\nf Mode = 1\nf Halt = 2\n\nmain = print (f Mode)\n`
  expect(renamed(text("Mode"), "Mode", "State")).toBe(text("State"))
})

test("a name that stands alone in a record, for a field and a variable, is not renamed in the text", () => {
  const text = "data R = R {part :: Int}\n\nf R {part} = part + 1\n"
  const outcome = placesToRename(renameContext(reader, text), text.indexOf("part + 1"), "part", "piece")
  expect(outcome).toEqual({ok: false, why: words.renaming.isAlsoTheNameOfAPart("part")})
})

test("a binder in a record that is renamed in its block gets its field written beside it", () => {
  const text = "data R = R {part :: Int}\n\nf R {part} = part + 1\n"
  const view = openView(reader, text)
  const workspace = structuredClone(workspaceOf(view))
  const binder = [...everyBlock(workspace)].find(b => b.type === "pattern_name")
  const renaming = rename(workspace, binder?.id ?? "", "name", "n")
  if (!renaming.ok) throw new Error(renaming.why)
  const changes = new Map(renaming.changes.map(c => [c.block, c.extra]))
  for (const b of everyBlock(workspace)) b.extraState = changes.get(b.id ?? "") ?? b.extraState ?? {}
  expect(syncBlocks(reader, view, workspace).text).toBe(
    "data R = R {part :: Int}\n\nf R {part = n} = n + 1\n",
  )
})
