/// Blocks that are put back, by an undo or by hand, bring back every character of the text.

import {beforeAll, expect, test} from "vitest"
import type {Reader, View} from "../../src/reader/index.ts"
import {openView, spansOf, syncBlocks, syncText, workspaceOf} from "../../src/reader/index.ts"
import type {SavedWorkspace} from "../../src/serialized_blocks.ts"
import {cases, rerun, seed} from "../extent.ts"
import {Dice} from "../generate/random.ts"
import {breathe} from "../process.ts"
import {editKinds, randomEdit} from "./exact_edits.ts"
import {corpus, testReader} from "./open.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

const sync = (view: View, workspace: SavedWorkspace) => syncBlocks(reader, view, structuredClone(workspace))

/// The workspace without one of its definitions.
function withoutDefinition(view: View, dice: Dice): SavedWorkspace {
  const {blocks, ...rest} = workspaceOf(view)
  const gone = dice.below(view.declarations.length)
  return {...rest, blocks: {...blocks, blocks: blocks.blocks.filter((_, i) => i !== gone)}}
}

test("after one to three random edits, block by block", async () => {
  const dice = new Dice(seed)
  for (let made = 0; made < cases(40); ) {
    await breathe()
    const start = openView(reader, dice.pick(corpus).text)
    const steps: View[] = [start]
    for (let i = 0; i <= dice.below(3); i++) {
      const view = steps[steps.length - 1] ?? start
      const workspace = dice.once(4)
        ? withoutDefinition(view, dice)
        : randomEdit(view, dice, dice.pick(editKinds))?.workspace
      if (workspace === undefined) break
      const next = sync(view, workspace)
      if (next.refused === undefined) steps.push(next)
    }
    if (steps.length === 1) continue
    made++
    let view = steps.pop() ?? start
    for (const before of steps.reverse()) {
      view = sync(view, workspaceOf(before))
      expect(view.text, `${JSON.stringify(view.text)} (${rerun})`).toBe(before.text)
      expect(spansOf(view)).toEqual(spansOf(before))
    }
  }
})

test("a block that was moved away and back, in two steps", () => {
  const text = "main = print   $ f  {- why -}  3\n\nf x = x   +1 -- one\n"
  const view = openView(reader, text)
  const away = structuredClone(workspaceOf(view))
  const [first] = away.blocks.blocks
  const inner = first?.inputs?.E0_0
  if (first === undefined || inner?.block === undefined) throw new Error("no block")
  const loose = inner.block
  delete inner.block
  const moved = sync(view, {...away, blocks: {...away.blocks, blocks: [...away.blocks.blocks, loose]}})
  expect(moved.text).not.toBe(text)
  expect(sync(moved, workspaceOf(view)).text).toBe(text)
})

test("text that was typed meanwhile stays", () => {
  const view = openView(reader, "f   x = x +1\n\ng = 2\n")
  const edited = sync(view, {
    ...workspaceOf(view),
    blocks: {languageVersion: 0, blocks: workspaceOf(view).blocks.blocks.slice(0, 1)},
  })
  const typed = syncText(reader, edited, `-- new\n\n${edited.text}`)
  const back = sync(typed, workspaceOf(view))
  expect(back.text).toContain("-- new")
  expect(back.text).toContain("g = 2")
})
