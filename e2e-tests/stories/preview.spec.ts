/// A program is changed after a run: where the robot would drive, in words and as a path, and when that is not shown.

import {AxeBuilder} from "@axe-core/playwright"
import {expect, type Locator, type Page} from "@playwright/test"
import {boxAtRest} from "./at_rest.ts"
import {Learner, screenshot} from "./learner.ts"
import {test} from "./story.ts"

const spoken = (page: Page) => page.getByTestId("preview-spoken")

/// Runs accelerateAndPlay until its robot stands at the wall, and stops it.
async function ranIntoTheWall(page: Page): Promise<Learner> {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  await page.getByLabel("Speed", {exact: true}).selectOption("4")
  await learner.runs()
  await expect(learner.robot("bumpers")).not.toBeEmpty()
  await learner.stops()
  return learner
}

test("a changed number shows where the robot would drive, until it is changed back", async ({page}) => {
  const learner = await ranIntoTheWall(page)
  await expect(spoken(page)).toBeEmpty()
  await learner.changesNumber("0.5", "-0.5")
  await expect(spoken(page)).toHaveText(/^With this change the robot would .* further left/)
  await expect(page.getByTestId("preview")).toHaveText(/further left/)
  const {violations} = await new AxeBuilder({page}).include(".canvas-host").analyze()
  expect(violations.flatMap(({id, nodes}) => nodes.map(node => `${id}: ${node.target.join(" ")}`))).toEqual(
    [],
  )
  await page.screenshot({path: screenshot("preview")})
  await page.setViewportSize({width: 390, height: 844})
  await page
    .getByRole("tab", {name: "Room"})
    .or(page.getByRole("button", {name: "Room", exact: true}))
    .first()
    .click()
  await page.screenshot({path: screenshot("preview-phone")})
  await page.setViewportSize({width: 1440, height: 900})

  // A text that does not compile leads nowhere; the program that ran needs no preview.
  await learner.entersHaskell()
  await page.keyboard.press("Control+End")
  // At once: a pause between two letters would begin another step of undo.
  await page.keyboard.insertText("oops =")
  await expect(spoken(page)).toBeEmpty()
  await page.keyboard.press("Control+z")
  await expect(spoken(page)).toHaveText(/further left/)
  await page.getByRole("button", {name: "Undo", exact: true}).click()
  await expect(learner.haskell()).toContainText("vl + 0.5")
  await expect(spoken(page)).toBeEmpty()
})

test("a preview ends with the program, and can be switched off for good", async ({page}) => {
  const learner = await ranIntoTheWall(page)
  await learner.changesNumber("0.5", "-0.5")
  await expect(spoken(page)).toHaveText(/further left/)

  await page.getByRole("button", {name: "Trail, picture and film"}).click()
  await page.getByLabel("Show where a change leads").uncheck()
  await page.keyboard.press("Escape")
  await expect(spoken(page)).toBeEmpty()
  await page.reload()
  await page.getByRole("button", {name: "Trail, picture and film"}).click()
  await expect(page.getByLabel("Show where a change leads")).not.toBeChecked()
  await page.getByLabel("Show where a change leads").check()
})

/// Drags the middle of an element so many pixels to the right, in small moves, and lets it go unless it is to be held.
async function drags(page: Page, dragged: Locator, right: number, lets = true): Promise<void> {
  const box = await boxAtRest(dragged)
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2)
  await page.mouse.down()
  await page.mouse.move(box.x + box.width / 2 + right, box.y + box.height / 2, {steps: 8})
  if (lets) await page.mouse.up()
}

/// Pixels for fifteen steps of 0.05.
const way = -58

test("a number is dragged in its block and in the text, the path follows, and each drag is one step back", async ({
  page,
}) => {
  const learner = await ranIntoTheWall(page)
  const note = page.getByTestId("preview")
  await drags(page, learner.number("0.5"), way, false)
  // The path is there before the button is released.
  await expect(learner.haskell()).toContainText("vl + (-0.25)")
  await expect(note).toHaveText(/further left/)
  await page.screenshot({path: screenshot("preview-drag")})
  await page.mouse.up()
  await expect(learner.haskell()).toContainText("vl + (-0.25)")
  await page.getByRole("button", {name: "Undo", exact: true}).click()
  await expect(learner.haskell()).toContainText("vl + 0.5")
  await expect(note).toBeHidden()

  await learner.findsInHaskell("0.5")
  await page.keyboard.press("ArrowLeft")
  await drags(page, page.getByTestId("number-grip"), way)
  await expect(learner.haskell()).toContainText("vl + (-0.25)")
  await expect(learner.number("-0.25")).toBeVisible()
  await expect(note).toHaveText(/further left/)
  await page.getByRole("button", {name: "Undo", exact: true}).click()
  await expect(learner.haskell()).toContainText("vl + 0.5")
})
