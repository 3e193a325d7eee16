/// The page can be seen and used by everybody: contrast, names and roles, by axe-core (WCAG 2.2 A and AA), in light and in dark.

import {AxeBuilder} from "@axe-core/playwright"
import {expect, type Page, test} from "@playwright/test"
import {Learner, until} from "./learner.ts"

const standard = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"]

/// What axe has against the page as it stands. What blocks look like is drawn, and `families.test.ts` holds its contrast.
async function faults(page: Page): Promise<readonly string[]> {
  const {violations} = await new AxeBuilder({page}).exclude(".blocklyWorkspace").withTags(standard).analyze()
  return violations.flatMap(({id, nodes}) => nodes.map(node => `${id}: ${node.target.join(" ")}`))
}

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
    const look = async (where: string) => {
      expect(await faults(page), where).toEqual([])
      expect(await spilling(page), where).toEqual([])
    }
    await look("the page")
    await page.locator(".blocklyToolboxCategory").nth(2).click()
    await look("the toolbox")
    await page.keyboard.press("Escape")
    await page.locator(".menu > button").last().click()
    await look("the menu")
    await page.keyboard.press("Escape")
    await page.getByRole("button", {name: "Examples"}).click()
    await expect(page.locator("dialog[open] li").first()).toBeVisible()
    await look("the examples")
    await page.keyboard.press("Escape")
    await page.keyboard.press("?")
    await expect(page.locator("dialog[open] kbd").first()).toBeVisible()
    await look("the keys")
    await page.keyboard.press("Escape")
    await page.locator(".room-choice").click()
    await expect(page.locator("dialog[open] li").first()).toBeVisible()
    await look("the rooms")
    await page.locator("dialog[open] .pair button").first().click()
    await look("the world editor")
    await page.locator(".workshop-bar button.plain").last().click()
    await learner.runs()
    await until(learner.robot("speed"), v => v > 0.3)
    for (const tab of await page.getByRole("tab").all()) {
      await tab.click()
      await look(`the tab ${await tab.textContent()}`)
    }
    await learner.stops()
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
