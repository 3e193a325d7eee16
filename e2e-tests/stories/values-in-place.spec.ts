/// Values in place: what functions took and gave, on blocks and in the text, while the program runs, paused, and when the learner looks back.

import {AxeBuilder} from "@axe-core/playwright"
import {expect, type Page} from "@playwright/test"
import {Learner} from "./learner.ts"
import {test} from "./story.ts"

const inText = (page: Page, line: string) => page.locator(".cm-line", {hasText: line}).locator(".hs-value")
const onBlock = (learner: Learner, name: string) => learner.definition(name).locator("> .rosyValue > text")

async function showsValues(page: Page, on: boolean): Promise<void> {
  await page.getByRole("button", {name: "Trail, picture and film"}).click()
  await page.getByRole("checkbox", {name: "Show values in the program"}).setChecked(on)
  await page.keyboard.press("Escape")
}

test("blocks and text show what functions took and gave, now and when the learner looks back", async ({
  page,
}) => {
  const learner = new Learner(page)
  await learner.opens("forwardBackward")
  await showsValues(page, true)
  // The browser remembers it.
  await learner.opens("forwardBackward")
  await expect(page.locator(".hs-value")).toHaveCount(0)
  await learner.runs()
  const bump = inText(page, "bump ::")

  // Once the wall is touched, the memory stays true, and both functions say so.
  await expect(inText(page, "type Hit")).toHaveText("True")
  await expect(bump).toHaveText(/^Bumper CenterBumper (Pressed|Released) → Memory True/)
  await expect(inText(page, "forwardBackward ::")).toHaveText(/^Memory True, /)
  await expect(onBlock(learner, "bump")).toHaveText(/→ Memory True/)
  await expect(onBlock(learner, "forwardBackward")).toHaveText(/^Memory True, Velocity/)
  await page.getByRole("button", {name: "Pause", exact: true}).click()
  // The guard that held is marked in both.
  const taken = page.locator(".cm-line:has(.hs-taken)")
  await expect(taken).toHaveText(["  | hit = Velocity (vl - 0.5) va"])
  await expect(page.locator(".rosyTaken")).toHaveCount(1)
  await learner.keeps("values-in-place")
  const {violations} = await new AxeBuilder({page})
    .include(".region.haskell")
    .include(".region.blocks")
    .analyze()
  expect(violations).toEqual([])

  // As it was then.
  await page.getByRole("slider", {name: "Look back in the run"}).fill("1")
  await expect(bump).toHaveText("not yet")
  await expect(onBlock(learner, "bump")).toHaveText("not yet")
  await expect(inText(page, "type Hit")).toHaveCount(0)
  await expect(inText(page, "forwardBackward ::")).toHaveText(
    /^Memory False, Velocity \S+ 0\.0 → Velocity \S+ 0\.0$/,
  )
  await expect(taken).toHaveText(["  | otherwise = Velocity (vl + 0.5) va"])
  await page.getByRole("button", {name: "Go on"}).click()
  await expect(bump).toHaveText(/→ Memory True/)

  // The values are no part of the program.
  await expect(page.locator(".cm-line", {hasText: "bump _"})).toHaveText("bump _ = Memory True")
  await showsValues(page, false)
  await expect(page.locator(".hs-value, .rosyValue")).toHaveCount(0)
  await expect(page.locator(".hs-taken, .rosyTaken")).toHaveCount(0)
  // And they are there at once when they are wanted again, also of a function that does not fire meanwhile.
  await showsValues(page, true)
  await expect(bump).toHaveText(/→ Memory True/)
  await learner.stops()
})
