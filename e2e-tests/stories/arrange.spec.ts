/// Blocks, Haskell and room stand where the learner wants them, and are there again after a reload.

import {expect, type Locator, type Page} from "@playwright/test"
import {boxAtRest} from "./at_rest.ts"
import {Learner} from "./learner.ts"
import {test} from "./story.ts"

const region = (page: Page, name: string) => page.getByRole("region", {name, exact: true})
const blocks = (page: Page) => region(page, "The program in blocks")
const haskell = (page: Page) => region(page, "The program in Haskell")
const room = (page: Page) => region(page, "Room")

/// Waits until one region begins where another ends.
async function stands(part: Locator, where: "right of" | "below", other: Locator) {
  await expect
    .poll(async () => {
      const [a, b] = [await part.boundingBox(), await other.boundingBox()]
      if (a === null || b === null) return false
      return where === "below" ? a.y >= b.y + b.height - 1 : a.x >= b.x + b.width - 1
    })
    .toBe(true)
}

test("the room is dragged below the program, made larger, and is there after a reload", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  await stands(room(page), "right of", haskell(page))
  const {x, y, width, height} = await boxAtRest(page.getByRole("main"))
  await page.getByRole("button", {name: "Move Room"}).hover()
  await page.mouse.down()
  await page.mouse.move(x + width / 2, y + height / 2, {steps: 5})
  await page.mouse.move(x + width / 2, y + height - 12, {steps: 5})
  await expect(page.locator(".landing")).toBeVisible()
  await learner.keeps("arrange-drag")
  await page.mouse.up()
  await stands(room(page), "below", blocks(page))
  await stands(room(page), "below", haskell(page))
  const before = await boxAtRest(room(page))
  const border = page.getByRole("separator", {name: "Border between Blocks, Haskell and Room"})
  await border.hover()
  await page.mouse.down()
  await page.mouse.move(x + width / 2, before.y - 120, {steps: 5})
  await page.mouse.up()
  await expect.poll(async () => Math.abs((await boxAtRest(room(page))).y - before.y + 120) < 3).toBe(true)
  await learner.runs()
  await learner.stops()
  await page.goto("/")
  await stands(room(page), "below", blocks(page))
  await expect.poll(async () => Math.abs((await boxAtRest(room(page))).y - before.y + 120) < 3).toBe(true)
})

test("all of it goes by keyboard, and there is a way back", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  await page.getByRole("button", {name: "Move Haskell"}).focus()
  await page.keyboard.press("ArrowDown")
  await stands(haskell(page), "below", blocks(page))
  await stands(haskell(page), "below", room(page))
  await expect(page.getByRole("button", {name: "Move Haskell"})).toBeFocused()
  await page.getByRole("separator", {name: "Border between Blocks, Room and Haskell"}).focus()
  const before = await boxAtRest(haskell(page))
  for (let i = 0; i < 5; i += 1) await page.keyboard.press("ArrowUp")
  await expect.poll(async () => (await boxAtRest(haskell(page))).height - before.height > 50).toBe(true)
  await page.getByRole("button", {name: "Hide Haskell"}).click()
  await expect(haskell(page)).toBeHidden()
  await page.getByRole("button", {name: "Arrange"}).focus()
  await page.keyboard.press("Enter")
  await page.getByRole("checkbox", {name: "Room"}).uncheck()
  await expect(room(page)).toBeHidden()
  await page.getByRole("checkbox", {name: "Haskell"}).check()
  await stands(haskell(page), "below", blocks(page))
  await learner.keeps("arrange-menu")
  await page.keyboard.press("Escape")
  await expect(page.getByRole("button", {name: "Arrange"})).toBeFocused()
  // A real robot is not run without its picture in sight.
  await learner.runs()
  await expect(room(page)).toBeVisible()
  await learner.stops()
  await page.getByRole("button", {name: "Arrange"}).click()
  await page.getByRole("button", {name: "As at first"}).click()
  await stands(haskell(page), "right of", blocks(page))
  await stands(room(page), "right of", haskell(page))
})

test.describe("on a tablet", () => {
  test.use({viewport: {width: 820, height: 1180}, hasTouch: true})
  test("one view of the program stands with the room, above it if that is where there is space", async ({
    page,
  }) => {
    const learner = new Learner(page)
    await page.goto("/?example=accelerateAndPlay")
    await expect(learner.definition("play")).toBeVisible()
    await expect(haskell(page)).toBeHidden()
    await page.getByRole("button", {name: "Arrange"}).tap()
    await page.getByRole("button", {name: "Blocks beside Haskell above Room"}).tap()
    await page.keyboard.press("Escape")
    await stands(room(page), "below", blocks(page))
    await page.getByRole("button", {name: "Haskell", exact: true}).tap()
    await expect(blocks(page)).toBeHidden()
    await stands(room(page), "below", haskell(page))
    await learner.keeps("arrange-tablet")
  })
})
