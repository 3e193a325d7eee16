/// A number of the text is changed by dragging its digits and by keys; a press, a double press and a drag downwards are those of a text.

import type {Page} from "playwright-core"
import {afterAll, beforeAll, expect, inject, test} from "vitest"
import {drag, openStage, type Stage, settled} from "../blocks/browser.ts"
import {openPane, textOf} from "./pane.ts"

let stage: Stage
let page: Page
beforeAll(async () => {
  stage = await openStage(inject("stage"))
  page = await openPane(stage)
})
afterAll(() => stage.close())

/// Writes a text, and answers where the middle of a piece of it is.
async function withText(text: string, piece: string): Promise<{x: number; y: number}> {
  await page.keyboard.press("Control+a")
  await page.keyboard.insertText(text)
  await settled(page)
  return page.evaluate(piece => {
    const walker = document.createTreeWalker(document.querySelector(".cm-content")!, NodeFilter.SHOW_TEXT)
    for (let node = walker.nextNode(); node !== null; node = walker.nextNode()) {
      const at = node.nodeValue?.indexOf(piece) ?? -1
      if (at < 0) continue
      const range = document.createRange()
      range.setStart(node, at)
      range.setEnd(node, at + piece.length)
      const box = range.getBoundingClientRect()
      return {x: box.x + box.width / 2, y: box.y + box.height / 2}
    }
    throw new Error(`expected ${piece} in the text`)
  }, piece)
}

const selected = () => page.evaluate(() => `${getSelection()}`)

test.each([
  ["wait 130", "130", 40, "wait 140"],
  ["wait 130", "130", -40, "wait 120"],
  ["go = Velocity 0.5 0", "0.5", 8, "go = Velocity 0.6 0"],
  ["go = Velocity 0.5 0", "0.5", -44, "go = Velocity (-0.05) 0"],
  ["go = Velocity (-0.05) 0", "0.05", 8, "go = Velocity (-0.04) 0"],
  ["wait 2", "2", 80, "wait 32"],
] as const)("in %s %s dragged %i pixels gives %s", async (text, piece, way, expected) => {
  const from = await withText(text, piece)
  await drag(page, from, {x: from.x + way, y: from.y})
  await settled(page)
  expect(await textOf(page)).toBe(expected)
})

test.each([
  ["a name with a digit", "wait n1", "n1"],
  ["a comment", "wait 1 -- 20", "20"],
  ["a text", 'say "20"', "20"],
  ["a word", "wait 10", "wait"],
])("a drag from %s selects", async (_, text, piece) => {
  const from = await withText(text, piece)
  await drag(page, from, {x: from.x + 40, y: from.y})
  await settled(page)
  expect(await textOf(page)).toBe(text)
  expect(await selected()).not.toBe("")
})

test("a drag downwards from a number selects text", async () => {
  const from = await withText("x = 130\ny = x", "130")
  await page.mouse.move(from.x, from.y)
  await page.mouse.down()
  await page.mouse.move(from.x + 4, from.y + 24, {steps: 8})
  await page.mouse.up()
  expect(await textOf(page)).toBe("x = 130\ny = x")
  expect(await selected()).toContain("\n")
})

test("a press puts the cursor into the number, a double press selects it", async () => {
  const at = await withText("wait 130", "130")
  await page.mouse.click(at.x - 2, at.y)
  await page.keyboard.type("x")
  expect(await textOf(page)).toMatch(/^wait 1(x30|3x0)$/)
  const again = await withText("wait 130", "130")
  await page.mouse.dblclick(again.x, again.y)
  await page.keyboard.type("7")
  expect(await textOf(page)).toBe("wait 7")
})

test.each([
  ["wait 2", "ArrowUp", 3, "wait 5"],
  ["wait 2", "ArrowDown", 3, "wait (-1)"],
  ["wait 0.5", "ArrowUp", 1, "wait 0.55"],
  ["wait x", "ArrowUp", 1, "wait x"],
] as const)("in %s Ctrl+Shift+%s, pressed %i times, gives %s", async (text, key, times, expected) => {
  await withText(text, "wait")
  await page.keyboard.press("End")
  for (let i = 0; i < times; i++) await page.keyboard.press(`Control+Shift+${key}`)
  expect(await textOf(page)).toBe(expected)
})
