/// Two views edited in the same moment: neither edit is lost.

import type {SavedBlock} from "@rosy/codegen"
import {describe, expect, it} from "vitest"
import {mergeWorkspaces} from "../../src/views/blocks/workspace/workspace_merge.ts"

const block = (id: string, value: string): SavedBlock => ({type: "number", id, extraState: {value}})
const workspace = (...blocks: SavedBlock[]) => ({blocks: {languageVersion: 0, blocks}})
const ids = (of: ReturnType<typeof mergeWorkspaces>) =>
  of.blocks.blocks.map(b => `${b.id}=${String(b.extraState?.value)}`).join(" ")

describe("an edit of blocks that had not followed the text yet", () => {
  const shown = workspace(block("a", "1"), block("b", "1"))
  it("keeps what was typed elsewhere", () => {
    const now = workspace(block("a", "1"), block("b", "2"), block("c", "2"))
    expect(ids(mergeWorkspaces(shown, workspace(block("a", "9"), block("b", "1")), now))).toBe("a=9 b=2 c=2")
  })
  it("counts where both have changed the same definition", () => {
    expect(
      ids(mergeWorkspaces(shown, workspace(block("a", "9"), block("b", "1")), workspace(block("a", "2")))),
    ).toBe("a=9")
  })
  it("takes nothing back that was typed into a block that only moved, was folded or unfolded", () => {
    const at = (id: string, value: string, x: number): SavedBlock => ({...block(id, value), x, y: 0})
    const before = workspace(at("a", "1", 0), {...at("b", "1", 0), collapsed: true})
    const moved = workspace({...at("a", "1", 40), collapsed: true}, at("b", "1", 0))
    const now = workspace(at("a", "2", 0), {...at("b", "2", 0), collapsed: true})
    const result = mergeWorkspaces(before, moved, now)
    expect(ids(result)).toBe("a=2 b=2")
    expect(result.blocks.blocks[0]).toEqual({...at("a", "2", 40), collapsed: true})
    expect(result.blocks.blocks[1]).toEqual(at("b", "2", 0))
  })
  it("adds and removes definitions", () => {
    const edited = workspace(block("b", "1"), block("d", "9"))
    expect(ids(mergeWorkspaces(shown, edited, workspace(block("a", "1"), block("b", "2"))))).toBe("b=2 d=9")
  })
  it("is not confused by the order of keys", () => {
    const turned: SavedBlock = {id: "a", extraState: {value: "1"}, type: "number"}
    expect(
      ids(mergeWorkspaces(workspace(block("a", "1")), workspace(turned), workspace(block("a", "2")))),
    ).toBe("a=2")
  })
})
