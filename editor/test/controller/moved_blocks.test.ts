/// Blocks that the block view has moved while it loaded them: their places are kept, and nothing else changes.

import {infer, type SavedWorkspace} from "@rosy/codegen"
import type {Reader} from "@rosy/codegen/reader"
import {beforeAll, describe, expect, it} from "vitest"
import {testReader} from "../../../codegen/test/reader/open.ts"
import {
  readHaskell,
  readProject,
  withPlaces,
  withText,
  writeProject,
} from "../../src/controller/document/document_conversion.ts"
import {changesBetween} from "../../src/program/text_changes.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

const text = "accelerate (Velocity vl va) = Velocity (vl + 0.5) va\n\nmain = simulate accelerate\n"

function moved({blocks, ...others}: SavedWorkspace): SavedWorkspace {
  return {...others, blocks: {...blocks, blocks: blocks.blocks.map(b => ({...b, x: 40, y: (b.y ?? 0) + 77}))}}
}

describe("blocks that were moved while they were loaded", () => {
  it.each([
    ["", text],
    [" beside a definition whose text is broken", text.replace("(vl + 0.5)", "(vl +")],
  ])("are at their new places when the program is opened again%s", (_, edited) => {
    const {document: first, project} = readHaskell(reader, "x", text)
    const document = withText(reader, first, edited, changesBetween(text, edited))
    const workspace = moved(document.workspace)
    const placed = withPlaces(reader, document, workspace, infer(workspace))
    expect(placed.program.text).toBe(edited)
    expect(placed.dimmed).toEqual(document.dimmed)
    expect(placed.workspace).toBe(workspace)
    const again = readProject(reader, writeProject(project, placed, "x", null))
    if (again?.kind !== "opened") throw new Error("expected an opened program")
    const placesOf = (w: SavedWorkspace) => w.blocks.blocks.map(({x, y}) => [x, y])
    expect(placesOf(again.opened.document.workspace)).toEqual(placesOf(workspace))
  })

  it("stay where the document has them when they say something else", () => {
    const {document} = readHaskell(reader, "x", text)
    const {document: other} = readHaskell(reader, "x", "accelerate x = x\n\nmain = simulate accelerate\n")
    const workspace = {...other.workspace, blocks: {...other.workspace.blocks, blocks: []}}
    expect(withPlaces(reader, document, workspace, infer(workspace))).toBe(document)
  })
})
