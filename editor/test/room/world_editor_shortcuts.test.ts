/// What keys do on the world editor's canvas.

import {expect, it} from "vitest"
import {worldKey} from "../../src/views/room/editor/world_editor_shortcuts.ts"

const press = (key: string, held: object = {}) =>
  worldKey({key, ctrlKey: false, metaKey: false, altKey: false, shiftKey: false, ...held})

it("arrows step, with Shift finely", () => {
  expect(press("ArrowUp")).toEqual({kind: "step", dx: 0, dy: 1, fine: false})
  expect(press("ArrowLeft", {shiftKey: true})).toEqual({kind: "step", dx: -1, dy: 0, fine: true})
})

it("comma and full stop turn, whatever Shift makes of them", () => {
  expect(press(",")).toEqual({kind: "turn", steps: 1, fine: false})
  expect(press(".", {shiftKey: true})).toEqual({kind: "turn", steps: -1, fine: true})
  expect(press(">", {shiftKey: true})).toEqual({kind: "turn", steps: -1, fine: true})
})

it("Enter and Space press, Ctrl+D duplicates, and other chords are not the canvas's", () => {
  expect([press("Enter"), press(" ")]).toEqual([{kind: "press"}, {kind: "press"}])
  expect(press("d", {ctrlKey: true})).toEqual({kind: "duplicate"})
  expect([press("d"), press("Delete", {altKey: true}), press("0", {ctrlKey: true})]).toEqual([
    null,
    null,
    null,
  ])
})
