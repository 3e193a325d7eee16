/// The backpack: what is stored of it, and what is said when something goes in or comes out.

import {describe, expect, it} from "vitest"
import type {BackpackResult} from "../../src/state/page_state.ts"
import {openBackpackStore} from "../../src/storage/backpack_store.ts"
import {memoryStorage} from "../../src/storage/memory_storage.ts"
import {noticeText} from "../../src/ui/descriptions.ts"

const said = (result: BackpackResult) => noticeText({kind: "backpack", result})
const clip = (name: string) => ({name, others: ["slow"], text: `${name} = slow\n`})

describe("the storage of the backpack", () => {
  it("has what was put in last first, each text once, and not what was removed", () => {
    const storage = memoryStorage()
    const backpack = openBackpackStore(storage)
    for (const name of ["one", "two", "one"]) expect(backpack.put(clip(name))).toBe(true)
    expect(openBackpackStore(storage).list()).toEqual([clip("one"), clip("two")])
    backpack.remove(clip("one"))
    expect(backpack.list()).toEqual([clip("two")])
  })

  it("drops the oldest of too many", () => {
    const backpack = openBackpackStore(memoryStorage())
    for (let i = 0; i < 45; i++) backpack.put(clip(`f${i}`))
    expect(backpack.list()).toHaveLength(40)
    expect(backpack.list()[0]?.name).toBe("f44")
  })

  it("is empty where its text is damaged, and says when nothing can be stored", () => {
    const storage = memoryStorage()
    storage.setItem("rosy.backpack", '[{"name": 1}]')
    expect(openBackpackStore(storage).list()).toEqual([])
    const full: Storage = {
      ...storage,
      getItem: () => null,
      setItem() {
        throw new DOMException("full", "QuotaExceededError")
      },
    }
    expect(openBackpackStore(full).put(clip("one"))).toBe(false)
  })
})

it("a definition that has another name now is said, and so is what was there already", () => {
  const renamed = [{from: "slow", to: "slow2"}]
  expect(said({kind: "unpacked", added: ["backOff", "slow2"], renamed, present: ["Hit"]})).toEqual({
    message: "New in your program: backOff, slow2.",
    hint: "Your program has this already: Hit. slow is called slow2 here, because another slow was there.",
  })
  expect(said({kind: "unpacked", added: [], renamed: [], present: ["slow"]})).toEqual({
    message: "Your program has this already: slow.",
    hint: "",
  })
})
