/// Quick hands on a slow machine: what is done before the page has shown the step before it is lost nowhere, and goes nowhere else.

import {expect, type Page} from "@playwright/test"
import {boxAtRest} from "./at_rest.ts"
import {Learner} from "./learner.ts"
import {test} from "./story.ts"

/// A machine that shows no picture until it is told to.
async function showsNothing(page: Page): Promise<void> {
  await page.evaluate(() => {
    const shows = window.requestAnimationFrame.bind(window)
    const waiting: FrameRequestCallback[] = []
    window.requestAnimationFrame = draw => waiting.push(draw)
    Object.assign(window, {
      /// Shows one picture, or from now on every one.
      picture(all: boolean) {
        if (all) window.requestAnimationFrame = shows
        for (const draw of waiting.splice(0)) draw(performance.now())
      },
    })
  })
}

const shows = (page: Page, how: "one picture" | "all") =>
  page.evaluate(async all => {
    ;(window as Window & {picture?: (all: boolean) => void}).picture?.(all)
    // What a picture asked for comes behind it.
    await new Promise(done => setTimeout(done))
    await new Promise(done => setTimeout(done))
  }, how === "all")

test("a menu that is opened again before its end is seen stays open", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("move")
  const more = await boxAtRest(page.getByRole("button", {name: "More", exact: true}))
  const presses = () => page.mouse.click(more.x + more.width / 2, more.y + more.height / 2)
  await presses()
  const entry = page.getByRole("button", {name: "New program", exact: true})
  await expect(entry).toBeVisible()
  await showsNothing(page)
  await page.keyboard.press("Escape")
  await presses()
  await shows(page, "all")
  await expect(entry).toBeVisible()
  await presses()
  await expect(entry).toHaveCount(0)
})

test("what is typed before a change of the blocks is seen does not take it back", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  await learner.haskell().click()
  await page.keyboard.press("Control+End")
  const less = learner.block("remove the last case").first()
  await less.hover()
  await showsNothing(page)
  await page.mouse.down()
  await page.mouse.up()
  await shows(page, "one picture")
  await learner.haskell().focus()
  await page.keyboard.insertText("\n-- Ouch!")
  await shows(page, "all")
  await expect(learner.haskell()).not.toContainText("Released")
  await expect(learner.haskell()).toContainText("-- Ouch!")
  await expect(learner.definition("play")).not.toContainText("Released")
})

test("a letter right after Tab stands where the cursor was", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  await learner.haskell().click()
  await page.keyboard.press("Control+End")
  const before = await learner.haskellText()
  await learner.changesNumber("0.5", "0.25")
  await page.getByRole("button", {name: "Hide Haskell"}).focus()
  // So soon that nothing else has its turn between the two.
  await page.evaluate(() =>
    window.addEventListener("focusin", () => document.execCommand("insertText", false, "-- Ouch!"), {
      once: true,
    }),
  )
  await page.keyboard.press("Tab")
  await expect.poll(() => learner.haskellText()).toBe(`${before.replace("0.5", "0.25")}\n-- Ouch!`)
})

/// Holds the answer with this example back until it is let come.
async function holdsBack(page: Page, example: string): Promise<() => void> {
  let comes = () => {}
  const coming = new Promise<void>(come => {
    comes = come
  })
  await page.route(`**/api/examples/${example}`, async route => {
    await coming
    await route.continue()
  })
  return comes
}

test("nobody writes or builds where the first program is about to stand", async ({page}) => {
  const learner = new Learner(page)
  const comes = await holdsBack(page, "accelerate")
  await page.goto("/")
  await learner.haskell().click()
  await page.keyboard.type("abc")
  const category = await boxAtRest(page.locator(".blocklyToolboxCategory").nth(2))
  await page.mouse.click(category.x + 10, category.y + 10)
  comes()
  await expect(learner.haskell()).toContainText("simulate")
  await expect(learner.haskell()).not.toContainText("abc")
  await expect(page.locator(".blocklyFlyout")).toBeHidden()
  // Nor is it kept as a program.
  await page.getByRole("button", {name: "Examples"}).click()
  await expect(page.getByRole("dialog").getByRole("button", {name: /^forwardBackward/})).toBeVisible()
  await page.keyboard.press("Escape")
  await page.getByRole("button", {name: "My programs"}).click()
  await expect(page.getByRole("dialog").locator(".program-card")).toHaveCount(0)
})

test("the example that was wished for last stays, also when an earlier one comes late", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("move")
  const comes = await holdsBack(page, "accelerate")
  const asks = async (example: RegExp) => {
    await page.getByRole("button", {name: "Examples"}).click()
    await page.getByRole("dialog").getByRole("button", {name: example}).click()
  }
  await asks(/^accelerate\b/)
  await page.keyboard.press("Escape")
  await asks(/^forwardBackward/)
  await expect(learner.haskell()).toContainText("forwardBackward")
  const late = page.waitForResponse(/api\/examples\/accelerate/)
  comes()
  await (await late).finished()
  await learner.runs()
  await expect(learner.status()).toHaveText("Running")
  await expect(learner.haskell()).toContainText("forwardBackward")
  await learner.stops()
})
