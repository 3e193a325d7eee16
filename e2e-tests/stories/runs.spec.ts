/// Runs in a room as a tree: a branch, an earlier run looked at again, and two runs in one picture.

import {AxeBuilder} from "@axe-core/playwright"
import {expect, type Page} from "@playwright/test"
import {Learner, screenshot, until} from "./learner.ts"
import {test} from "./story.ts"

const rows = (page: Page) => page.getByRole("tree", {name: "Runs"}).getByRole("treeitem")

test("a branch of a run is compared with the run that it came from", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("move")
  await learner.runs()
  await until(learner.robot("time"), time => time > 2)
  await page.getByRole("slider", {name: "Look back in the run"}).fill("1")
  // The tree is found where a branch begins.
  await page.getByRole("button", {name: "Show the runs in this room"}).click()
  await expect(rows(page)).toHaveText([/^Run 1/])
  await learner.changesNumber("0.5", "0.2")
  await expect(learner.haskell()).toContainText("Velocity 0.2")
  await page.getByRole("button", {name: "Continue from here"}).click()
  await expect(learner.status()).toHaveText("Running")
  await until(learner.robot("time"), time => time > 1.5)
  await learner.stops()

  // The tree names the change.
  await expect(rows(page)).toHaveCount(2)
  await expect(rows(page).nth(0)).toContainText("Run 1")
  // A slow page gets fewer frames: then the one before 1 s is looked at.
  await expect(rows(page).nth(1)).toContainText(/Run 2 continues run 1 at (?:1\.00|0\.9\d) s/)
  await expect(rows(page).nth(1)).toContainText("0.5 → 0.2")
  await expect(rows(page).nth(1)).toHaveAttribute("aria-level", "2")
  await expect(rows(page).nth(1)).toHaveAttribute("aria-selected", "true")

  // By keyboard back to the first run, which can be looked back at and asked about.
  await rows(page).nth(1).focus()
  await page.keyboard.press("ArrowUp")
  await expect(rows(page).nth(0)).toBeFocused()
  await page.keyboard.press("Enter")
  await expect(rows(page).nth(0)).toHaveAttribute("aria-selected", "true")
  await until(learner.robot("time"), time => time > 2)
  await page.getByRole("region", {name: "Room"}).getByRole("application").focus()
  await page.keyboard.press("w")
  await expect(page.getByTestId("why")).toContainText("Velocity 0.5")
  await page.getByTestId("why").getByRole("button", {name: "Close"}).click()
  await expect(page.getByTestId("why")).toHaveCount(0)

  // Its program comes back, in one step of undo.
  const offer = page.getByRole("button", {name: "Show its program"})
  await offer.click()
  await expect(learner.haskell()).toContainText("Velocity 0.5")
  await expect(offer).toHaveCount(0)
  await page.getByRole("button", {name: "Undo", exact: true}).click()
  await expect(learner.haskell()).toContainText("Velocity 0.2")
  await expect(offer).toBeVisible()

  // Both in one picture, and side by side.
  await page.getByLabel("Compare with").selectOption("Run 2")
  await expect(page.getByTestId("run-facts")).toContainText("Run 2 (dotted line)")
  await expect(page.getByTestId("run-facts").getByRole("row", {name: /^Length/})).toBeVisible()
  const {violations} = await new AxeBuilder({page}).include(".room-parts").analyze()
  expect(violations.flatMap(({id, nodes}) => nodes.map(node => `${id}: ${node.target.join(" ")}`))).toEqual(
    [],
  )
  await learner.keeps("runs")
  await page.getByRole("tab", {name: "Charts"}).click()
  await expect(page.getByTestId("compared-charts")).toHaveText("Run 1: solid line · Run 2: dotted line")
  await learner.keeps("runs-charts")
  await page.getByRole("tab", {name: "Runs"}).click()
  await page.emulateMedia({colorScheme: "dark"})
  await page.setViewportSize({width: 390, height: 844})
  await page
    .getByRole("tab", {name: "Room"})
    .or(page.getByRole("button", {name: "Room", exact: true}))
    .first()
    .click()
  await expect(rows(page).nth(0)).toBeVisible()
  await page.screenshot({path: screenshot("runs-phone")})
})

test("an earlier run is looked at while another one goes on", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("move")
  await learner.runs()
  await until(learner.robot("time"), time => time > 1)
  await learner.stops()
  await learner.runs()
  await until(learner.robot("time"), time => time > 0.5)
  await page.getByRole("tab", {name: "Runs"}).click()
  await rows(page).nth(0).click()
  await expect(rows(page).nth(0)).toHaveAttribute("aria-selected", "true")
  await expect(rows(page).nth(1)).toContainText("paused")
  // The program has not ended, and its run comes back where it was.
  await expect(learner.status()).toHaveText("Paused")
  await page.getByRole("button", {name: "Go on with run 2"}).click()
  await expect(rows(page).nth(1)).toHaveAttribute("aria-selected", "true")
  await expect(rows(page).nth(1)).not.toContainText("paused")
  await expect(learner.status()).toHaveText("Running")
  // Later than either run was when it was looked at.
  await until(learner.robot("time"), time => time > 3)
  await learner.stops()
})
