/// What the browser keeps of a learner's programs, in one tab and in several.

import {describe, expect, it} from "vitest"
import {memoryStorage as storage} from "../../src/storage/memory_storage.ts"
import {openProgramStore} from "../../src/storage/program_store.ts"
import {writeWorld} from "../../src/worlds/world_encoder.ts"
import {emptyRoom} from "../worlds/worlds.ts"

const names = (programs: readonly {readonly name: string}[]) => programs.map(program => program.name)

describe("the program that is there after a reload", () => {
  it("is the one that this tab had open, whatever another tab did since", () => {
    const shared = storage()
    const here = storage()
    openProgramStore(shared, here).save("mine", "walk", "move = 1", 1)
    openProgramStore(shared, storage()).save("theirs", "turn", "turn = 2", 2)
    expect(openProgramStore(shared, here).current()).toEqual({id: "mine", text: "move = 1"})
  })

  it("is, in a new tab, the one that was changed last", () => {
    const shared = storage()
    openProgramStore(shared, storage()).save("first", "walk", "move = 1", 1)
    openProgramStore(shared, storage()).save("second", "turn", "turn = 2", 2)
    expect(openProgramStore(shared, storage()).current()).toEqual({id: "second", text: "turn = 2"})
  })

  it("is the last one changed when this tab had only looked at an example", () => {
    const shared = storage()
    const here = storage()
    const shelf = openProgramStore(shared, here)
    shelf.save("mine", "walk", "move = 1", 1)
    shelf.setCurrent(null)
    expect(openProgramStore(shared, here).current()).toEqual({id: "mine", text: "move = 1"})
  })
})

describe("a first visit", () => {
  it("lasts until something was begun, in whatever tab", () => {
    const shared = storage()
    expect(openProgramStore(shared, storage()).isFirstVisit()).toBe(true)
    openProgramStore(shared, storage()).setVisited()
    expect(openProgramStore(shared, storage()).isFirstVisit()).toBe(false)
  })

  it("is none where a program is stored, also one of an older version", () => {
    const shelf = openProgramStore(storage(), storage())
    shelf.save("mine", "walk", "move = 1", 1)
    expect(shelf.isFirstVisit()).toBe(false)
  })
})

describe("deleted programs", () => {
  it("leave the list, are not opened after a reload, and can be restored", () => {
    const shared = storage()
    const tab = storage()
    const shelf = openProgramStore(shared, tab)
    shelf.save("a", "walk", "move = 1", 1)
    shelf.save("b", "turn", "turn = 2", 2)
    shelf.remove("b", 3)
    expect(names(shelf.programs())).toEqual(["walk"])
    expect(names(shelf.deleted())).toEqual(["turn"])
    expect(openProgramStore(shared, tab).current()).toBeNull()
    shelf.restore("b")
    expect(names(shelf.programs())).toEqual(["turn", "walk"])
    expect(shelf.read("b")).toBe("turn = 2")
  })

  it("are removed, those deleted first before the others, when there are more than 20", () => {
    const shelf = openProgramStore(storage(), storage())
    for (let n = 0; n < 22; n += 1) {
      shelf.save(`id${n}`, `program ${n}`, "x = 1", n)
      shelf.remove(`id${n}`, 100 + n)
    }
    expect(shelf.deleted()).toHaveLength(20)
    expect(names(shelf.deleted())).not.toContain("program 1")
    expect(shelf.read("id1")).toBeNull()
    expect(shelf.read("id2")).toBe("x = 1")
  })

  it("make way for a program when the storage is full and are named; programs of the list never do", () => {
    const gone: (readonly string[])[] = []
    const shelf = openProgramStore(limited(290), storage(), names => gone.push(names))
    expect(shelf.save("a", "old", "x".repeat(60), 1)).toBe(true)
    expect(shelf.save("b", "gone", "y".repeat(60), 2)).toBe(true)
    shelf.remove("b", 3)
    expect(shelf.save("c", "new", "z".repeat(60), 4)).toBe(true)
    expect(shelf.read("b")).toBeNull()
    expect(gone).toEqual([["gone"]])
    expect(shelf.save("d", "more", "w".repeat(60), 5)).toBe(false)
    expect(names(shelf.programs())).toEqual(["new", "old"])
    expect(shelf.read("a")).toBe("x".repeat(60))
    expect(gone).toHaveLength(1)
  })

  it("make way for another one when the storage is full, so that deleting works", () => {
    // Filled to the last letter: deleting makes the list longer.
    const inner = storage()
    const gone: string[] = []
    const shelf = (most: number) =>
      openProgramStore(limited(most, inner), storage(), names => gone.push(...names))
    shelf(10_000).save("a", "walk", "move = 1", 1)
    shelf(10_000).remove("a", 1_700_000_000_000)
    shelf(10_000).save("b", "turn", "turn = 2", 2)
    shelf(10_000).setPicture("b", "picture")
    const used = Array.from({length: inner.length}, (_, n) => inner.getItem(inner.key(n) ?? "") ?? "").join(
      "",
    ).length
    shelf(used).remove("b", 1_700_000_000_001)
    expect(names(shelf(used).programs())).toEqual([])
    expect(names(shelf(used).deleted())).toEqual(["turn"])
    expect(shelf(used).read("b")).toBe("turn = 2")
    expect(gone).toEqual(["walk"])
  })

  it("of another class make way without their names", () => {
    const gone: string[] = []
    const shelf = openProgramStore(limited(200), storage(), names => gone.push(...names))
    shelf.save("a", "secret", "x".repeat(60), 1)
    shelf.remove("a", 2)
    shelf.hide(id => id === "a")
    expect(shelf.save("b", "mine", "y".repeat(60), 3)).toBe(true)
    expect(shelf.read("a")).toBeNull()
    expect(gone).toEqual([])
  })
})

describe("a renamed program", () => {
  it("keeps its date and its place in the list", () => {
    const shelf = openProgramStore(storage(), storage())
    shelf.save("a", "walk", "move = 1", 1)
    shelf.save("b", "turn", "turn = 2", 2)
    shelf.rename("a", "run", "move = 1 -- run")
    expect(shelf.programs().map(({name, at}) => [name, at])).toEqual([
      ["turn", 2],
      ["run", 1],
    ])
    expect(shelf.read("a")).toBe("move = 1 -- run")
  })
})

describe("the learner's own room while a room of a test replaces it", () => {
  const own = writeWorld({...emptyRoom, name: "my hall"})
  const replaced = {by: "pits 3", own}

  it("is stored for each program, and removed when the room is back", () => {
    const shared = storage()
    openProgramStore(shared, storage()).setReplacedRoom("a", replaced)
    const shelf = openProgramStore(shared, storage())
    expect(shelf.replacedRoom("a")).toEqual(replaced)
    expect(shelf.replacedRoom("b")).toBeNull()
    shelf.setReplacedRoom("a", null)
    expect(shelf.replacedRoom("a")).toBeNull()
    expect(shared.length).toBe(0)
  })

  it("is ignored when what is stored is no room", () => {
    const shared = storage()
    shared.setItem("rosy.room.a", JSON.stringify({by: "pits 3", own: {size: "large"}}))
    shared.setItem("rosy.room.b", "{")
    const shelf = openProgramStore(shared, storage())
    expect([shelf.replacedRoom("a"), shelf.replacedRoom("b")]).toEqual([null, null])
  })
})

/// A storage that takes so many letters of values.
function limited(most: number, inner = storage()): Storage {
  const size = (except: string) =>
    Array.from({length: inner.length}, (_, n) => inner.key(n) ?? "")
      .filter(key => key !== except)
      .reduce((sum, key) => sum + (inner.getItem(key) ?? "").length, 0)
  return {
    ...inner,
    get length() {
      return inner.length
    },
    setItem(key, value) {
      if (size(key) + value.length > most) throw new DOMException("full", "QuotaExceededError")
      inner.setItem(key, value)
    },
  }
}
