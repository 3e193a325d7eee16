/// The paper's examples, built from an empty program in the diagram alone: by mouse, and by keyboard in the list form. The definitions are those of the example,
/// character by character, and `simulate` runs the same functions in the same order.

import {readFileSync} from "node:fs"
import {expect, type Page} from "@playwright/test"
import {diagram} from "./diagram_page.ts"
import {builds, definitionsOf, paragraphs, recipes} from "./diagram_recipes.ts"
import {DiagramKeys, DiagramMouse} from "./diagram_wiring.ts"
import {Learner} from "./learner.ts"
import {test} from "./story.ts"

/// Shows the diagram and the room, and nothing else.
async function showsDiagramAlone(page: Page): Promise<Learner> {
  const learner = new Learner(page)
  await page.setViewportSize({width: 1440, height: 900})
  await learner.opens("move")
  await page.getByRole("button", {name: "Diagram", exact: true}).click()
  for (const name of ["Blocks", "Haskell"]) await page.getByRole("button", {name: `Hide ${name}`}).click()
  await expect(diagram(page).getByRole("button", {name: /^move: function/})).toBeVisible()
  return learner
}

async function savedHaskell(page: Page): Promise<string> {
  const saving = page.waitForEvent("download")
  await page.getByRole("button", {name: "More", exact: true}).click()
  await page.getByText("Save the Haskell").click()
  return readFileSync(await (await saving).path(), "utf8")
}

for (const [by, Hands] of [
  ["mouse", DiagramMouse],
  ["keyboard", DiagramKeys],
] as const)
  test(`each example of the paper is built in the diagram alone, by ${by}`, async ({page}) => {
    const learner = await showsDiagramAlone(page)
    if (by === "keyboard") await diagram(page).getByRole("button", {name: "As a list"}).press("Enter")
    const hands = new Hands(page)
    for (const recipe of recipes) {
      await builds(hands, recipe)
      console.log(`${recipe.example} in the diagram by ${by}: ${hands.actions} actions`)
      const built = await savedHaskell(page)
      expect([...paragraphs(built)].sort()).toEqual([...definitionsOf(recipe.example).values()].sort())
      if (recipe.example === "randomWalk" && by === "mouse") await learner.keeps("diagram-random-walk")
    }
  })
