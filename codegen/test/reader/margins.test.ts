/// Edits of definitions in files whose definitions do not start at the margin, and of definitions with comments: minimal programs.

import {beforeAll, describe, expect, test} from "vitest"
import type {Reader} from "../../src/reader/index.ts"
import {openView, syncBlocks, workspaceOf} from "../../src/reader/index.ts"
import type {SavedBlock} from "../../src/serialized_blocks.ts"
import {everyBlockIn} from "../../src/workspace/inference/workspace_inference.ts"
import {testReader} from "./open.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

function edited(text: string, change: (tops: SavedBlock[]) => void): string {
  const view = openView(reader, text)
  const workspace = structuredClone(workspaceOf(view))
  change(workspace.blocks.blocks as SavedBlock[])
  return syncBlocks(reader, view, workspace).text
}

/// A copy of the first definition under the name `copy`.
function copyFirst(tops: SavedBlock[]): void {
  const twin = structuredClone(tops[0] as SavedBlock)
  for (const [i, b] of [...everyBlockIn(twin)].entries()) b.id = `x${i}`
  twin.extraState = {...twin.extraState, name: "copy"}
  tops.push(twin)
}

function remarkFirst(tops: SavedBlock[]): void {
  Object.assign(tops[0] as SavedBlock, {icons: {comment: {text: "remark"}}})
}

const oneLine = "module M where f x = x + 1\n"
const margin = " ".repeat("module M where ".length)
const twoLines = `module M where f x = x + 1\n${margin}g = 2\n`

describe("a definition on the line of its module", () => {
  test("is copied to the column of the others", () => {
    const copy = `\n${margin}copy :: Num a => a -> a\n${margin}copy x = x + 1\n`
    expect(edited(oneLine, copyFirst)).toBe(oneLine + copy)
    expect(edited(twoLines, copyFirst)).toBe(twoLines + copy)
  })
  test("gets a line of its own below a comment", () => {
    expect(edited(twoLines, remarkFirst)).toBe(
      `module M where\n${margin}-- remark\n${margin}f x = x + 1\n${margin}g = 2\n`,
    )
  })
  test("leaves the line of its module when it is deleted", () => {
    expect(edited(twoLines, tops => tops.splice(0, 1))).toBe(`module M where\n${margin}g = 2\n`)
  })
})

test("a copy keeps the margin of an indented file", () => {
  const text = "module M where\n  f x = x + 1\n\n  g = 2\n"
  expect(edited(text, copyFirst)).toBe(`${text}\n  copy :: Num a => a -> a\n  copy x = x + 1\n`)
})

describe("comments inside a definition stay once", () => {
  const text = (name: string, n: number) =>
    `-- above\n${name} x = x + ${n} -- beside\n  where -- inner\n    -- own line\n    y = {- before -} 2 {- behind -}\n`
  test("when it is renamed", () => {
    const rename = ([top]: SavedBlock[]) => {
      if (top !== undefined) top.extraState = {...top.extraState, name: "other"}
    }
    expect(edited(text("f", 1), rename)).toBe(text("other", 1))
  })
  test("when a number in it changes", () => {
    const change = (tops: SavedBlock[]) => {
      for (const b of tops.flatMap(t => [...everyBlockIn(t)]))
        if (b.type === "number" && b.extraState?.value === "1") b.extraState = {value: "7"}
    }
    expect(edited(text("f", 1), change)).toBe(text("f", 7))
  })
  test("when it is copied", () => {
    const copy = edited(text("f", 1), copyFirst).slice(text("f", 1).length)
    for (const words of ["above", "beside", "inner", "own line", "before"])
      expect(copy.match(new RegExp(`\\b${words}\\b`, "g")), copy).toHaveLength(1)
  })
})
