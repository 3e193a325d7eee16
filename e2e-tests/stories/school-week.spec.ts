/// A school week of two classes on one laptop: three lessons, a break with the lid closed, a hand-in, a comment, the competition, and the week after.
///
/// What a part does by itself is in the stories of the class (`class*.spec.ts`); this one finds what is lost between the parts.

import {expect} from "@playwright/test"
import {Pupil} from "./pupil.ts"
import {device, RunningClass, savedIn} from "./running_class.ts"
import {test} from "./story.ts"

let running: RunningClass

test.beforeEach(async () => {
  running = await RunningClass.start()
})

test.afterEach(() => running.ends())

test("two classes, three lessons, a closed lid, a hand-in, a comment, the competition, and the next week", async ({
  browser,
}) => {
  const teacher = await device(browser)
  const sends = async (lesson: string) => {
    const sending = teacher.getByTestId("send")
    await sending.getByRole("combobox", {name: "Send"}).selectOption("A lesson")
    await sending.getByRole("combobox", {name: "Which one"}).selectOption(lesson)
    await sending.getByRole("button", {name: "Send to all"}).click()
  }
  const opens = async (pupil: Pupil, lesson: string) => {
    await pupil.page.getByRole("button", {name: "Open it"}).click()
    await expect(pupil.panel().getByRole("heading", {name: lesson})).toBeVisible()
  }

  // Monday, 7b: the first lesson, and a break with the lid closed.
  await teacher.goto(running.board)
  const {learner, words} = await running.joins(browser, "Ada")
  const ada = new Pupil(learner.page)
  const ben = new Pupil((await running.joins(browser, "Ben")).learner.page)
  await sends("Hello, robot")
  for (const pupil of [ada, ben]) await opens(pupil, "Hello, robot")
  await ada.answers("1 metre ahead")
  await ben.changesNumber("0.2", "0.3")
  await savedIn(ben)
  await expect(teacher.getByTestId("pupil Ada").getByText("Hello, robot: 1 of 5")).toBeVisible()
  running.standsStill()
  await expect(ada.page.getByTestId("class-saved")).toContainText("No connection to the class")
  await expect(teacher.getByText("No connection to Rosy.")).toBeVisible()
  running.goesOn()
  for (const pupil of [ada, ben]) await savedIn(pupil)
  await expect(teacher.getByTestId("suspended")).toContainText("Rosy stood still")
  // All are connected as before: a hand reaches the board.
  await ada.page.getByRole("button", {name: "Raise hand"}).click()
  await expect(teacher.getByTestId("pupil Ada")).toContainText("Raised hand")

  await test.step("Tuesday, 7c: on the same laptop, and on the device that Ben left open", async () => {
    running = await running.gives("7c")
    const card = ben.page.getByRole("dialog", {name: "Join your class"})
    await expect(card).toBeVisible()
    await expect(ben.haskell()).not.toContainText("0.3")
    await expect(ben.panel()).toHaveCount(0)
    await card.getByRole("textbox", {name: "Class code"}).fill(running.code)
    await card.getByRole("textbox", {name: "Nickname"}).fill("Zoe")
    await card.getByRole("button", {name: "Join the class"}).click()
    await ben.page.getByRole("button", {name: "I wrote them down"}).click()
    await ben.page.getByRole("button", {name: "My programs"}).first().click()
    const programs = ben.page.getByRole("dialog", {name: "My programs"})
    await expect(programs).toBeVisible()
    await expect(programs.getByText("Hello, robot")).toHaveCount(0)
    await ben.page.keyboard.press("Escape")
    await teacher.goto(running.board)
    await expect(teacher.getByTestId("pupil Zoe")).toBeVisible()
    await expect(teacher.getByTestId("pupil Ada")).toHaveCount(0)
    await sends("Turn on the spot")
    await opens(ben, "Turn on the spot")
    await savedIn(ben)
  })

  await test.step("Thursday, 7b: all go on, hand in, and read what the teacher says", async () => {
    running = await running.gives("7b")
    await teacher.goto(running.board)
    await expect(ada.page.getByTestId("class-bar")).toContainText("Ada")
    await expect(ben.page.getByTestId("class-bar")).toContainText("Ben")
    await expect(ben.haskell()).toContainText("0.3")
    for (const pupil of [ada, ben])
      await expect(pupil.panel().getByRole("heading", {name: "Hello, robot"})).toBeVisible()
    await expect(teacher.getByTestId("pupil Ada").getByText("Hello, robot: 1 of 5")).toBeVisible()
    await teacher.getByRole("textbox", {name: "Title of an assignment"}).fill("Into the ring")
    await teacher.getByRole("button", {name: "Open the assignment"}).click()
    await ada.changesNumber("0.2", "0.4")
    for (const pupil of [ada, ben]) {
      await pupil.page.getByRole("button", {name: "Hand in", exact: true}).click()
      await expect(pupil.page.getByTestId("class-task")).toContainText("handed in at")
    }
    const row = teacher.getByTestId("hand-in Ben")
    await row.getByRole("textbox", {name: "Comment for Ben"}).fill("How far is the ring?")
    await row.getByRole("button", {name: "Send"}).click()
    await expect(ben.page.getByTestId("class-task")).toContainText("How far is the ring?")
  })

  await test.step("The competition: the lesson's own check, and a table on the projector", async () => {
    await teacher.getByText("Check all in rooms").click()
    await teacher.getByRole("combobox", {name: "Rooms", exact: true}).selectOption("what its lesson checks")
    await teacher.getByRole("button", {name: "Check all"}).click()
    await expect(teacher.getByTestId("result Ada")).toContainText("1 of 1")
    await expect(teacher.getByTestId("result Ben")).toContainText("0 of 1")
    const showing = teacher.waitForEvent("popup")
    await teacher.getByRole("button", {name: "Open the projector page"}).click()
    const projector = await showing
    await teacher
      .getByRole("button", {name: "Show places, rooms and times with nicknames on the projector"})
      .click()
    await expect(projector.getByRole("row")).toHaveText([/Place/, /1Ada1 of 1/, /2Ben0 of 1/])
    await projector.close()
  })

  await test.step("The next week: another device, and all that was done is there", async () => {
    await savedIn(ada)
    await ada.page.context().close()
    await running.dies()
    running = await running.startsAgain()
    const tablet = new Pupil((await running.continues(browser, words)).page)
    await expect(tablet.haskell()).toContainText("0.4")
    await expect(tablet.page.getByTestId("class-task")).toContainText("handed in at")
    await tablet.page.getByRole("button", {name: "Lessons"}).click()
    const lesson = tablet.page.getByRole("dialog").getByRole("button", {name: "Hello, robot"})
    await expect(lesson).toContainText("1 of 5 steps")
    await teacher.goto(running.board)
    const comment = teacher.getByRole("textbox", {name: "Comment for Ben"})
    await expect(comment).toHaveValue("How far is the ring?")
    for (const page of [tablet.page, ben.page, teacher]) await page.context().close()
  })
})
