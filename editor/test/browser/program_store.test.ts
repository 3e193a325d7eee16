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
    const programStore = openProgramStore(shared, here)
    programStore.save("mine", "walk", "move = 1", 1)
    programStore.setCurrent(null)
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
    const programStore = openProgramStore(storage(), storage())
    programStore.save("mine", "walk", "move = 1", 1)
    expect(programStore.isFirstVisit()).toBe(false)
  })
})

describe("deleted programs", () => {
  it("leave the list, are not opened after a reload, and can be restored", () => {
    const shared = storage()
    const tab = storage()
    const programStore = openProgramStore(shared, tab)
    programStore.save("a", "walk", "move = 1", 1)
    programStore.save("b", "turn", "turn = 2", 2)
    programStore.remove("b", 3)
    expect(names(programStore.programs())).toEqual(["walk"])
    expect(names(programStore.deleted())).toEqual(["turn"])
    expect(openProgramStore(shared, tab).current()).toBeNull()
    programStore.restore("b")
    expect(names(programStore.programs())).toEqual(["turn", "walk"])
    expect(programStore.read("b")).toBe("turn = 2")
  })

  it("are removed, those deleted first before the others, when there are more than 20", () => {
    const programStore = openProgramStore(storage(), storage())
    for (let n = 0; n < 22; n += 1) {
      programStore.save(`id${n}`, `program ${n}`, "x = 1", n)
      programStore.remove(`id${n}`, 100 + n)
    }
    expect(programStore.deleted()).toHaveLength(20)
    expect(names(programStore.deleted())).not.toContain("program 1")
    expect(programStore.read("id1")).toBeNull()
    expect(programStore.read("id2")).toBe("x = 1")
  })

  it("make way for a program when the storage is full and are named; programs of the list never do", () => {
    const gone: (readonly string[])[] = []
    const programStore = openProgramStore(limited(290), storage(), names => gone.push(names))
    expect(programStore.save("a", "old", "x".repeat(60), 1)).toBe(true)
    expect(programStore.save("b", "gone", "y".repeat(60), 2)).toBe(true)
    programStore.remove("b", 3)
    expect(programStore.save("c", "new", "z".repeat(60), 4)).toBe(true)
    expect(programStore.read("b")).toBeNull()
    expect(gone).toEqual([["gone"]])
    expect(programStore.save("d", "more", "w".repeat(60), 5)).toBe(false)
    expect(names(programStore.programs())).toEqual(["new", "old"])
    expect(programStore.read("a")).toBe("x".repeat(60))
    expect(gone).toHaveLength(1)
  })

  it("make way for another one when the storage is full, so that deleting works", () => {
    // Filled to the last letter: deleting makes the list longer.
    const inner = storage()
    const gone: string[] = []
    const programStore = (most: number) =>
      openProgramStore(limited(most, inner), storage(), names => gone.push(...names))
    programStore(10_000).save("a", "walk", "move = 1", 1)
    programStore(10_000).remove("a", 1_700_000_000_000)
    programStore(10_000).save("b", "turn", "turn = 2", 2)
    programStore(10_000).setPicture("b", "picture")
    const used = Array.from({length: inner.length}, (_, n) => inner.getItem(inner.key(n) ?? "") ?? "").join(
      "",
    ).length
    programStore(used).remove("b", 1_700_000_000_001)
    expect(names(programStore(used).programs())).toEqual([])
    expect(names(programStore(used).deleted())).toEqual(["turn"])
    expect(programStore(used).read("b")).toBe("turn = 2")
    expect(gone).toEqual(["walk"])
  })

  it("of another class make way without their names", () => {
    const gone: string[] = []
    const programStore = openProgramStore(limited(200), storage(), names => gone.push(...names))
    programStore.save("a", "secret", "x".repeat(60), 1)
    programStore.remove("a", 2)
    programStore.hide(id => id === "a")
    expect(programStore.save("b", "mine", "y".repeat(60), 3)).toBe(true)
    expect(programStore.read("a")).toBeNull()
    expect(gone).toEqual([])
  })
})

describe("a renamed program", () => {
  it("keeps its date and its place in the list", () => {
    const programStore = openProgramStore(storage(), storage())
    programStore.save("a", "walk", "move = 1", 1)
    programStore.save("b", "turn", "turn = 2", 2)
    programStore.rename("a", "run", "move = 1 -- run")
    expect(programStore.programs().map(({name, at}) => [name, at])).toEqual([
      ["turn", 2],
      ["run", 1],
    ])
    expect(programStore.read("a")).toBe("move = 1 -- run")
  })
})

describe("the learner's own room while a room of a test replaces it", () => {
  const own = writeWorld({...emptyRoom, name: "my hall"})
  const replaced = {by: "pits 3", own}

  it("is stored for each program, and removed when the room is back", () => {
    const shared = storage()
    openProgramStore(shared, storage()).setReplacedRoom("a", replaced)
    const programStore = openProgramStore(shared, storage())
    expect(programStore.replacedRoom("a")).toEqual(replaced)
    expect(programStore.replacedRoom("b")).toBeNull()
    programStore.setReplacedRoom("a", null)
    expect(programStore.replacedRoom("a")).toBeNull()
    expect(shared.length).toBe(0)
  })

  it("is ignored when what is stored is no room", () => {
    const shared = storage()
    shared.setItem("rosy.room.a", JSON.stringify({by: "pits 3", own: {size: "large"}}))
    shared.setItem("rosy.room.b", "{")
    const programStore = openProgramStore(shared, storage())
    expect([programStore.replacedRoom("a"), programStore.replacedRoom("b")]).toEqual([null, null])
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
