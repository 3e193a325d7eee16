/// Several robots in one room: put there by mouse or keyboard, dragged to their places, and met by the first one.

import {expect} from "@playwright/test"
import {Floor} from "./floor.ts"
import {Learner} from "./learner.ts"
import {test} from "./story.ts"

test("a learner puts two more robots into the room, drags one into the way, and they bump into each other", async ({
  page,
}) => {
  const learner = new Learner(page)
  await learner.opens("move")
  // By keyboard.
  await page.getByTestId("companions").focus()
  await page.keyboard.press("Enter")
  const dialog = page.getByRole("dialog", {name: "More robots"})
  const more = dialog.getByRole("button", {name: "One more robot"})
  await more.focus()
  await page.keyboard.press("Enter")
  await page.keyboard.press("Enter")
  await expect(dialog.getByRole("combobox", {name: /^Program of robot/})).toHaveCount(2)
  const place = dialog.getByRole("group", {name: "Place of robot 2"})
  const [x, y] = [
    Number(await place.getByLabel("x").inputValue()),
    Number(await place.getByLabel("y").inputValue()),
  ]
  await page.keyboard.press("Escape")
  // By mouse, to where the first robot drives.
  const floor = new Floor(page, [5, 4])
  await floor.drags([x, y], [3, 2])
  await page.getByTestId("companions").click()
  await expect(place.getByLabel("x")).toHaveValue(/^(2\.9|3)/)
  await dialog.getByRole("button", {name: "Take robot 3 away"}).click()
  await page.keyboard.press("Escape")
  await learner.runs()
  await expect(page.getByTestId("console")).toContainText("Bumper")
  await learner.stops()
})
