/// Whole programs from an empty page: they print exactly what the example says, and the robot does it.

import {readFileSync} from "node:fs"
import {expect, type Page, test} from "@playwright/test"
import type {Hands} from "./hands.ts"
import {Learner, until} from "./learner.ts"
import {Mouse} from "./mouse.ts"
import {drawSquare, mux, randomWalk} from "./recipes.ts"

// A whole program takes a learner a while, and a busy machine too.
test.setTimeout(180_000)

async function builds(
  page: Page,
  example: string,
  recipe: (hands: Hands) => Promise<void>,
  hands: Hands,
): Promise<Learner> {
  const learner = new Learner(page)
  page.on("pageerror", error => {
    throw error
  })
  await learner.opens("move")
  await recipe(hands)
  await learner.keeps(`built-${example}`)
  const saving = page.waitForEvent("download")
  await page.getByRole("button", {name: "More", exact: true}).click()
  await page.getByText("Save the Haskell").click()
  const text = readFileSync(await (await saving).path(), "utf8")
  expect(text).toBe(readFileSync(new URL(`../../examples/${example}/Main.hs`, import.meta.url), "utf8"))
  return learner
}

async function drivesASquare(page: Page, learner: Learner): Promise<void> {
  await page.getByLabel("Speed", {exact: true}).selectOption("8")
  await learner.runs()
  await until(learner.robot("speed"), v => v > 0.1)
  await until(learner.robot("heading"), degrees => Math.abs(degrees) > 80)
  await expect(learner.status()).toHaveText("Finished", {timeout: 60_000})
}

test("drawSquare by mouse", async ({page}) => {
  const learner = await builds(page, "drawSquare", drawSquare, new Mouse(page))
  await drivesASquare(page, learner)
})

/// The robot circles by itself; a button is more important for a second.
async function circlesUntilAButtonIsPressed(page: Page, learner: Learner): Promise<void> {
  await learner.runs()
  await until(learner.robot("speed"), v => v > 0.15)
  // Slowly enough to see the second pass.
  await page.getByLabel("Speed", {exact: true}).selectOption("0.25")
  await page.getByRole("button", {name: "Press button 0 of the robot"}).click()
  await until(learner.robot("speed"), v => Math.abs(v) < 0.05)
  await page.getByLabel("Speed", {exact: true}).selectOption("4")
  await until(learner.robot("speed"), v => v > 0.15)
  await learner.stops()
}

/// The robot drives until it bumps, shows it, and turns away.
async function walksAtRandom(page: Page, learner: Learner): Promise<void> {
  await page.getByLabel("Speed", {exact: true}).selectOption("4")
  await learner.runs()
  await until(learner.robot("speed"), v => v > 0.3)
  await expect(learner.robot("bumpers")).not.toBeEmpty()
  await until(learner.robot("speed"), v => Math.abs(v) < 0.1)
  await until(learner.robot("speed"), v => v > 0.3)
  await learner.stops()
}

test("the multiplexer by mouse", async ({page}) => {
  const learner = await builds(page, "mux", mux, new Mouse(page))
  await circlesUntilAButtonIsPressed(page, learner)
})

test("the random walker by mouse", async ({page}) => {
  const learner = await builds(page, "randomWalk", randomWalk, new Mouse(page))
  await walksAtRandom(page, learner)
})
