/// A program goes to another person: by a link, on paper, or as a part of another page.

import {expect, type Page} from "@playwright/test"
import {Learner} from "./learner.ts"
import {test as story} from "./story.ts"
import {inTurn} from "./turns.ts"

const test = inTurn(story, import.meta.url)

/// The link in the share dialog.
async function linkOf(page: Page): Promise<string> {
  await page.getByRole("button", {name: "More", exact: true}).click()
  await page.getByText("Share or print…").click()
  return page.getByRole("textbox", {name: "Link"}).inputValue()
}

test("a link opens the whole program in a browser that has never seen it, and a change to it is kept", async ({
  page,
  browser,
}) => {
  const learner = new Learner(page)
  await learner.opens("forwardBackward")
  await learner.changesNumber("0.5", "0.25")
  await expect(learner.haskell()).toContainText("0.25")
  const text = await learner.haskellText()
  const link = await linkOf(page)
  await expect(page.getByRole("img", {name: "QR code"})).toBeVisible()
  await learner.keeps("share")

  const other = await browser.newContext()
  const friend = new Learner(await other.newPage())
  await friend.page.goto(link)
  await expect.poll(() => friend.haskellText()).toBe(text)
  await expect(friend.page.getByRole("textbox", {name: "Name of the program"})).toHaveValue("forwardBackward")
  await friend.page.reload()
  await expect.poll(() => friend.haskellText()).toBe(text)
  await friend.changesNumber("0.25", "0.75")
  await friend.page.reload()
  await expect(friend.haskell()).toContainText("0.75")
  expect(friend.page.url()).not.toContain("#")
  await other.close()
})

test("a damaged link gives one sentence, and the page works", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  const link = await linkOf(page)
  await page.goto("about:blank")
  await page.goto(link.slice(0, -10))
  await expect(page.getByTestId("notice")).toHaveText(
    "This link is damaged. Copy the whole link and open it again.",
  )
  await expect(learner.haskell()).toContainText("play :: Bumper -> Maybe Sound")
  // The whole link, pasted into the address bar of the open page.
  await page.goto(link)
  await expect(page.getByTestId("notice")).toHaveCount(0)
  await learner.runsUntil("speed", v => v > 0.3)
  await learner.stops()
})

test("an embedded program shows its blocks, runs, and leaves nothing in the browser", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  const link = new URL(await linkOf(page))
  await page.evaluate(() => localStorage.clear())
  await page.goto("about:blank")
  await page.goto(`${link.origin}/?embed${link.hash}`)
  await expect(learner.definition("accelerate")).toBeVisible()
  await expect(page.getByRole("button", {name: "More", exact: true})).toHaveCount(0)
  await learner.runsUntil("speed", v => v > 0.3)
  await learner.stops()
  await learner.changesNumber("0.5", "0.25")
  await learner.keeps("embedded")
  expect(
    await page.evaluate(() => Object.keys(localStorage).filter(key => key.startsWith("rosy.program"))),
  ).toEqual([])
})

test("on paper stand the name, the blocks and the Haskell", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  // What the browser does around printing.
  await page.evaluate(() => window.dispatchEvent(new Event("beforeprint")))
  await page.emulateMedia({media: "print"})
  await expect(page.getByRole("heading", {name: "accelerateAndPlay"})).toBeVisible()
  await expect(page.locator(".print-sheet pre")).toContainText("play :: Bumper -> Maybe Sound")
  const drawn = page.locator(".print-sheet .blocklyPath:visible")
  await expect.poll(() => drawn.count()).toBeGreaterThan(15)
  // The blocks have the colours that they have on the page: words are light on them.
  await expect(page.locator(".print-sheet .blocklyText").first()).toHaveCSS("fill", "rgb(255, 255, 255)")
  await expect(page.locator("#page")).toBeHidden()
  await learner.keeps("paper")
  await page.evaluate(() => window.dispatchEvent(new Event("afterprint")))
  await page.emulateMedia({media: "screen"})
  await expect(page.locator(".print-sheet")).toHaveCount(0)
  await expect(learner.runButton()).toBeVisible()
})
