/// A newcomer's first minute: open, run, bump, hear, stop, reset, change a number, run again. In the whole browser, as people
/// have it, where the other stories may be in its headless shell (`editor/test/chromium.ts`).

import {expect} from "@playwright/test"
import {wholeChromium} from "../../editor/test/chromium.ts"
import {Learner} from "./learner.ts"
import {test} from "./story.ts"

test.use({
  launchOptions: async ({launchOptions}, use) => use({...launchOptions, executablePath: wholeChromium}),
})

test("the page opens with a program that is ready to run and no Maybe in it, and asks how to begin", async ({
  page,
}) => {
  const learner = new Learner(page)
  await page.goto("/")
  await expect(learner.haskell()).toContainText("main = simulate accelerate")
  await expect(learner.haskell()).not.toContainText("Maybe")
  await expect(learner.runButton()).toHaveText("Run")
  const ways = page.getByRole("region", {name: "How do you want to begin?"})
  await expect(ways.getByRole("listitem")).toHaveCount(4)
  await learner.keeps("first-look")
  await ways.getByRole("button", {name: "Show me"}).click()
  await expect(page.getByTestId("demonstration")).toContainText("an empty program")
  await expect(learner.haskell()).toContainText("main = simulate _")
  await page.getByRole("button", {name: "Stop showing"}).click()
  await ways.getByRole("button", {name: "Lesson 1"}).click()
  await expect(page.getByRole("complementary", {name: "Lesson", exact: true})).toBeVisible()
  await expect(ways).toHaveCount(0)
})

test("Run drives the robot into the wall; the bumper lights up and the error sound plays", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  await learner.runsUntil("speed", v => v > 0.3)
  await expect(learner.status()).toHaveText("Running")
  await expect(learner.robot("bumpers")).not.toBeEmpty()
  await expect(learner.console()).toContainText("plays ErrorSound")
  await learner.keeps("bumped")
  await learner.stops()
  await expect(learner.status()).toHaveText("Stopped")
})

test("forwardBackward turns round at the wall, by memory", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("forwardBackward")
  await learner.runsUntil(
    "speed",
    v => v > 0.3,
    v => v < -0.3,
  )
  await learner.stops()
})

test("every example opens as blocks with its Haskell and drives", async ({page}) => {
  const learner = new Learner(page)
  for (const example of ["move", "accelerate", "accelerateAndPlay", "forwardBackward"]) {
    await learner.opens(example)
    await expect(page.locator(".blocklyBlockCanvas .blocklyDraggable").first()).toBeVisible()
    await learner.runsUntil("speed", v => v > 0.2)
    await learner.stops()
  }
})

test("a new program is calm, also with another empty socket: no problem, a plain room and the usual speed, until Run finds something missing", async ({
  page,
}) => {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  await page.getByRole("button", {name: "More", exact: true}).click()
  await page.getByText("New program").click()
  await expect(learner.haskell()).toContainText("simulate _")
  await page.getByRole("tab", {name: "Problems"}).click()
  await expect(page.getByTestId("problems")).toHaveText("No problems.")
  await expect(page.locator(".cm-lintRange, .cm-lint-marker")).toHaveCount(0)
  await learner.keeps("new-program")
  await learner.presses("run one more")
  await expect(learner.haskell()).toContainText("simulate (_, _)")
  await expect(page.getByTestId("problems")).toHaveText("No problems.")
  await expect(page.getByRole("tab", {name: "Problems", exact: true})).toBeVisible()
  await expect(page.locator(".cm-lintRange, .cm-lint-marker")).toHaveCount(0)
  await learner.runs()
  await expect(page.getByTestId("problems").locator("article")).not.toHaveCount(0)
  await expect(page.locator(".cm-lintRange")).not.toHaveCount(0)
})

test("after the first run the page proposes an experiment that turns the robot's way round", async ({
  page,
}) => {
  const learner = new Learner(page)
  await page.goto("/")
  await learner.runsUntil("speed", v => v > 0.3)
  await expect(page.getByText("Which way does the robot drive now?")).toBeVisible()
  await learner.stops()
  await learner.findsInHaskell("vl + 0.5")
  await page.keyboard.insertText("vl - 0.5")
  await learner.runsUntil("speed", v => v < -0.3)
  await learner.stops()
})

test("the gallery shows what each example teaches and opens it", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("move")
  await page.getByRole("button", {name: "Examples"}).click()
  const dialog = page.getByRole("dialog")
  await expect(dialog.getByRole("heading", {name: "First steps"})).toBeVisible()
  // The picture of the first example shows the path that the service has computed: pixels in the colour of the trail.
  const picture = dialog.locator(".card canvas").first()
  await expect.poll(() => picture.evaluate(reddish)).toBeGreaterThan(50)
  await learner.keeps("gallery")
  await dialog.getByRole("button", {name: /^forwardBackward/}).click()
  await expect(learner.haskell()).toContainText("forwardBackward")
})

test("Stop works while the program still compiles, and Reset puts the robot back", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("move")
  await learner.runsUntil("speed", v => v > 0.2)
  const driven = (await learner.robot("x").textContent()) ?? ""
  await page.getByRole("button", {name: "Reset"}).click()
  await expect(learner.runButton()).toHaveText("Run")
  await expect(learner.robot("speed")).toHaveText("0.000")
  await expect(learner.robot("x")).not.toHaveText(driven)
  for (let i = 0; i < 5; i++) {
    // The second press is made when the button says Stop: before that frame it would run the program once more.
    await learner.runs()
    await learner.stops()
  }
  await learner.runs()
  await expect(learner.status()).toHaveText("Running")
  await learner.stops()
})

/// In the page: pixels of a picture whose red is much stronger than their green.
function reddish(element: Element): number {
  const canvas = element as HTMLCanvasElement
  const {data} = canvas.getContext("2d")!.getImageData(0, 0, canvas.width, canvas.height)
  let count = 0
  for (let at = 0; at < data.length; at += 4) if ((data[at] ?? 0) - (data[at + 1] ?? 0) > 100) count += 1
  return count
}
