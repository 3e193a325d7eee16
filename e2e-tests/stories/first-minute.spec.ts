/// A newcomer's first minute: open, run, bump, hear, stop, reset, change a number, run again.

import {expect, test} from "@playwright/test"
import {Learner, until} from "./learner.ts"

test("the page opens with accelerateAndPlay ready to run", async ({page}) => {
  const learner = new Learner(page)
  await page.goto("/")
  await expect(learner.haskell()).toContainText("play :: Bumper -> Maybe Sound")
  await expect(page.getByRole("textbox", {name: "Name of the program"})).toHaveValue("accelerateAndPlay")
  await expect(learner.runButton()).toHaveText("Run")
  await learner.keeps("first-look")
})

test("Run drives the robot into the wall; the bumper lights up and the error sound plays", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  await learner.runs()
  await expect(learner.status()).toHaveText("Running")
  await until(learner.robot("speed"), v => v > 0.3)
  await expect(learner.robot("bumpers")).not.toBeEmpty()
  await expect(learner.console()).toContainText("plays ErrorSound")
  await learner.keeps("bumped")
  await learner.stops()
  await expect(learner.status()).toHaveText("Stopped")
})

test("forwardBackward turns round at the wall, by memory", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("forwardBackward")
  await learner.runs()
  await until(learner.robot("speed"), v => v > 0.3)
  await until(learner.robot("speed"), v => v < -0.3)
  await learner.stops()
})

test("every example opens as blocks with its Haskell and drives", async ({page}) => {
  const learner = new Learner(page)
  for (const example of ["move", "accelerate", "accelerateAndPlay", "forwardBackward"]) {
    await learner.opens(example)
    await expect(page.locator(".blocklyBlockCanvas .blocklyDraggable").first()).toBeVisible()
    await learner.runs()
    await until(learner.robot("speed"), v => v > 0.2)
    await learner.stops()
  }
})

test("the gallery shows what each example teaches and opens it", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("move")
  await page.getByRole("button", {name: "Examples"}).click()
  const dialog = page.getByRole("dialog")
  await expect(dialog).toBeVisible()
  await learner.keeps("gallery")
  await dialog.getByRole("button", {name: /^forwardBackward/}).click()
  await expect(learner.haskell()).toContainText("forwardBackward")
})

test("Stop works while the program still compiles, and Reset puts the robot back", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("move")
  await learner.runs()
  await until(learner.robot("speed"), v => v > 0.2)
  const start = await learner.robot("x").textContent()
  await page.getByRole("button", {name: "Reset"}).click()
  await expect(learner.runButton()).toHaveText("Run")
  await expect(learner.robot("speed")).toHaveText("0.000")
  expect(await learner.robot("x").textContent()).not.toBe(start)
  for (let i = 0; i < 5; i++) {
    await learner.runButton().click()
    await learner.runButton().click()
    await expect(learner.runButton()).toHaveText("Run")
  }
  await learner.runs()
  await expect(learner.status()).toHaveText("Running")
  await learner.stops()
})
