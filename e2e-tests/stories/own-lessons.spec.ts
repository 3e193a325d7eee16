/// A lesson that is not one of Rosy's: opened from a file, followed, passed on as a link, and solved in another browser.

import {writeFile} from "node:fs/promises"
import {expect, type Locator, type Page} from "@playwright/test"
import {Learner} from "./learner.ts"
import {test} from "./story.ts"

const title = "To the ring"
const lesson = {
  lesson: 1,
  name: "to-the-ring",
  room: {size: [6, 4], start: {x: 1, y: 2}, goals: [{kind: "reach", x: 3, y: 2, r: 0.4, title: "ring"}]},
  start: "main = simulate (Velocity 0.1 0)\n",
  steps: [{id: "ring", kind: "make", seconds: 5, checks: [{kind: "at", id: "in-ring", time: 5, goal: 0}]}],
  texts: {
    en: {
      title,
      idea: "A faster robot comes further.",
      learned: "Metres a second, times seconds, are metres.",
      steps: {ring: {say: "Stand in the ring after 5 seconds."}},
      checks: {"in-ring": "In the ring at 5 s"},
      hints: {"in-ring": ["How far is the ring?"]},
    },
  },
}

const panel = (page: Page): Locator => page.getByRole("complementary", {name: "Lesson"})

async function solves(learner: Learner): Promise<void> {
  const {page} = learner
  await expect(panel(page).getByRole("heading", {name: title})).toBeVisible()
  await page.getByRole("combobox", {name: "Speed"}).selectOption("4")
  await learner.changesNumber("0.1", "0.4")
  await learner.runs()
  await expect(panel(page)).toContainText("Lesson finished!")
}

test("a lesson from a file is followed and kept over a reload, and its link opens it in a browser that has never seen it", async ({
  page,
  browser,
}, info) => {
  const path = info.outputPath("ring.json")
  await writeFile(path, JSON.stringify(lesson))
  const teacher = new Learner(page)
  await teacher.opens("move")
  await teacher.opensFile(path)
  await expect(panel(page).getByRole("heading", {name: title})).toBeVisible()
  await expect(teacher.haskell()).toContainText("Velocity 0.1 0")
  await page.getByRole("combobox", {name: "Speed"}).selectOption("4")
  await teacher.runs()
  await expect(panel(page).locator(".check")).toContainText("metres away from it at 5.0 s.")
  await page.reload()
  await solves(teacher)
  await teacher.keeps("own-lesson")
  const link = await panel(page).getByRole("link", {name: "Link to this lesson"}).getAttribute("href")

  const other = await browser.newContext()
  const pupil = new Learner(await other.newPage())
  await pupil.page.goto(link ?? "")
  await solves(pupil)
  await other.close()
})

test("a damaged lesson is refused with the place of the mistake, and the program stays", async ({
  page,
}, info) => {
  const path = info.outputPath("ring.json")
  const [step] = lesson.steps
  await writeFile(path, JSON.stringify({...lesson, steps: [{...step, seconds: undefined}]}))
  const teacher = new Learner(page)
  await teacher.opens("move")
  await teacher.opensFile(path)
  await expect(page.getByTestId("notice")).toContainText(
    "ring.json cannot be opened as a lesson: something is missing or wrong at steps[0].seconds.",
  )
  await expect(panel(page)).toHaveCount(0)
  await expect(teacher.haskell()).toContainText("move")
})
