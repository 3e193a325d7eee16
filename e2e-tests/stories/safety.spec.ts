/// A learner switches the safety rules on in the simulator: the robot backs off from a wall, and the page says when.

import {expect} from "@playwright/test"
import {Learner, until} from "./learner.ts"
import {test} from "./story.ts"

test("the safety rules are one switch above the room, and the page says when they take over", async ({
  page,
}) => {
  const learner = new Learner(page)
  await learner.opens("move")
  const shield = page.getByTestId("safety-switch")
  await expect(shield).toHaveAttribute("aria-pressed", "false")
  await shield.click()
  await expect(shield).toHaveAttribute("aria-pressed", "true")
  await learner.runs()
  // 0.5 m/s ahead only: the robot never backs off by itself.
  await until(learner.robot("speed"), v => v < -0.05)
  await expect(page.getByTestId("safety-override")).toHaveText("Safety rules: backing off…")
  await expect(learner.console()).toContainText("The safety rules take over")
  await learner.keeps("safety-rules")
  // Without them the program has the wheels at once, and the robot pushes at the wall.
  await shield.click()
  await expect(page.getByTestId("safety-override")).toHaveText("")
  await expect(learner.robot("speed")).toHaveText("0.000")
  await learner.stops()
})
