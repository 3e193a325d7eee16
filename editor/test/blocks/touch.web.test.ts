/// Stories of fingers on blocks: a phone, with the real language.

import type {Page} from "playwright-core"
import {afterAll, beforeAll, expect, test} from "vitest"
import {Finger, openStage, type Stage, settled, tree} from "./browser.ts"

/// CSS pixels.
const phone = 390

let stage: Stage
beforeAll(async () => {
  stage = await openStage()
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
  await page.keyboard.type("led")
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
