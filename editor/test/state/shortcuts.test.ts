/// How keys are written and told.

import {describe, expect, test} from "vitest"
import {isChord, keyLines, keysOf} from "../../src/state/shortcuts.ts"

const none = {ctrlKey: false, metaKey: false, altKey: false, shiftKey: false}

describe("a chord", () => {
  test("is its keys, and a minus is one of them", () => {
    expect(keysOf("Mod-Shift-z")).toEqual(["Mod", "Shift", "z"])
    expect(keysOf("-")).toEqual(["-"])
    expect(keysOf("Mod--")).toEqual(["Mod", "-"])
  })

  test("is pressed with its modifiers and no others", () => {
    const undo = {...none, key: "z", ctrlKey: true}
    expect(isChord(undo, "Mod-z")).toBe(true)
    expect(isChord({...none, key: "z", metaKey: true}, "Mod-z")).toBe(true)
    expect(isChord({...undo, shiftKey: true, key: "Z"}, "Mod-z")).toBe(false)
    expect(isChord({...undo, shiftKey: true, key: "Z"}, "Mod-Shift-z")).toBe(true)
    expect(isChord({...undo, altKey: true}, "Mod-z")).toBe(false)
    expect(isChord({...none, key: "z"}, "Mod-z")).toBe(false)
  })

  test("of a sign does not ask whether the keyboard needs Shift for it", () => {
    expect(isChord({...none, key: "?", shiftKey: true}, "?")).toBe(true)
    expect(isChord({...none, key: "+", shiftKey: true}, "+")).toBe(true)
    expect(isChord({...none, key: "+", ctrlKey: true}, "+")).toBe(false)
  })
})

test("keys that do the same are one line, and what has no key is none", () => {
  const keys = {left: ["ArrowLeft"], right: ["ArrowRight"], stop: [" "], gone: []}
  expect(keyLines({stop: "Stop", left: "Move", right: "Move", gone: "Gone"}, keys)).toEqual([
    {does: "Stop", chords: [" "]},
    {does: "Move", chords: ["ArrowLeft", "ArrowRight"]},
  ])
})
