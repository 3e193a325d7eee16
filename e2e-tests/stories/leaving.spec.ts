/// A learner who leaves the page, or loses it, finds everything again.

import {expect} from "@playwright/test"
import {Learner} from "./learner.ts"
import {test} from "./story.ts"

test("a reload in the middle of a word loses nothing", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  await learner.findsInHaskell("Velocity (vl + 0.5) va")
  await page.keyboard.type("Velocity (vl + 0.5")
  // The bracket that closed by itself.
  await page.keyboard.press("Delete")
  const text = await learner.haskellText()
  expect(text).toContain("= Velocity (vl + 0.5\n")
  await page.goto("/")
  await expect.poll(() => learner.haskellText()).toBe(text)
  await expect(learner.dimmed()).toHaveCount(1)
  await expect(learner.definition("accelerate")).toBeVisible()
})

test("a reload right after the first change does not bring the example back", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  const [, changed] = await learner.takesAStep()
  await page.reload()
  await expect.poll(() => learner.haskellText()).toBe(changed)
})

test("a reload at once after the first key, or after the first change of a block, keeps the change", async ({
  page,
}) => {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  await learner.findsInHaskell("ErrorSound")
  await page.keyboard.insertText("OnSound")
  await page.reload()
  await expect(learner.haskell()).toContainText("Just OnSound")
  await learner.opens("accelerateAndPlay")
  await learner.changesNumber("0.5", "0.25")
  await page.reload()
  await expect(learner.haskell()).toContainText("vl + 0.25")
})

test("after a reload the cursor is where it was, and undo and redo go on", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  const [first, second] = await learner.takesAStep()
  await learner.findsInHaskell("ErrorSound")
  await page.keyboard.insertText("OnSound")
  // Typed and taken back within one picture.
  await page.keyboard.press("Control+z")
  await expect.poll(() => learner.haskellText()).toBe(second)
  await page.reload()
  await expect.poll(() => learner.haskellText()).toBe(second)
  await expect(learner.haskell()).toBeFocused()
  await page.keyboard.press("Control+Shift+z")
  await expect(learner.haskell()).toContainText("Just OnSound")
  const third = await learner.haskellText()
  await page.keyboard.insertText("e")
  await expect(learner.haskell()).toContainText("Just OnSounde")
  await learner.comesBy(() => page.keyboard.press("Control+z"), third, second, first)
  await expect(learner.number("0.5")).toBeVisible()
  await expect(page.getByRole("button", {name: "Undo"})).toBeDisabled()
})

test("a page that crashes has kept what was typed", async ({page, context}) => {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  await learner.findsInHaskell("ErrorSound")
  await page.keyboard.insertText("ButtonSound")
  const text = await learner.haskellText()
  await expect.poll(() => page.evaluate(() => Object.values(localStorage).join())).toContain("ButtonSound")
  const client = await context.newCDPSession(page)
  const crashed = page.waitForEvent("crash")
  client.send("Page.crash").catch(() => {})
  await crashed
  const again = new Learner(await context.newPage())
  await again.page.goto("/")
  await expect.poll(() => again.haskellText()).toBe(text)
})

test("closing the tab loses nothing", async ({page, context}) => {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  await learner.findsInHaskell("ErrorSound")
  await page.keyboard.type("ButtonSound")
  const text = await learner.haskellText()
  const closed = page.waitForEvent("close")
  await page.close({runBeforeUnload: true})
  await closed
  const again = new Learner(await context.newPage())
  await again.page.goto("/")
  await expect.poll(() => again.haskellText()).toBe(text)
})
