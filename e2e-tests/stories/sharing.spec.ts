/// A program goes to another person: by a link, on paper, as a part of another page, or as a file that needs no service.

import {pathToFileURL} from "node:url"
import {expect, type Page} from "@playwright/test"
import {Learner, screenshot} from "./learner.ts"
import {test} from "./story.ts"

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
  // The service of the stories listens on this computer alone.
  await expect(page.getByTestId("reach")).toContainText("leads to this computer alone")
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
  await expect(learner.haskell()).toContainText("main = simulate accelerate")
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

test("a page that works everywhere shows blocks, Haskell and the film of the run from a file, and asks nobody for anything", async ({
  page,
  browser,
}) => {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  await learner.runsUntil("speed", v => v > 0.3)
  await learner.stops()
  await page.getByRole("button", {name: "More", exact: true}).click()
  await page.getByText("Share or print…").click()
  const downloading = page.waitForEvent("download")
  await page.getByRole("button", {name: "Save a page that works everywhere"}).click()
  const download = await downloading
  expect(download.suggestedFilename()).toBe("accelerateAndPlay.html")
  const file = test.info().outputPath(download.suggestedFilename())
  await download.saveAs(file)

  const context = await browser.newContext({viewport: {width: 1366, height: 768}})
  const shared = await context.newPage()
  const faults: string[] = []
  shared.on("console", message => message.type() === "error" && faults.push(message.text()))
  shared.on("pageerror", error => faults.push(error.message))
  shared.on("request", request => request.url().startsWith("file:") || faults.push(request.url()))
  await shared.goto(pathToFileURL(file).href)
  await expect(shared.getByRole("heading", {name: "accelerateAndPlay"})).toBeVisible()
  await expect(
    shared.getByRole("img", {name: "Blocks"}).getByText("play", {exact: true}).first(),
  ).toBeVisible()
  await expect(shared.locator("pre")).toContainText("play :: Bumper -> Maybe Sound")
  await expect(shared.getByText("The link works only on the computer")).toBeVisible()
  // The end of the run, with the whole path; the start looks different.
  const room = shared.getByRole("img", {name: "Room", exact: true})
  const atEnd = await room.screenshot()
  for (const [look, width, height, theme] of [
    ["light", 1366, 768, "light"],
    ["dark", 1366, 768, "dark"],
    ["phone", 390, 844, "light"],
  ] as const) {
    await shared.emulateMedia({colorScheme: theme})
    await shared.setViewportSize({width, height})
    expect(await shared.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width)
    await shared.screenshot({path: screenshot(`shared-page-${look}`), fullPage: true})
  }
  await shared.setViewportSize({width: 1366, height: 768})
  const time = shared.getByRole("slider", {name: "Look back in the run"})
  await time.press("Home")
  const clock = shared.getByRole("status")
  const start = await clock.textContent()
  expect((await room.screenshot()).equals(atEnd)).toBe(false)
  await shared.getByRole("button", {name: "Play"}).press("Enter")
  await expect(clock).not.toHaveText(start ?? "")
  await expect(shared.getByRole("button", {name: "Play"})).toBeVisible()
  await expect.poll(async () => (await room.screenshot()).equals(atEnd)).toBe(true)
  const friend = new Learner(await context.newPage())
  await friend.page.goto((await shared.getByRole("link", {name: "Open in Rosy"}).getAttribute("href")) ?? "")
  await expect(friend.haskell()).toContainText("play :: Bumper -> Maybe Sound")
  expect(faults).toEqual([])
})

test("a shared page that cannot be made is said, and can be made after a reload", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("move")
  const part = "**/make_page-*.js"
  await page.route(part, route => route.fulfill({status: 503, body: ""}))
  await page.getByRole("button", {name: "More", exact: true}).click()
  await page.getByText("Share or print…").click()
  await page.getByRole("button", {name: "Save a page that works everywhere"}).click()
  await expect(page.getByText("A part of the page is missing.")).toBeVisible()
  await expect(page.getByText("Reload the page; nothing of yours is lost.")).toBeVisible()
  await page.screenshot({path: screenshot("shared-page-missing")})
  await page.unroute(part)
  await page.reload()
  await expect(learner.haskell()).toContainText("move")
  await page.getByRole("button", {name: "More", exact: true}).click()
  await page.getByText("Share or print…").click()
  const downloading = page.waitForEvent("download")
  await page.getByRole("button", {name: "Save a page that works everywhere"}).click()
  expect((await downloading).suggestedFilename()).toBe("move.html")
})
