/// Seeing what the robot did: going with it, its trail, pictures and films of the room.

import {readFileSync} from "node:fs"
import {expect, type Locator} from "@playwright/test"
import {drawn} from "./at_rest.ts"
import {Learner, until} from "./learner.ts"
import {test} from "./story.ts"

test("the picture follows the robot by a button and by a key, until the learner asks for all of the room", async ({
  page,
}) => {
  const learner = new Learner(page)
  await learner.opens("move")
  const follow = page.getByRole("button", {name: "Follow the robot"})
  await expect(follow).toHaveAttribute("aria-pressed", "false")
  await learner.runs()
  await follow.click()
  await expect(follow).toHaveAttribute("aria-pressed", "true")
  await until(learner.robot("x"), x => x > 2)
  await learner.keeps("follow")
  await page.getByRole("application", {name: /room/}).focus()
  await page.keyboard.press("0")
  await expect(follow).toHaveAttribute("aria-pressed", "false")
  await page.keyboard.press("f")
  await expect(follow).toHaveAttribute("aria-pressed", "true")
  await learner.stops()
})

test("the trail tells the speed, and the browser remembers that it shall", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("forwardBackward")
  await page.getByRole("button", {name: "Trail, picture and film"}).click()
  await page.getByRole("button", {name: "Speed", exact: true}).click()
  await page.keyboard.press("Escape")
  await learner.opens("forwardBackward")
  await learner.runsUntil("speed", v => v < -0.2)
  await expect(page.getByText("slow")).toBeVisible()
  await learner.keeps("trail-by-speed")
  await learner.stops()
})

test("a picture, and films of the whole run in two clicks, are saved as files", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("move")
  const menu = page.getByRole("button", {name: "Trail, picture and film"})
  const saves = async (act: () => Promise<void>) => {
    const download = page.waitForEvent("download")
    await act()
    const file = await download
    return {name: file.suggestedFilename(), bytes: readFileSync(await file.path())}
  }
  await menu.click()
  await expect(page.getByRole("button", {name: "Start a film"})).toBeVisible()
  await page.keyboard.press("Escape")
  await learner.runsUntil("x", x => x > 2)
  await learner.stops()
  await menu.click()
  const picture = await saves(() => page.getByRole("button", {name: "Save a picture"}).click())
  expect(picture.name).toBe("move.png")
  expect(picture.bytes.subarray(1, 4).toString()).toBe("PNG")
  await menu.click()
  const film = await saves(() => page.getByRole("button", {name: "Film of the run (WebM)"}).click())
  expect(film.name).toBe("move.webm")
  // EBML, RFC 8794, section 11.2.1.
  expect(film.bytes.subarray(0, 4).toString("hex")).toBe("1a45dfa3")
  expect(film.bytes.length).toBeGreaterThan(2000)
  await menu.click()
  const gif = await saves(() => page.getByRole("button", {name: "Film of the run (GIF)"}).click())
  expect(gif.name).toBe("move.gif")
  expect(gif.bytes.subarray(0, 6).toString()).toBe("GIF89a")
  await expect(page.getByRole("button", {name: "Cancel"})).toBeHidden()
  await menu.click()
  await page.getByRole("button", {name: "Film of the run (WebM)"}).click()
  await expect(page.getByRole("progressbar", {name: "Making the film"})).toBeVisible()
  await learner.keeps("film")
  await page.getByRole("button", {name: "Cancel"}).click()
  await expect(page.getByRole("button", {name: "Cancel"})).toBeHidden()
})

test("a finished run is gone through step by step, and the block of the step is marked", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("drawSquare")
  await learner.runsUntil("heading", degrees => degrees > 60)
  await learner.stops()
  const before = page.getByRole("button", {name: "Step before: where a function began"})
  const next = page.getByRole("button", {name: "Next step: where a function begins"})
  await expect(next).toBeDisabled()
  const clock = page.getByTestId("clock")
  /// Presses a button until a definition is marked: on a busy machine several steps may be told of at once.
  const stepsTo = async (button: Locator, name: string) => {
    for (let count = 0; count < 6; count++) {
      const was = (await clock.textContent()) ?? ""
      await button.focus()
      await page.keyboard.press("Enter")
      await expect(clock).not.toHaveText(was)
      await drawn(page)
      if ((await page.locator(".blocklyBlockCanvas .rosyRunning").getByText(name, {exact: true}).count()) > 0)
        return
    }
    throw new Error(`expected to come to ${name}`)
  }
  await stepsTo(before, "runTurn")
  await stepsTo(before, "runMove")
  await stepsTo(next, "startTurn")
  await learner.keeps("steps")
  await before.click()
  await next.click()
})
