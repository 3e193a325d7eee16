/// What goes wrong ends as a sentence on the block that causes it; and nothing that was built is lost.

import {writeFileSync} from "node:fs"
import {expect} from "@playwright/test"
import {Learner} from "./learner.ts"
import {test} from "./story.ts"

test("changing a number block changes the Haskell at once, and the next run", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("move")
  await learner.changesNumber("0.5", "0.2")
  await expect(learner.haskell()).toContainText("Velocity 0.2 0")
  await learner.runsUntil(
    "speed",
    v => v > 0.15,
    v => Math.abs(v - 0.2) < 0.02,
  )
  await learner.stops()
})

test("a mistake is explained and mended in the language of the page", async ({page}) => {
  const learner = new Learner(page)
  await page.goto("/?example=move&lang=de")
  await expect(learner.haskell()).toContainText("simulate")
  await learner.entersHaskell()
  await page.keyboard.press("Control+End")
  await page.keyboard.type("\nother = mov")
  await page.getByRole("tab", {name: /Probleme/}).click()
  const problems = page.getByTestId("problems")
  await expect(problems).toContainText("Es gibt nichts namens mov.")
  await problems.getByRole("button", {name: "move schreiben"}).click()
  await expect(learner.haskell()).toContainText("other = move")
  await expect(problems).not.toContainText("mov.")
})

test("an unfilled socket ends the run that needs it, as a sentence on its block", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("move")
  await learner.deletesNumber("0.5")
  await expect(learner.haskell()).toContainText("Velocity _ 0")
  await learner.runs()
  await expect(learner.status()).toHaveText("Stopped at an empty place")
  await learner.seesProblem(/came to the empty place in move \(line 2\)/)
  await expect(learner.wrongBlocks()).toHaveCount(1)
  await learner.keeps("unfilled-socket")
})

test("a program with an empty place drives until it needs it, and says what it has there", async ({
  page,
}, info) => {
  const learner = new Learner(page)
  await learner.opens("move")
  const file = info.outputPath("unfinished.hs")
  writeFileSync(
    file,
    `main = simulate (Velocity 0.5 0, back)

back :: Bumper -> Seconds -> Velocity
back _ t = Velocity _speed 0
`,
  )
  await learner.opensFile(file)
  await expect(learner.haskell()).toContainText("_speed")
  await learner.runsUntil("speed", v => v > 0.3)
  await expect(learner.status()).toHaveText("Stopped at an empty place")
  await learner.seesProblem(/came to the empty place _speed in back \(line 4\)/)
  await learner.seesProblem(/needs a Double; you have t :: Seconds/)
  await expect(learner.wrongBlocks()).toHaveCount(1)
  await expect(page.locator(".cm-lintRange-error")).toHaveText("_speed")
  await expect(learner.robot("speed")).toHaveText("0.000")
  await learner.keeps("empty-place")
})

test("a case that is missing at run time ends on its function's block, and the robot stands still", async ({
  page,
}) => {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  await learner.presses("remove the last case")
  await learner.chooses("pressed", "released")
  await expect(learner.haskell()).toContainText("play (Bumper _ Released) = Just")
  await expect(learner.haskell()).not.toContainText("Pressed")
  await learner.runs()
  await expect(learner.status()).toHaveText("Ended by a problem")
  await learner.seesProblem(/play/)
  await expect(learner.wrongBlocks()).toHaveCount(1)
  await expect(learner.robot("speed")).toHaveText("0.000")
  await learner.keeps("missing-case")
})

test("a type error in a Haskell file ends on the block that causes it", async ({page}, info) => {
  const learner = new Learner(page)
  await learner.opens("accelerate")
  const file = info.outputPath("mixed-up.hs")
  writeFileSync(file, "move :: Velocity\nmove = Velocity 0.5 True\n\nmain = simulate move\n")
  await learner.opensFile(file)
  await expect(learner.haskell()).toContainText("True")
  await learner.runs()
  await expect(learner.status()).toHaveText("Not started")
  await learner.seesProblem(/True|Bool|number/)
  await expect(learner.wrongBlocks().first()).toBeVisible()
  await learner.keeps("type-error")
})

test("a file from the future and a truncated file are refused with a sentence, and the program stays", async ({
  page,
}, info) => {
  const learner = new Learner(page)
  await learner.opens("move")
  for (const [name, text] of [
    [
      "future.rosy",
      JSON.stringify({
        rosy: 99,
        name: "x",
        haskell: "",
        layout: {declarations: [], loose: []},
        world: "room",
        settings: {},
      }),
    ],
    ["half.rosy", '{"rosy": 1, "name": "ha'],
  ] as const) {
    const file = info.outputPath(name)
    writeFileSync(file, text)
    await learner.opensFile(file)
    await expect(page.getByTestId("notice")).toContainText(name)
    await expect(learner.haskell()).toContainText("move = Velocity 0.5 0")
  }
})
