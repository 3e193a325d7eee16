/// A program is tested in many rooms: how many it passes, the smallest in which it fails, and what happens there.

import {AxeBuilder} from "@axe-core/playwright"
import {expect, type Locator, type Page} from "@playwright/test"
import {Learner, screenshot} from "./learner.ts"
import {test} from "./story.ts"

async function opensTest(page: Page): Promise<Locator> {
  await page.getByRole("button", {name: "More", exact: true}).click()
  await page.getByRole("button", {name: "Test in many rooms…"}).click()
  return page.getByRole("dialog", {name: "Test in many rooms"})
}

test("a program that falls is tested in rooms with holes, and the smallest such room opens and runs", async ({
  page,
}) => {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  const dialog = await opensTest(page)
  await dialog.getByLabel("It reaches the goal").uncheck()
  await dialog.getByLabel("Rooms").selectOption("with holes")
  await dialog.getByLabel("How many").selectOption("10")
  await dialog.getByRole("button", {name: "Test", exact: true}).click()
  await expect(dialog.getByRole("status")).toHaveText(/^It works in \d of 10 rooms\.$/)

  const table = dialog.getByRole("table", {name: "Rooms in which it fails, worst first"})
  await expect(table.getByRole("row").nth(1)).toContainText(/It fell after [\d.]+ s\./)
  const smallest = dialog.getByRole("region", {name: "The smallest room in which it fails"})
  await expect(smallest).toContainText("It fell after")
  await expect(smallest).toContainText(/only one is needed for that\.|Nothing in it can be left out\./)
  const {violations} = await new AxeBuilder({page}).include("dialog[open]").analyze()
  expect(violations.flatMap(({id, nodes}) => nodes.map(node => `${id}: ${node.target.join(" ")}`))).toEqual(
    [],
  )
  await page.screenshot({path: screenshot("many-rooms")})
  await page.setViewportSize({width: 390, height: 844})
  await page.screenshot({path: screenshot("many-rooms-phone")})
  await page.setViewportSize({width: 1440, height: 900})

  await smallest.getByRole("button", {name: "Open it and run"}).click()
  await expect(dialog).toBeHidden()
  await expect(page.getByRole("button", {name: /^Room to drive in: pits \d+$/})).toBeVisible()
  await expect(learner.runButton()).toHaveText("Stop")
  // It falls there as well, and then stands.
  await expect(learner.robot("wheels")).not.toBeEmpty()
  await learner.stops()

  // The way back is stored with the program: another program and a reload do not lose it.
  await page.getByRole("button", {name: "More", exact: true}).click()
  await page.getByText("New program").click()
  await expect(page.getByRole("button", {name: "Room to drive in: A room"})).toBeVisible()
  await page.reload()
  await expect(learner.haskell()).toContainText("simulate")
  await page.getByRole("button", {name: "My programs"}).click()
  await page.getByRole("dialog", {name: "My programs"}).locator(".opens").first().click()
  await expect(page.getByRole("button", {name: /^Room to drive in: pits \d+$/})).toBeVisible()
  await opensTest(page)
  await dialog.getByRole("button", {name: "Back to my room"}).click()
  await expect(page.getByRole("button", {name: "Room to drive in: A room"})).toBeVisible()
})

test("a test is stopped half-way, and a program that does not compile is not tested", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("accelerate")
  const dialog = await opensTest(page)
  await dialog.getByLabel("How many").selectOption("200")
  await dialog.getByRole("button", {name: "Test", exact: true}).click()
  await expect(dialog.getByRole("status")).toHaveText(/^\d+ of 200 rooms, \d+ passed$/)
  await dialog.getByRole("button", {name: "Stop the test"}).click()
  await expect(dialog.getByRole("status")).toBeEmpty()
  await dialog.getByLabel("It reaches the goal").uncheck()
  await dialog.getByLabel("It never falls into a hole").uncheck()
  await expect(dialog).toContainText("Choose something that has to hold.")
  await dialog.getByLabel("It never falls into a hole").check()
  await expect(dialog.getByLabel("It passes over this much of the floor: (percent)")).toBeDisabled()
  await page.keyboard.press("Escape")

  await learner.emptiesHaskell()
  await learner.types("main = simulate 5")
  await opensTest(page)
  await dialog.getByRole("button", {name: "Test", exact: true}).click()
  await expect(dialog.getByRole("status")).toContainText("The program cannot run yet:")
})
