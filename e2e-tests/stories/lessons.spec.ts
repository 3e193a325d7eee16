/// Lessons from the list to their end: one in blocks with a wrong attempt and a hint on the way, one in text.

import {expect, type Page} from "@playwright/test"
import {lessonFolders} from "./lesson_files.ts"
import {Pupil} from "./pupil.ts"
import {test} from "./story.ts"

const pupil = (page: Page) => new Pupil(page)

test("a lesson is followed in blocks: guess, run, look, change, make, and its end leads to the next", async ({
  page,
}) => {
  const one = pupil(page)
  await one.opensLesson("Hello, robot")
  await expect(page.getByRole("textbox", {name: "Name of the program"})).toHaveValue("Hello, robot")
  await one.answers("Where it is now")
  await one.goesOn()
  await expect(one.panel()).toContainText("Your guess: Where it is now")
  await one.tries()
  await expect(one.panel()).toContainText("does not stop by itself")
  await one.goesOn()
  await one.answers("The second, 0")
  await expect(one.panel()).toContainText("The second number is for turning")
  await one.answers("The first, 0.2")
  await one.goesOn()
  await one.tries()
  await expect(one.check("It drives backwards")).toContainText("It did not drive backwards.")
  await one.panel().getByRole("button", {name: "Give me a hint"}).click()
  await expect(one.panel()).toContainText("What number is the opposite of 0.2?")
  await one.changesNumber("0.2", "-0.2")
  await expect(one.haskell()).toContainText("Velocity (-0.2) 0")
  await one.tries()
  await expect(one.check("It drives backwards")).toHaveAttribute("data-check-state", "done")
  await one.goesOn()
  await one.panel().getByRole("button", {name: "Begin this step again"}).click()
  await expect(one.haskell()).toContainText("Velocity 0.2 0")
  // The run before has ended; its button may be drawn a moment after the text.
  await expect(one.runButton()).toHaveText("Run")
  await one.tries()
  await expect(one.check("In the ring at 5 s")).toContainText("metres away from it at 5.0 s.")
  await one.changesNumber("0.2", "0.4")
  await one.tries()
  await expect(one.panel()).toContainText("Lesson finished!")
  await one.keeps("lesson-finished")
  await one.panel().getByRole("button", {name: "Next lesson"}).click()
  await expect(one.panel().getByRole("heading", {name: "Turn on the spot"})).toBeVisible()
  await page.getByRole("button", {name: "Lessons"}).click()
  await expect(page.getByRole("dialog").getByRole("button", {name: "Hello, robot"})).toContainText("finished")
})

test("a challenge says what is missing for one more star, and keeps the stars of the best run", async ({
  page,
}) => {
  const one = pupil(page)
  const stars = page.getByTestId("star-result")
  await page.goto("/")
  await page.getByRole("button", {name: "Challenges"}).click()
  await page.getByRole("dialog").getByRole("button", {name: "Sprint"}).click()
  await expect(one.panel()).toContainText("Challenge 1")
  await one.drivesAt("4")
  await one.changesNumber("0.1", "0.5")
  await one.tries()
  await expect(stars).toContainText("This run: 2 of 3 stars. For one more star: In under 8 seconds.")
  await one.changesNumber("0.5", "0.6")
  await one.tries()
  await expect(stars).toContainText("This run: 3 of 3 stars. That is all of them!")
  await page.reload()
  await page.getByRole("button", {name: "Challenges"}).click()
  const sprint = page.getByRole("dialog").getByRole("button", {name: "Sprint"})
  await expect(sprint.getByRole("img", {name: "3 of 3 stars"})).toBeVisible()
})

test("a lesson is followed in text, survives a reload, and is left for free play", async ({page}) => {
  const one = pupil(page)
  await one.opensLesson("Bump!")
  await one.answers("Two")
  await one.goesOn()
  await one.tries()
  await expect(one.panel()).toContainText("One when it is pressed, one when it is released.")
  await one.goesOn()
  await one.answers("For any bumper event")
  await one.goesOn()
  await page.reload()
  await expect(one.panel()).toContainText("Choose another sound.")
  await expect(one.haskell()).toContainText("simulate")
  const start = "start :: RobotStatus -> Velocity\nstart _ = Velocity 0.3 0\n\n"
  await one.writes(
    `${start}bump :: Bumper -> (Velocity, Sound)\nbump _ = (Velocity (-0.3) 0, ButtonSound)\n\nmain = simulate (start, bump)\n`,
  )
  await one.tries()
  await expect(one.check("Another sound than ErrorSound")).toHaveAttribute("data-check-state", "done")
  await one.goesOn()
  await one.tries()
  await expect(one.check("No sound when it lets go")).toContainText("something followed that should not")
  await one.writes(
    `${start}bump :: Bumper -> (Velocity, Maybe Sound)\nbump (Bumper _ Pressed) = (Velocity (-0.3) 0, Just ErrorSound)\nbump _ = (Velocity (-0.3) 0, Nothing)\n\nmain = simulate (start, bump)\n`,
  )
  await one.tries()
  await expect(one.panel()).toContainText("Lesson finished!")
  await one.panel().getByRole("button", {name: "Play freely with this program"}).click()
  await expect(one.panel()).toBeHidden()
  await expect(one.haskell()).toContainText("Just ErrorSound")
})

/// Lessons whose programs begin with blocks that are wider than a small laptop shows at a size that can be read.
const tooWide: readonly string[] = [
  "which-side",
  "count-the-bumps",
  "a-mode-of-my-own",
  "my-own-event",
  "chance",
  "a-task-that-answers",
  "the-papers-robot",
]

test("each lesson begins with blocks that are seen in their whole width on the pages of small laptops", async ({
  page,
}) => {
  const one = pupil(page)
  await page.goto("/")
  await expect(one.haskell()).toContainText("simulate")
  /// Pixels by which the blocks are wider than their view.
  const excess = () =>
    page.evaluate(() => {
      const view = document.querySelector(".blocks-host svg.blocklySvg")?.getBoundingClientRect()
      const blocks = [...document.querySelectorAll(".blocks-host .blocklyBlockCanvas > .blocklyDraggable")]
      return Math.max(...blocks.map(block => block.getBoundingClientRect().right)) - (view?.right ?? 0)
    })
  for (const {name, texts} of lessonFolders()) {
    await page.setViewportSize({width: 1366, height: 768})
    await one.choosesLesson(texts.title)
    for (const width of [1366, 1280]) {
      await page.setViewportSize({width, height: 768})
      if (!tooWide.includes(name))
        await expect.poll(excess, {message: `${name}, ${width} px`}).toBeLessThan(0)
    }
  }
})
