/// The diagram as a person uses it: an empty program in it, its nodes, and a drag from one thing to another.

import {expect, type Locator, type Page} from "@playwright/test"
import {atRest} from "./at_rest.ts"
import {Learner} from "./learner.ts"

export const diagram = (page: Page) => page.getByRole("region", {name: "Diagram", exact: true})

export const node = (page: Page, name: RegExp) => diagram(page).getByRole("button", {name})

/// An empty program, with its diagram in sight.
export async function beginsInDiagram(page: Page): Promise<Learner> {
  const learner = new Learner(page)
  await page.setViewportSize({width: 1366, height: 768})
  await learner.opens("move")
  await page.getByRole("button", {name: "More", exact: true}).click()
  await page.getByText("New program").click()
  await expect(learner.haskell()).toContainText("simulate _")
  await page.getByRole("button", {name: "Diagram", exact: true}).click()
  await expect(diagram(page)).toContainText("The program simulates nothing yet.")
  return learner
}

/// From the middle of one to the middle of the other.
export async function drags(page: Page, from: Locator, to: Locator): Promise<void> {
  // Both at once: a palette that folds moves the one while the other rests already.
  const ends = await atRest(
    page,
    () => Promise.all([from.boundingBox(), to.boundingBox()]),
    boxes => boxes.every(box => box !== null && box.width > 0 && box.height > 0),
  )
  const [start, end] = ends.map(box => ({x: box!.x + box!.width / 2, y: box!.y + box!.height / 2}))
  await page.mouse.move(start!.x, start!.y)
  await page.mouse.down()
  await page.mouse.move(end!.x, end!.y, {steps: 5})
  await page.mouse.up()
}
