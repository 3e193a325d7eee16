/// Whole programs from an empty page: they print exactly what the example says, and the robot does it.

import {readFileSync} from "node:fs"
import {expect, type Page} from "@playwright/test"
import type {Hands} from "./hands.ts"
import {Keys} from "./keys.ts"
import {Learner, until} from "./learner.ts"
import {Mouse} from "./mouse.ts"
import {drawSquare, mux, randomWalk} from "./recipes.ts"
import {test} from "./story.ts"

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
  const turned = until(learner.robot("heading"), degrees => Math.abs(degrees) > 80)
  await learner.runsUntil("speed", v => v > 0.1)
  await turned
  await expect(learner.status()).toHaveText("Finished")
}

/// Without a button pressed only the less important messages are there: the robot circles.
async function circles(page: Page, learner: Learner): Promise<void> {
  await page.getByLabel("Speed", {exact: true}).selectOption("4")
  const turned = until(learner.robot("heading"), degrees => Math.abs(degrees) > 20)
  await learner.runsUntil("speed", v => v > 0.15)
  await turned
  await learner.stops()
}

/// The robot drives until it bumps, and turns away.
async function walksAtRandom(page: Page, learner: Learner): Promise<void> {
  await page.getByLabel("Speed", {exact: true}).selectOption("4")
  const turned = until(learner.robot("heading"), degrees => Math.abs(degrees) > 3)
  await learner.runsUntil("speed", v => v > 0.3)
  await turned
  await learner.stops()
}

interface Program {
  readonly title: string
  readonly example: string
  readonly recipe: (hands: Hands) => Promise<void>
  readonly behaves: (page: Page, learner: Learner) => Promise<void>
}

const drawSquareProgram: Program = {
  title: "drawSquare",
  example: "drawSquare",
  recipe: drawSquare,
  behaves: drivesASquare,
}
const multiplexer: Program = {title: "the multiplexer", example: "mux", recipe: mux, behaves: circles}
const randomWalker: Program = {
  title: "the random walker",
  example: "randomWalk",
  recipe: randomWalk,
  behaves: walksAtRandom,
}

const mouse = {with: "by mouse", of: (page: Page): Hands => new Mouse(page)} as const
const keys = {with: "by keyboard alone", of: (page: Page): Hands => new Keys(page)} as const

/// Each program with one kind of hands; drawSquare needs everything that a mouse does in any of them. Tasks are built by
/// keyboard in first-hour.spec.ts.
const built = [
  [drawSquareProgram, mouse],
  [multiplexer, keys],
  [randomWalker, keys],
] as const

for (const [{title, example, recipe, behaves}, by] of built) {
  test(`${title} ${by.with}`, async ({page}) => {
    await behaves(page, await builds(page, example, recipe, by.of(page)))
  })
}
