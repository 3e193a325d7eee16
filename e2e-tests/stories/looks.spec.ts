/// The page can be seen and used by everybody: contrast, names and roles, by axe-core (WCAG 2.2 A and AA), in light and in dark.

import {expect, type Page} from "@playwright/test"
import {boxAtRest} from "./at_rest.ts"
import {Learner} from "./learner.ts"
import {faults} from "./page_faults.ts"
import {test} from "./story.ts"

/// Buttons of an open dialog whose words stick out of them.
function spilling(page: Page): Promise<readonly string[]> {
  return page
    .locator("dialog[open] button")
    .evaluateAll(buttons =>
      buttons.filter(one => one.scrollWidth > one.clientWidth + 1).map(one => one.textContent ?? ""),
    )
}

for (const colorScheme of ["light", "dark"] as const) {
  test(`nothing on the page is hard to see or without a name, in ${colorScheme} colours`, async ({page}) => {
    await page.emulateMedia({colorScheme, reducedMotion: "reduce"})
    const learner = new Learner(page)
    await learner.opens("accelerateAndPlay")
    await expect(page.locator(".blocklyBlockCanvas .blocklyDraggable").first()).toBeVisible()
    // The whole page is checked once, then only each opened part: a check of the whole page takes seconds.
    const look = async (where: string, part?: string) => {
      expect(await faults(page, part), where).toEqual([])
      expect(await spilling(page), where).toEqual([])
    }
    await look("the page")
    await page.locator(".blocklyToolboxCategory").nth(2).click()
    await look("the toolbox", ".injectionDiv")
    await page.keyboard.press("Escape")
    await page.locator(".menu > button").last().click()
    await look("the menu", ".menu-items")
    await page.keyboard.press("Escape")
    await page.getByRole("button", {name: "Examples"}).click()
    await expect(page.locator("dialog[open] li").first()).toBeVisible()
    await look("the examples", "dialog[open]")
    await page.keyboard.press("Escape")
    await page.getByRole("textbox", {name: "Name of the program"}).fill("walk")
    await page.getByRole("button", {name: "My programs"}).click()
    await expect(page.locator("dialog[open] .program-card").first()).toBeVisible()
    await look("my programs", "dialog[open]")
    await page.keyboard.press("Escape")
    await page.keyboard.press("?")
    await expect(page.locator("dialog[open] kbd").first()).toBeVisible()
    await look("the keys", "dialog[open]")
    await page.keyboard.press("Escape")
    await page.locator(".room-choice").click()
    await expect(page.locator("dialog[open] li").first()).toBeVisible()
    await look("the rooms", "dialog[open]")
    await page.locator("dialog[open] .pair button").first().click()
    await look("the world editor", ".workshop")
    await page.locator(".workshop-bar button.plain").last().click()
    await learner.runsUntil("speed", v => v > 0.3)
    await look("a run")
    for (const tab of await page.getByRole("tab").all()) {
      await tab.click()
      await look(`the tab ${await tab.textContent()}`, ".tabs")
    }
    await learner.stops()
  })
}

for (const viewport of [
  {width: 1366, height: 768},
  {width: 1280, height: 800},
]) {
  test(`a notice moves nothing below it, at ${viewport.width} × ${viewport.height}`, async ({page}) => {
    await page.setViewportSize(viewport)
    // A link that leads nowhere is said in a notice.
    await page.goto("/?example=nowhere")
    const notice = page.getByTestId("notice")
    await expect(notice).toBeVisible()
    const room = page.getByRole("region", {name: "Room"}).locator("canvas")
    const saidAt = await boxAtRest(room)
    await notice.getByRole("button", {name: "Close"}).click()
    await expect(notice).toHaveCount(0)
    expect(await boxAtRest(room)).toEqual(saidAt)
  })
}

test("help on Haskell's own names needs no internet", async ({page}) => {
  await page.route(/^https?:\/\/(?!127\.0\.0\.1)/, route => route.abort())
  await page.goto("/prelude.html#v:even")
  const even = page.locator("[id='v:even']")
  await expect(even).toContainText("even :: Integral a => a -> Bool")
  await expect(even).toBeInViewport()
  expect(await faults(page)).toEqual([])
})

test("the menu opens the licences of everything in the page", async ({page}) => {
  await page.goto("/")
  await page.getByRole("button", {name: "More", exact: true}).click()
  const address = await page.getByText("About Rosy").getAttribute("href")
  const licences = await (await page.request.get(`/${address}`)).text()
  for (const name of ["blockly", "preact", "@fontsource/inter", "tree-sitter-haskell"])
    expect(licences).toContain(`${name} `)
  expect(licences).toContain("SIL OPEN FONT LICENSE")
})
