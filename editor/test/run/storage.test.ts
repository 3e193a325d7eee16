/// What the browser keeps of a learner's programs, in one tab and in several.

import {describe, expect, it} from "vitest"
import {openShelf} from "../../src/run/storage.ts"
import {storage} from "../storage.ts"

describe("the program that is there after a reload", () => {
  it("is the one that this tab had open, whatever another tab did since", () => {
    const shared = storage()
    const here = storage()
    openShelf(shared, here).keep("mine", "walk", "move = 1", 1)
    openShelf(shared, storage()).keep("theirs", "turn", "turn = 2", 2)
    expect(openShelf(shared, here).current()).toEqual({id: "mine", text: "move = 1"})
  })

  it("is, in a new tab, the one that was changed last", () => {
    const shared = storage()
    openShelf(shared, storage()).keep("first", "walk", "move = 1", 1)
    openShelf(shared, storage()).keep("second", "turn", "turn = 2", 2)
    expect(openShelf(shared, storage()).current()).toEqual({id: "second", text: "turn = 2"})
  })

  it("is the last one changed when this tab had only looked at an example", () => {
    const shared = storage()
    const here = storage()
    const shelf = openShelf(shared, here)
    shelf.keep("mine", "walk", "move = 1", 1)
    shelf.setCurrent(null)
    expect(openShelf(shared, here).current()).toEqual({id: "mine", text: "move = 1"})
  })
})
