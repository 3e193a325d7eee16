/// A teacher writes a lesson from nothing in the page, tries it, learns that the solution does not pass, mends it, keeps the lesson over a reload and saves it;
/// a pupil solves it in another browser.

import {expect, type Locator, type Page} from "@playwright/test"
import {Learner} from "./learner.ts"
import {test} from "./story.ts"

const editor = (page: Page): Locator => page.getByRole("complementary", {name: "Lesson editor"})
const lesson = (page: Page): Locator => page.getByRole("complementary", {name: "Lesson", exact: true})

/// The step that is shown is run, four times as fast.
async function triesStep(learner: Learner, answer: string): Promise<void> {
  const {page} = learner
  await lesson(page).getByRole("button", {name: answer}).click()
  await lesson(page).getByRole("button", {name: "Next step"}).click()
  await page.getByRole("combobox", {name: "Speed"}).selectOption("4")
  await learner.runs()
}

test("a lesson is written from nothing, tried, kept over a reload, saved, and solved in another browser", async ({
  page,
  browser,
}, info) => {
  const teacher = new Learner(page)
  const panel = editor(page)
  await teacher.opens("move")
  await teacher.emptiesHaskell()
  await page.keyboard.insertText("main = simulate (Velocity 0.1 0)\n")
  await expect(teacher.number("0.1")).toBeVisible()
  await page.getByRole("button", {name: "Lessons"}).click()
  await page.getByRole("dialog").getByRole("button", {name: "Write a lesson"}).click()

  await expect(panel).toContainText("The lesson has no title (English).")
  await panel.getByLabel("Title").fill("Farther")
  await panel.getByLabel("Story: what it is about").fill("A faster robot comes farther.")
  await panel.getByRole("button", {name: "Add a step: Guess"}).click()
  const first = panel.getByRole("group", {name: "Step 1"})
  await first.getByLabel("What to do").fill("How far does it drive in 5 seconds?")
  await first.getByLabel("Answer 1", {exact: true}).fill("Half a metre")
  await first.getByLabel("Answer 2", {exact: true}).fill("Five metres")
  await expect(panel).toContainText("Step 1: choose which answer is right.")
  await first.getByLabel("Answer 1 is right").check()
  await panel.getByRole("button", {name: "Add a step: Make"}).click()
  const second = panel.getByRole("group", {name: "Step 2"})
  await second.getByLabel("What to do").fill("Drive more than a metre in 5 seconds.")
  await second.getByLabel("The run is watched for").fill("5")
  await second.getByLabel("Add a check:").selectOption("It has driven so far")
  await second.getByLabel("What pupils read about it").fill("It drives a metre")
  // The program of the page is a wrong attempt, and in its place as a solution it is reported.
  await second.getByRole("button", {name: "Check 1: Take the program on the page as a wrong attempt"}).click()
  await panel.getByRole("button", {name: "Solution: Take the program on the page"}).click()
  await second.getByLabel("Hint: a question").fill("How long is a metre at 0.1 metres a second?")
  await expect(panel).not.toContainText("Still missing")
  await teacher.keeps("lesson-editor")

  await panel.getByRole("button", {name: "Try it"}).click()
  await expect(lesson(page).getByRole("heading", {name: "Farther"})).toBeVisible()
  await triesStep(teacher, "Half a metre")
  await expect(lesson(page).getByRole("region", {name: "Solution and wrong attempts"})).toContainText(
    /The solution misses check 1 of step 2\. It drove 0\.\d\d metres\./,
  )
  await expect(lesson(page).locator(".check")).toContainText(/It drove 0\.\d\d metres\./)
  await lesson(page).getByRole("button", {name: "Back to the editor"}).click()
  await teacher.changesNumber("0.1", "0.4")
  await expect(teacher.haskell()).toContainText("Velocity 0.4 0")
  await panel.getByRole("button", {name: "Solution: Take the program on the page"}).click()
  await expect(panel).toContainText("have not been tried since the last change")
  await panel.getByRole("button", {name: "Try the solution and the wrong attempts"}).click()
  await expect(panel).toContainText("The solution passes, and all wrong attempts fail as they should.")
  await teacher.keeps("lesson-editor-rehearsal")
  await page.reload()
  await expect(panel.getByLabel("Title")).toHaveValue("Farther")

  const saved = page.waitForEvent("download")
  await panel.getByRole("button", {name: "Save as a file"}).click()
  const path = info.outputPath("Farther.json")
  await (await saved).saveAs(path)
  const link = await panel.getByLabel("Link for pupils", {exact: true}).inputValue()

  const elsewhere = await browser.newContext()
  const pupil = new Learner(await elsewhere.newPage())
  await pupil.page.goto(link)
  await expect(lesson(pupil.page).getByRole("heading", {name: "Farther"})).toBeVisible()
  await pupil.opens("accelerate")
  await pupil.opensFile(path)
  await expect(pupil.haskell()).toContainText("Velocity 0.1 0")
  await pupil.changesNumber("0.1", "0.4")
  await triesStep(pupil, "Five metres")
  await expect(lesson(pupil.page)).toContainText("Lesson finished!")
  await pupil.keeps("written-lesson-solved")
  await elsewhere.close()
})
