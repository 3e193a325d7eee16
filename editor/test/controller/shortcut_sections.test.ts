/// The page of keys tells of every key, in every language.

import {expect, test} from "vitest"
import {en} from "../../../languages/en/page/index.ts"
import {pageKeys} from "../../src/browser/browser_window.ts"
import {worldKeys} from "../../src/views/room/editor/world_editor_shortcuts.ts"
import {roomKeys} from "../../src/views/room/gestures.ts"
import {textKeys} from "../../src/views/source/shortcuts.ts"
import {translations} from "../translations.ts"

test("each key of the page, the text, the room and the world editor is told, and nothing else", () => {
  for (const {keys} of [en, ...translations.map(table => table.page)]) {
    expect(Object.keys(keys.page)).toEqual(expect.arrayContaining(Object.keys(pageKeys)))
    expect(Object.keys(keys.room).sort()).toEqual(Object.keys(roomKeys).sort())
    expect(Object.keys(keys.world).sort()).toEqual(Object.keys(worldKeys).sort())
    expect(Object.keys(keys.text).sort()).toEqual(Object.keys(textKeys).sort())
  }
})

test("what the text editor brings of its own has a key", () => {
  expect(Object.entries(textKeys).filter(([, chords]) => chords.length === 0)).toEqual([])
})
