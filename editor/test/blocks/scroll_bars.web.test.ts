import {afterAll, beforeAll, expect, inject, test} from "vitest"
import {openStage, type Stage, settled} from "./browser.ts"

let stage: Stage
beforeAll(async () => {
  stage = await openStage(inject("stage"))
})
afterAll(() => stage.close())

test("the scroll bars cover no block at rest, appear at the edge and while the workspace scrolls, and move it by mouse", async () => {
  const page = await stage.openOwn()
  const bar = page.locator(".blocklyScrollbarHorizontal.blocklyMainWorkspaceScrollbar")
  const shown = () => bar.evaluate(one => getComputedStyle(one).opacity === "1")
  const position = () => page.evaluate(() => window.blocks.place().x)
  // The place of a block's last word is below the vertical bar.
  await page.evaluate(() => {
    const workspace = window.Blockly.getMainWorkspace() as import("blockly/core").WorkspaceSvg
    const [block] = workspace.getTopBlocks(false) as import("blockly/core").BlockSvg[]
    const view = workspace.getMetricsManager().getViewMetrics()
    const box = block!.getBoundingRectangleWithoutChildren()
    workspace.scroll(view.width - box.right * workspace.scale + 4, 40)
  })
  await settled(page)
  await page.waitForFunction(() => document.querySelector(".rosyScrolling") === null)
  expect(await shown()).toBe(false)
  const host = (await page.locator(".blocklySvg").first().boundingBox())!
  const inView = await page.evaluate(
    ({x, y}) => document.elementFromPoint(x, y)?.closest(".blocklyScrollbarVertical") === null,
    {x: host.x + host.width - 7, y: host.y + 60},
  )
  expect(inView).toBe(true)

  await page.mouse.move(host.x + host.width / 2, host.y + host.height - 7)
  await page.waitForFunction(() => document.querySelector(".rosyNearBars") !== null)
  expect(await shown()).toBe(true)
  const handle = (await bar.locator(".blocklyScrollbarHandle").boundingBox())!
  const before = await position()
  await page.mouse.move(handle.x + handle.width / 2, handle.y + handle.height / 2)
  await page.mouse.down()
  await page.mouse.move(handle.x + handle.width / 2 + 30, handle.y + handle.height / 2, {steps: 4})
  await page.mouse.up()
  expect(await position()).toBeLessThan(before)

  await page.mouse.move(host.x + host.width / 2, host.y + host.height / 2)
  await page.waitForFunction(
    () =>
      document.querySelector(".rosyNearBars") === null && document.querySelector(".rosyScrolling") === null,
  )
  expect(await shown()).toBe(false)
  // The bars go again by themselves.
  await expect
    .poll(
      async () => {
        await page.mouse.wheel(20, 0)
        return shown()
      },
      {timeout: 300_000},
    )
    .toBe(true)
})

test("a wide block can be scrolled until its end is clear of the bars", async () => {
  const page = await stage.openOwn()
  const free = await page.evaluate(() => {
    const workspace = window.Blockly.getMainWorkspace() as import("blockly/core").WorkspaceSvg
    workspace.setScale(2.5)
    const [block] = workspace.getTopBlocks(false) as import("blockly/core").BlockSvg[]
    workspace.scroll(-100_000, 0)
    const view = workspace.getMetricsManager().getViewMetrics(true)
    return view.left + view.width - block!.getBoundingRectangle().right
  })
  expect(free).toBeGreaterThan(15)
})
