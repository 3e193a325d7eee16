/// Stories of fingers on blocks: a phone, with the real language.

import type {Page} from "playwright-core"
import {afterAll, beforeAll, expect, inject, test} from "vitest"
import {Finger, openStage, type Stage, settled, tree} from "./browser.ts"

/// CSS pixels.
const phone = 390

let stage: Stage
beforeAll(async () => {
  stage = await openStage(inject("stage"))
})
afterAll(() => stage.close())

/// Where a finger takes the first block that is offered.
async function offered(page: Page) {
  const box = await page.locator(".blocklyFlyout .blocklyDraggable").first().boundingBox()
  return {x: box!.x + 14, y: box!.y + 14}
}

test("on a phone a block is searched, its level chosen, and dragged out of what was found", async () => {
  const page = await stage.openForFingers("empty", phone)
  const finger = await Finger.on(page)
  await page.locator(".rosySearch").tap()
  await page.keyboard.type("led1")
  await settled(page)
  await finger.drag(await offered(page), {x: 200, y: 420})
  await settled(page)
  expect(await tree(page)).toEqual([{construct: {A0: {choice: {}}}}])
  expect(await page.locator(".blocklyFlyout").first().isVisible()).toBe(false)

  await page.locator(".rosyLevel select").selectOption("tasks")
  await settled(page)
  expect((await page.locator(".blocklyToolboxCategoryLabel").allTextContents()).indexOf("Tasks")).toBe(1)
  // All of the search can be seen, and nothing of it lies over the blocks.
  const bar = await page.locator(".rosySearch").boundingBox()
  const blocks = await page.locator(".blocklySvg").boundingBox()
  expect(bar!.x).toBeGreaterThanOrEqual(0)
  expect(bar!.y + bar!.height).toBeLessThanOrEqual(blocks!.y)
  await page.context().close()
})

test("a finger that rests on a block opens its menu", async () => {
  const page = await stage.openForFingers("empty", phone)
  const finger = await Finger.on(page)
  await page.locator(".rosySearch").tap()
  await page.keyboard.type("led1")
  await settled(page)
  await finger.down(await offered(page))
  await page.locator(".blocklyContextMenu").waitFor()
  await finger.up()
  await page.keyboard.press("Escape")
  await page.locator(".blocklyContextMenu").waitFor({state: "hidden"})
  await page.context().close()
})

test("a tap on the magnifying glass of a step inserts its definition", async () => {
  const page = await stage.openForFingers("empty", phone)
  await page.evaluate(() =>
    window.blocks.load({
      blocks: {
        languageVersion: 0,
        blocks: [
          {
            id: "main",
            type: "main",
            x: 10,
            y: 20,
            inputs: {
              R0: {block: {id: "do", type: "do", inputs: {S: {block: {id: "beep", type: "step_beep"}}}}},
            },
          },
        ],
      },
    } as unknown as Parameters<typeof window.blocks.load>[0]),
  )
  await settled(page)
  const glass = page.locator(".blocklyBlockCanvas").getByLabel("look inside beep")
  const {x, y, width, height} = (await glass.boundingBox())!
  expect(Math.min(width, height)).toBeGreaterThanOrEqual(24)
  await page.touchscreen.tap(x + width / 2, y + height / 2)
  await settled(page)
  expect(await page.evaluate(() => window.codegen.toHaskell(window.blocks.save()).text)).toMatch(
    /^beep :: Task \(\)$/m,
  )
})

test("a definition is dragged by its comment icon, and the workspace stays", async () => {
  const page = await stage.openForFingers("empty", 1100)
  const finger = await Finger.on(page)
  await page.evaluate(() => {
    window.blocks.load({
      blocks: {
        languageVersion: 0,
        blocks: [
          {
            type: "define",
            id: "f",
            x: 40,
            y: 40,
            icons: {comment: {text: "Drives.", height: 80, width: 160}},
          },
        ],
      },
    })
  })
  await settled(page)
  const icon = await page.locator(".blocklyCommentIcon").boundingBox()
  const at = {x: icon!.x + icon!.width / 2, y: icon!.y + icon!.height / 2}
  const scrolled = () =>
    page.evaluate(() => {
      const {x, y} = window.blocks.place()
      return [Math.round(x), Math.round(y)]
    })
  const before = await scrolled()
  await finger.drag(at, {x: at.x + 90, y: at.y + 120})
  await settled(page)
  expect(await scrolled()).toEqual(before)
  const block = await page.evaluate(() => window.blocks.save().blocks.blocks[0])
  expect(block).toMatchObject({x: 130, y: 160})
})
