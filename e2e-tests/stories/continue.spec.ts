/// Runs that go on from a moment that is looked back at, unchanged and with a changed program.

import {AxeBuilder} from "@axe-core/playwright"
import {expect} from "@playwright/test"
import {Learner, until} from "./learner.ts"
import {test} from "./story.ts"

test("the run goes on from a moment before, also with a changed program", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("move")
  const slider = page.getByRole("slider", {name: "Look back in the run"})
  const goOn = page.getByRole("button", {name: "Continue from here"})
  await expect(goOn).toHaveCount(0)
  await learner.runs()
  await until(learner.robot("time"), time => time > 3)
  await slider.fill("1")
  await expect(learner.status()).toHaveText("Looking back")
  await learner.keeps("continue")
  const {violations} = await new AxeBuilder({page}).include(".timebar").include(".continue-bar").analyze()
  expect(violations).toEqual([])
  await goOn.click()

  // It is live, from that moment on.
  await expect(learner.status()).toHaveText("Running")
  await expect(goOn).toHaveCount(0)
  await until(learner.robot("time"), time => time > 1.5)
  await page.getByRole("button", {name: "Pause", exact: true}).click()
  await expect(page.getByTestId("notice")).toHaveCount(0)

  // A changed program runs to the moment from the start, and differs at once.
  await learner.changesNumber("0.5", "0.2")
  await expect(learner.haskell()).toContainText("Velocity 0.2")
  await slider.fill("1")
  await goOn.click()
  await expect(learner.status()).toHaveText("Running")
  await expect(page.getByTestId("notice")).toContainText("does something else from 0.00 s on")
  await until(learner.robot("time"), time => time > 1.2)
  await learner.stops()
})
