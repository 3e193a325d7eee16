/// Whole programs from an empty page: they print exactly what the example says, and the robot does it.

import {readFileSync} from "node:fs"
import {expect, type Page, test} from "@playwright/test"
import type {Hands} from "./hands.ts"
import {Keys} from "./keys.ts"
import {Learner, until} from "./learner.ts"
import {Mouse} from "./mouse.ts"
import {drawSquare, mux, randomWalk} from "./recipes.ts"

// A whole program takes a learner a while, and a busy machine too.
test.setTimeout(900_000)

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
  await expect(learner.status()).toHaveText("Finished")
}

test("drawSquare by mouse", async ({page}) => {
  const learner = await builds(page, "drawSquare", drawSquare, new Mouse(page))
  await drivesASquare(page, learner)
})

/// Without a button pressed only the less important messages are there: the robot circles.
async function circles(page: Page, learner: Learner): Promise<void> {
  await page.getByLabel("Speed", {exact: true}).selectOption("4")
  await learner.runs()
  await until(learner.robot("speed"), v => v > 0.15)
  await until(learner.robot("heading"), degrees => Math.abs(degrees) > 20)
  await learner.stops()
}

/// The robot drives until it bumps, and turns away.
async function walksAtRandom(page: Page, learner: Learner): Promise<void> {
  await page.getByLabel("Speed", {exact: true}).selectOption("4")
  await learner.runs()
  await until(learner.robot("speed"), v => v > 0.3)
  await until(learner.robot("heading"), degrees => Math.abs(degrees) > 3)
  await learner.stops()
}

test("the multiplexer by mouse", async ({page}) => {
  const learner = await builds(page, "mux", mux, new Mouse(page))
  await circles(page, learner)
})

test("the random walker by mouse", async ({page}) => {
  const learner = await builds(page, "randomWalk", randomWalk, new Mouse(page))
  await walksAtRandom(page, learner)
})

test("drawSquare by keyboard alone", async ({page}) => {
  const learner = await builds(page, "drawSquare", drawSquare, new Keys(page))
  await drivesASquare(page, learner)
})

test("the multiplexer by keyboard alone", async ({page}) => {
  const learner = await builds(page, "mux", mux, new Keys(page))
  await circles(page, learner)
})

test("the random walker by keyboard alone", async ({page}) => {
  const learner = await builds(page, "randomWalk", randomWalk, new Keys(page))
  await walksAtRandom(page, learner)
})
