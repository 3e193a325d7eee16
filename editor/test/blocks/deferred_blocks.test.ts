/// Which blocks of a large program are made later, and that they are found and kept until then.

import type {SavedBlock} from "@rosy/codegen"
import {Workspace} from "blockly/core"
import {expect, test} from "vitest"
import {
  deferrable,
  deferredBlocks,
  holdsBlock,
  setDeferredBlocks,
} from "../../src/views/blocks/workspace/deferred_blocks.ts"

const view = {left: 0, top: 0, width: 800, height: 600}

/// Definitions in columns of two, as the reader places them.
const programOf = (count: number): readonly SavedBlock[] =>
  Array.from({length: count}, (_, i) => ({
    type: "define",
    id: `d${i}`,
    x: 40 + 800 * Math.floor(i / 2),
    y: 40 + 500 * (i % 2),
    inputs: {E0_0: {block: {type: "number", id: `n${i}`}}},
  }))

const ids = (blocks: Iterable<SavedBlock>) => [...blocks].map(block => block.id)

test("a small program is made at once", () => {
  const program = programOf(39)
  expect(deferrable(program, program, view).size).toBe(0)
})

test("of a large one the visible area, half a view around it and the outermost blocks are made at once", () => {
  const program = programOf(100)
  const later = deferrable(program, program, view)
  expect(ids(program.filter(block => !later.has(block)))).toEqual(["d0", "d1", "d2", "d3", "d99"])
})

test("what is left of the visible area and may reach into it is made at once", () => {
  const program = programOf(100)
  const later = deferrable(program, program, {...view, left: 8000})
  expect(ids(program.filter(block => !later.has(block)))).toEqual(["d0", "d20", "d21", "d22", "d23", "d99"])
})

test("of what is loaded again, others than before do not become the outermost ones", () => {
  const program = programOf(100)
  const later = [...deferrable(program, program, view)]
  expect(ids(deferrable(later, program, view))).toEqual(ids(later))
})

test("blocks without a place are made at once", () => {
  const program = programOf(100).map(({x: _, y: __, ...block}) => block)
  expect(deferrable(program, program, view).size).toBe(0)
})

test("a deferred block is found by the id of a block in it", () => {
  const workspace = new Workspace()
  const program = programOf(3)
  setDeferredBlocks(workspace, program)
  const found = [...deferredBlocks(workspace).values()].filter(block => holdsBlock(block, "n1"))
  expect(ids(found)).toEqual(["d1"])
  setDeferredBlocks(workspace, [])
  expect(deferredBlocks(workspace).size).toBe(0)
  workspace.dispose()
})
