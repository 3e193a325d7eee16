/// Deleting by the bin, bringing back from the list, and dropping a definition on another.

import {afterAll, beforeAll, expect, inject, test} from "vitest"
import {drag, grip, openStage, type Stage, settled} from "./browser.ts"

let stage: Stage
beforeAll(async () => {
  stage = await openStage(inject("stage"))
})
afterAll(() => stage.close())

type Page = Awaited<ReturnType<Stage["open"]>>

const code = (page: Page) => page.evaluate(() => window.codegen.toHaskell(window.blocks.save()).text)
const middle = async (page: Page, selector: string) => {
  const box = (await page.locator(selector).boundingBox())!
  return {x: box.x + box.width / 2, y: box.y + box.height / 2}
}
const definition = (page: Page, name: string) =>
  page.evaluate(
    wanted =>
      window.blocks.save().blocks.blocks.find(block => block.extraState?.["name"] === wanted)?.id ?? "",
    name,
  )

test("a bin appears while something is dragged, and what falls into it can be restored", async () => {
  const page = await stage.open()
  const before = await code(page)
  expect(await page.locator(".rosyBin").isVisible()).toBe(false)
  expect(await page.locator(".rosyDeleted").isVisible()).toBe(false)
  const from = await grip(page, await definition(page, "play"))
  await drag(page, from, {x: from.x + 40, y: from.y + 40}, true)
  expect(await page.locator(".rosyBin").isVisible()).toBe(true)
  const bin = await middle(page, ".rosyBin")
  await page.mouse.move(bin.x, bin.y, {steps: 4})
  expect(await page.locator(".rosyBin.open").count()).toBe(1)
  await page.mouse.up()
  await settled(page)
  expect(await page.locator(".rosyBin").isVisible()).toBe(false)
  expect(await code(page)).not.toContain("play ::")

  await page.locator(".rosyDeleted").click()
  const entry = page.locator(".blocklyContextMenu .blocklyMenuItem")
  expect(await entry.allTextContents()).toEqual([expect.stringContaining("play (Bumper _ Pressed) =")])
  await entry.click()
  await settled(page)
  expect([...(await code(page))].sort()).toEqual([...before].sort())
  expect(await page.locator(".rosyDeleted").isVisible()).toBe(false)
})

test("a definition that is dropped on another comes to lie beside it", async () => {
  const page = await stage.open()
  const [accelerate, play] = [await definition(page, "accelerate"), await definition(page, "play")]
  const from = await grip(page, play)
  const to = await grip(page, accelerate)
  await drag(page, from, {x: to.x + 30, y: to.y + 30})
  await settled(page)
  const boxes = await page.evaluate(() =>
    window.Blockly.getMainWorkspace()
      .getTopBlocks(false)
      .map(block => (block as import("blockly/core").BlockSvg).getBoundingRectangle()),
  )
  for (const [i, a] of boxes.entries())
    for (const b of boxes.slice(i + 1))
      expect(a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom).toBe(false)
})
