/// Stored pictures of blocks: they come from the browser's storage, so damage and markup must not reach the page.

import {expect, it} from "vitest"
import {readBlockPicture} from "../../src/browser/block_picture.ts"

const outline = {x: 40, y: 40, path: "m 0,0 h 10 v 10 z", colour: "#0b6fa4"}

it("reads what was taken", () => {
  expect(readBlockPicture(JSON.stringify([outline]))).toEqual([outline])
})

it("shows nothing of a damaged picture, and no colour that is none", () => {
  expect(readBlockPicture(null)).toEqual([])
  expect(readBlockPicture("[{")).toEqual([])
  expect(readBlockPicture(JSON.stringify([{...outline, x: "40"}]))).toEqual([])
  expect(readBlockPicture(JSON.stringify([{...outline, colour: "url(https://example.org)"}]))).toEqual([])
})
