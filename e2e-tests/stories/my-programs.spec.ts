/// The learner's own programs: their place, and one program in two tabs.

import {expect, type Page} from "@playwright/test"
import {boxAtRest} from "./at_rest.ts"
import {Learner} from "./learner.ts"
import {test} from "./story.ts"

const dialogOf = (page: Page) => page.getByRole("dialog", {name: "My programs"})

test("My programs opens, renames and duplicates a program, and a deleted one comes back", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("move")
  await learner.changesNumber("0.5", "0.25")
  await learner.opens("accelerateAndPlay")
  await learner.changesNumber("0.5", "0.75")
  await expect(learner.haskell()).toContainText("vl + 0.75")
  await expect(page.getByTestId("saved")).toHaveText("saved")
  const dialog = dialogOf(page)
  const cards = dialog.locator(".program-card")
  await page.getByRole("button", {name: "My programs"}).click()
  await expect(cards).toHaveCount(2)
  await expect(cards.first()).toContainText("open now")
  await expect(cards.locator(".block-picture path").first()).toBeVisible()

  await dialog.getByRole("button", {name: "Rename move"}).click()
  await expect(dialog.getByRole("textbox")).toBeFocused()
  await page.keyboard.insertText("slow")
  await page.keyboard.press("Enter")
  await dialog.getByRole("button", {name: "Duplicate slow"}).click()
  await dialog.getByRole("button", {name: "Delete slow", exact: true}).click()
  await expect(cards).toHaveCount(2)
  await dialog.getByRole("button", {name: "Undo"}).click()
  await expect(cards).toHaveCount(3)
  // The open program goes, too, and a new one takes its place.
  await dialog.getByRole("button", {name: "Delete accelerateAndPlay"}).click()
  await expect(cards).toHaveCount(2)
  await learner.keeps("my-programs")
  await cards.filter({hasText: "slow 2"}).locator(".opens").click()
  await expect(learner.haskell()).toContainText("Velocity 0.25")
  await expect(page.getByRole("textbox", {name: "Name of the program"})).toHaveValue("slow 2")
  await page.reload()
  await expect(learner.haskell()).toContainText("Velocity 0.25")
  await page.getByRole("button", {name: "My programs"}).click()
  await page.getByText("Deleted programs").click()
  await dialog.getByRole("button", {name: "Restore accelerateAndPlay"}).click()
  await cards.filter({hasText: "accelerateAndPlay"}).locator(".opens").click()
  await expect(learner.haskell()).toContainText("vl + 0.75")
})

test("a function goes by the backpack into another program with its comment and what it needs", async ({
  page,
}) => {
  const learner = new Learner(page)
  await learner.opens("move")
  await learner.emptiesHaskell()
  await learner.types(
    "speed :: Double\nspeed = 0.3\n\n-- Straight on.\ndrive :: Velocity\ndrive = Velocity speed 0\n\nmain = simulate drive",
  )
  await expect(learner.definition("drive")).toBeVisible()
  await learner.definition("drive").click({button: "right", position: {x: 8, y: 8}})
  await page.getByRole("menuitem", {name: "Put drive into the backpack"}).click()
  await expect(page.getByTestId("notice")).toContainText("It needs this, which came along: speed")
  const backpack = page.getByRole("button", {name: "Backpack"})
  const text = await learner.wholeHaskell()
  const [from, to] = [await boxAtRest(learner.definition("speed")), await boxAtRest(backpack)]
  await page.mouse.move(from.x + 8, from.y + 8)
  await page.mouse.down()
  await page.mouse.move(to.x + to.width / 2, to.y + to.height / 2, {steps: 8})
  await expect(backpack).toHaveClass(/open/)
  await page.mouse.up()
  await expect(page.getByTestId("notice")).toContainText("speed is in the backpack.")
  expect(await learner.wholeHaskell()).toBe(text)
  await expect(learner.definition("speed")).toBeVisible()
  await learner.opens("accelerate")
  const before = await learner.wholeHaskell()
  await backpack.click()
  const dialog = page.getByRole("dialog", {name: "Backpack"})
  await expect(dialog).toContainText("drivewith speed")
  await learner.keeps("backpack")
  await dialog.getByRole("button", {name: "Take drive out into this program"}).click()
  await expect(dialog).toBeHidden()
  await expect(page.getByTestId("notice")).toContainText("New in your program: speed, drive.")
  await expect(learner.definition("drive")).toBeVisible()
  await learner.keeps("backpack-taken")
  const taken =
    "speed :: Double\nspeed = 0.3\n\n-- Straight on.\ndrive :: Velocity\ndrive = Velocity speed 0\n\n"
  expect(await learner.wholeHaskell()).toBe(before.replace("main ::", `${taken}main ::`))
  await page.keyboard.press("Control+z")
  expect(await learner.wholeHaskell()).toBe(before)
})

test("a program that is open in two tabs stays one program, until both change it at once", async ({
  page,
  context,
}) => {
  await page.addInitScript(() =>
    window.addEventListener("storage", event => {
      if (document.documentElement.classList.contains("deaf")) event.stopImmediatePropagation()
    }),
  )
  const here = new Learner(page)
  await here.opens("accelerateAndPlay")
  await here.changesNumber("0.5", "0.25")
  await expect(here.haskell()).toContainText("vl + 0.25")
  await expect(page.getByTestId("saved")).toHaveText("saved")
  const there = new Learner(await context.newPage())
  await there.page.goto("/")
  await expect(there.haskell()).toContainText("vl + 0.25")
  await there.changesNumber("0.25", "0.75")
  await expect(here.haskell()).toContainText("vl + 0.75")
  await expect(here.number("0.75")).toBeVisible()
  await page.getByRole("button", {name: "Undo", exact: true}).click()
  await expect(there.haskell()).toContainText("vl + 0.25")
  await page.getByRole("button", {name: "My programs"}).click()
  await expect(dialogOf(page).locator(".program-card")).toHaveCount(1)
  await page.keyboard.press("Escape")

  // This tab does not hear of the other's change before it has one of its own.
  await page.evaluate(() => document.documentElement.classList.add("deaf"))
  await there.changesNumber("0.25", "0.75")
  await expect.poll(() => page.evaluate(() => Object.values(localStorage).join())).toContain("vl + 0.75")
  await here.changesNumber("0.25", "0.125")
  await expect(page.getByTestId("notice")).toContainText("Now there are two")
  await expect(page.getByRole("textbox", {name: "Name of the program"})).toHaveValue("accelerateAndPlay 2")
  await expect(there.haskell()).toContainText("vl + 0.75")
  await page.getByRole("button", {name: "My programs"}).click()
  await expect(dialogOf(page).locator(".program-card")).toHaveCount(2)
})

test("a browser without storage shows a working page that says so", async ({page}) => {
  await page.addInitScript(() => {
    for (const name of ["localStorage", "sessionStorage"])
      Object.defineProperty(window, name, {
        get() {
          throw new DOMException("denied", "SecurityError")
        },
      })
  })
  const learner = new Learner(page)
  await learner.opens("move")
  await expect(page.getByTestId("notice")).toContainText("keeps nothing")
  await learner.changesNumber("0.5", "0.25")
  await expect(learner.haskell()).toContainText("Velocity 0.25")
})

test("a browser whose storage is full shows a working page that says so", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("move")
  await page.evaluate(() => {
    const fills = (letters: number) => {
      try {
        localStorage.setItem(`other ${letters} ${localStorage.length}`, "x".repeat(letters))
        return true
      } catch {
        return false
      }
    }
    for (const letters of [1_000_000, 10_000, 100]) while (fills(letters));
  })
  await learner.changesNumber("0.5", "0.25")
  await expect(page.getByTestId("notice")).toContainText("no room to keep your program")
  await expect(page.getByTestId("saved")).toHaveText("not saved")
  await page.reload()
  await expect(learner.runButton()).toHaveText("Run")
  await expect(learner.haskell()).toContainText("simulate")
})
