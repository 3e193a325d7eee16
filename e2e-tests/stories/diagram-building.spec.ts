/// A program that backs off at a wall, wired in the diagram from an empty program: by mouse, and by keyboard in the list form.

import {AxeBuilder} from "@axe-core/playwright"
import {expect} from "@playwright/test"
import {boxAtRest} from "./at_rest.ts"
import {beginsInDiagram, diagram, drags, node} from "./diagram_page.ts"
import type {Learner} from "./learner.ts"
import {test} from "./story.ts"

const written = `backOff :: Bumper -> Maybe Velocity
backOff (Bumper _ Pressed) = Just (Velocity (-0.2) 0)
backOff (Bumper _ Released) = Nothing

go :: Velocity
go = Velocity 0.2 0

main :: IO ()
main = simulate (priority 1 backOff go)`

/// The robot drives into the wall, and away from it.
async function backsOff(learner: Learner): Promise<void> {
  await expect.poll(() => learner.haskellText()).toBe(written)
  await learner.page.getByLabel("Speed", {exact: true}).selectOption("4")
  await learner.runsUntil(
    "speed",
    v => v > 0.15,
    v => v < -0.05,
    v => v > 0.15,
  )
  await learner.stops()
}

test("by mouse: sensors are dragged onto an actuator, and what does not fit says why", async ({page}) => {
  const learner = await beginsInDiagram(page)
  const end = (name: string) =>
    diagram(page)
      .getByRole("listitem")
      .filter({hasText: new RegExp(`^${name}$`)})
  await drags(page, end("Bumper"), end("Velocity").last())
  await expect(diagram(page).getByRole("form", {name: "New function: Bumper → Velocity"})).toBeVisible()
  await page.mouse.up()
  const asked = diagram(page).getByLabel("Name of the function")
  await expect(asked).toBeFocused()
  await asked.fill("backOff")
  await asked.press("Enter")
  await expect(node(page, /^backOff: function/)).toBeVisible()
  await expect(learner.definition("backOff")).toBeVisible()
  await learner.keeps("diagram-built-function")

  // A command gives nothing, and what is said of that moves nothing.
  const sensors = diagram(page).getByRole("button", {name: "Sensors"})
  const before = await boxAtRest(sensors)
  await drags(page, node(page, /^Velocity: command/), node(page, /^backOff: function/))
  await expect(diagram(page)).toContainText("An actuator takes values and gives none.")
  await page.mouse.up()
  await expect(diagram(page).getByRole("alert")).toContainText("Start at a sensor or a function.")
  expect(await boxAtRest(sensors)).toEqual(before)

  await drags(page, end("tick"), node(page, /^Velocity: command/))
  await page.mouse.up()
  await asked.fill("go")
  await asked.press("Enter")
  await expect(node(page, /^go: function/)).toBeVisible()

  // A moved node stays where it is, also when the program is opened again.
  const place = () => node(page, /^go: function/).evaluate(group => group.style.transform)
  const first = await place()
  await diagram(page).getByRole("button", {name: "Move", exact: true}).click()
  const go = await boxAtRest(node(page, /^go: function/))
  await page.mouse.move(go.x + go.width / 2, go.y + go.height / 2)
  await page.mouse.down()
  await page.mouse.move(go.x + go.width / 2 + 40, go.y + go.height / 2 + 30, {steps: 4})
  await page.mouse.up()
  await expect.poll(place).not.toBe(first)
  await diagram(page).getByRole("button", {name: "Move", exact: true}).click()
  const moved = await place()

  // Both set the speed: the actuator shows it, and has the ways out.
  const actuator = node(page, /^Velocity: command;.*several functions are in conflict over it/)
  await expect(actuator).toBeVisible()
  await expect(actuator).toContainText("⚠ Velocity")
  await actuator.click()
  const conflict = diagram(page).getByRole("region", {name: "What to do about the conflict over Velocity"})
  const wayOut = conflict.getByRole("button", {name: "Let backOff go first, for 1 s"})
  await expect(wayOut).toBeVisible()
  await learner.keeps("diagram-conflict")
  await wayOut.click()
  await expect(conflict).toBeHidden()
  await expect(node(page, /^Velocity: command/)).not.toContainText("⚠")
  await backsOff(learner)
  await expect(page.getByText("saved", {exact: true})).toBeVisible()
  await page.reload()
  await expect.poll(place).toBe(moved)
})

test("by keyboard: the list form connects, renames, copies and undoes", async ({page}) => {
  const learner = await beginsInDiagram(page)
  await diagram(page).getByRole("button", {name: "As a list"}).press("Enter")
  const connects = async (from: string, to: string) => {
    await diagram(page).getByRole("combobox", {name: "From"}).selectOption(from)
    await diagram(page).getByRole("combobox", {name: "To", exact: true}).selectOption(to)
    await diagram(page).getByRole("button", {name: "Connect"}).press("Enter")
  }
  const asked = diagram(page).getByLabel("Name of the function")
  await connects("event Bumper", "command Velocity")
  await asked.fill("flee")
  await asked.press("Enter")
  const actions = diagram(page).getByRole("group", {name: /^What can be done with/})
  await actions.getByRole("button", {name: "Rename"}).press("Enter")
  await asked.fill("backOff")
  await asked.press("Enter")
  await expect(learner.haskell()).toContainText("simulate backOff")

  // A second sensor: both or either, and undone.
  await connects("event Cliff", "function backOff")
  await expect(diagram(page).getByRole("radio", {name: /^Both:/})).toBeFocused()
  await page.keyboard.press("ArrowDown")
  await page.keyboard.press("Enter")
  await expect(learner.haskell()).toContainText("backOff :: Either Bumper Cliff -> Maybe Velocity")
  await page.getByRole("button", {name: "Undo"}).press("Enter")
  await expect(learner.haskell()).toContainText("backOff :: Bumper -> Maybe Velocity")

  // A copy stands beside until it is run, and is deleted again.
  await actions.getByRole("button", {name: "Duplicate"}).press("Enter")
  await asked.press("Enter")
  await diagram(page).getByRole("button", {name: "backOff2: Run it in the program"}).press("Enter")
  await expect(learner.haskell()).toContainText("simulate (backOff, backOff2)")
  const {violations} = await new AxeBuilder({page}).include(".region.diagram").analyze()
  expect(violations).toEqual([])
  await learner.keeps("diagram-built-list")
  await actions.getByRole("button", {name: "Delete"}).press("Enter")
  await expect(learner.haskell()).not.toContainText("backOff2")

  await connects("sample ()", "command Velocity")
  await asked.fill("go")
  await asked.press("Enter")
  const conflict = diagram(page).getByRole("region", {name: "What to do about the conflict over Velocity"})
  await node(page, /^Velocity: command;.*several functions are in conflict over it/).press("Enter")
  const wayOut = conflict.getByRole("button", {name: "Let backOff go first, for 1 s"})
  await expect(wayOut).toBeFocused()
  await page.keyboard.press("Escape")
  await expect(node(page, /^Velocity: command/)).toBeFocused()
  await page.keyboard.press("Enter")
  await expect(wayOut).toBeFocused()
  await page.keyboard.press("Enter")
  await backsOff(learner)
})
