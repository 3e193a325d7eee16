/// Tasks as states in the diagram: two states are built from an empty program by mouse, with counted actions, and by keyboard in the list form.

import {AxeBuilder} from "@axe-core/playwright"
import {expect} from "@playwright/test"
import {beginsInDiagram, diagram, drags, node} from "./diagram_page.ts"
import {test} from "./story.ts"

const built = `main :: IO ()
main = simulate (forever $ do
  driveUntilBump
  driveBack 1)`

test("by mouse: two states and the arrow back, and a third one in between", async ({page}) => {
  const learner = await beginsInDiagram(page)
  const offered = (name: string) =>
    diagram(page)
      .getByRole("list", {name: "Steps"})
      .getByRole("listitem")
      .filter({hasText: new RegExp(`^${name}$`)})
  const space = diagram(page).locator("[data-free-space]:visible")
  let actions = 0
  const acts = async (action: Promise<void>) => {
    actions++
    await action
  }
  await acts(drags(page, offered("driveUntilBump"), space))
  await expect(node(page, /^driveUntilBump: step/)).toBeVisible()
  await acts(drags(page, offered("driveBack"), node(page, /^driveUntilBump: step/)))
  await expect(node(page, /^driveBack 1: step/)).toBeVisible()
  await acts(drags(page, node(page, /^driveBack 1: step/), node(page, /^driveUntilBump: step/)))
  const choice = diagram(page).getByRole("group", {name: "driveBack and driveUntilBump"})
  await acts(choice.getByRole("button", {name: "Repeat for ever"}).click())
  await expect.poll(() => learner.haskellText()).toBe(built)
  await expect(node(page, /^driveBack 1: step; then back to driveUntilBump$/)).toBeVisible()
  console.log(`two states in the diagram: ${actions} actions`)
  await learner.keeps("diagram-two-states")

  // A state between the two, moved away and undone.
  await drags(page, offered("turn"), diagram(page).locator(".edge.then .grip"))
  await expect.poll(() => learner.haskellText()).toBe(built.replace("driveBack", "turn 90\n  driveBack"))
  await page.getByRole("button", {name: "Undo"}).click()
  await expect.poll(() => learner.haskellText()).toBe(built)

  await page.getByLabel("Speed", {exact: true}).selectOption("4")
  await learner.runsUntil(
    "speed",
    v => v > 0.15,
    v => v < -0.05,
    v => v > 0.15,
  )
  await learner.stops()
})

test("by keyboard: the list form adds, repeats, moves and takes apart", async ({page}) => {
  const learner = await beginsInDiagram(page)
  await diagram(page).getByRole("button", {name: "As a list"}).press("Enter")
  const step = diagram(page).getByRole("combobox", {name: "New step"})
  const actions = diagram(page).getByRole("group", {name: /^What can be done with/})
  const presses = (name: string) => actions.getByRole("button", {name, exact: true}).press("Enter")
  await step.selectOption("driveUntilBump")
  await presses("Add it at the end")
  await node(page, /^driveUntilBump: step/).press("Enter")
  await step.selectOption("driveBack")
  await presses("Add after")
  await expect(learner.haskell()).toContainText("driveBack 1")
  await node(page, /^one after the other$/).press("Enter")
  await presses("Repeat for ever")
  await expect.poll(() => learner.haskellText()).toBe(built)
  await node(page, /^driveBack 1: step; then back to driveUntilBump$/).press("Enter")
  await presses("Earlier")
  await expect
    .poll(() => learner.haskellText())
    .toBe(built.replace("driveUntilBump\n  driveBack 1", "driveBack 1\n  driveUntilBump"))
  const {violations} = await new AxeBuilder({page}).include(".region.diagram").analyze()
  expect(violations).toEqual([])
  await node(page, /^again and again$/).press("Enter")
  await presses("One after the other")
  await expect(learner.haskell()).not.toContainText("forever")
})
