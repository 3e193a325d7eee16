/// Class mode: pupils join on the teacher's computer, nothing that was reported as saved is lost, and the teacher sees who needs help.

import {AxeBuilder} from "@axe-core/playwright"
import {type Browser, expect, type Page} from "@playwright/test"
import {Learner, screenshot} from "./learner.ts"
import {device, RunningClass, savedIn} from "./running_class.ts"
import {test} from "./story.ts"

let running: RunningClass

test.beforeEach(async () => {
  running = await RunningClass.start()
})

test.afterEach(() => running.ends())

const joins = (browser: Browser, nickname: string) => running.joins(browser, nickname)

const continues = (browser: Browser, words: string) => running.continues(browser, words)

test("a pupil's last letter is on another device, also after the service was killed", async ({browser}) => {
  const {learner: ada, words} = await joins(browser, "Ada")
  await ada.changesNumber("0.5", "0.25")
  await expect(ada.haskell()).toContainText("0.25")
  await savedIn(ada)
  await ada.page.context().close()

  const tablet = await continues(browser, words)
  await expect(tablet.haskell()).toContainText("0.25")
  await expect(tablet.page.getByTestId("class-bar")).toContainText("Ada")

  await running.dies()
  await expect(tablet.page.getByTestId("class-saved")).toContainText("No connection to the class")
  // Work goes on without the service, and reaches it when it is back.
  await tablet.changesNumber("0.25", "0.75")
  await expect(tablet.haskell()).toContainText("0.75")
  running = await running.startsAgain()
  await savedIn(tablet)
  const text = await tablet.haskellText()
  await tablet.page.context().close()

  const third = await continues(browser, words)
  await expect.poll(() => third.haskellText()).toBe(text)
  await third.page.context().close()
})

test("what two devices changed without each other becomes two programs", async ({browser}) => {
  const {learner: ada, words} = await joins(browser, "Ada")
  await ada.changesNumber("0.5", "0.25")
  await expect(ada.haskell()).toContainText("0.25")
  await savedIn(ada)
  const tablet = await continues(browser, words)
  await expect(tablet.haskell()).toContainText("0.25")

  await running.dies()
  for (const learner of [ada, tablet])
    await expect(learner.page.getByTestId("class-saved")).toContainText("No connection to the class")
  await ada.changesNumber("0.25", "0.35")
  await expect(ada.haskell()).toContainText("0.35")
  await tablet.changesNumber("0.25", "0.45")
  await expect(tablet.haskell()).toContainText("0.45")
  running = await running.startsAgain()
  await savedIn(ada)
  await savedIn(tablet)

  // The device that saved second has a program of another name, and both are in the class.
  const third = await continues(browser, words)
  await savedIn(third)
  await third.page.getByRole("button", {name: "My programs"}).first().click()
  const programs = third.page.getByRole("dialog", {name: "My programs"})
  await expect(programs.getByText("forwardBackward", {exact: true})).toBeVisible()
  await expect(programs.getByText("forwardBackward 2", {exact: true})).toBeVisible()
  for (const learner of [ada, tablet, third]) await learner.page.context().close()
})

/// What the service's Content Security Policy keeps from a page from now on, as the browser reports it.
function policyViolations(page: Page): readonly string[] {
  const found: string[] = []
  page.on("console", message => {
    if (message.text().includes("Content Security Policy")) found.push(message.text())
  })
  return found
}

/// What axe-core finds wrong with a page or a part of it (WCAG 2.2 A and AA).
async function faults(page: Page, part = "body"): Promise<unknown[]> {
  const {violations} = await new AxeBuilder({page})
    .withTags(["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"])
    .include(part)
    .exclude(".blocks-host")
    .analyze()
  return violations.map(violation => [violation.id, violation.nodes.map(node => node.html)])
}

test("the board shows two pupils live, their programs and a raised hand, and every page looks up", async ({
  browser,
}) => {
  const teacher = await device(browser)
  const violations = policyViolations(teacher)
  await teacher.goto(running.board)
  await expect(teacher.getByText("No pupil has joined yet.")).toBeVisible()
  expect(teacher.url()).not.toContain("key")
  const {learner: ada} = await joins(browser, "Ada <b>")
  const {learner: ben} = await joins(browser, "Ben")
  const adaOnBoard = teacher.getByTestId("pupil Ada <b>")
  const benOnBoard = teacher.getByTestId("pupil Ben")
  await expect(adaOnBoard.getByRole("heading", {name: "Ada <b>"})).toBeVisible()
  await expect(benOnBoard.getByText("no program saved yet")).toBeVisible()

  await ada.changesNumber("0.5", "0.25")
  await expect(ada.haskell()).toContainText("0.25")
  await savedIn(ada)
  await expect(adaOnBoard.getByText("forwardBackward")).toBeVisible()
  const room = adaOnBoard.getByRole("img", {name: "Room of Ada <b>"})
  await expect(room).toBeVisible()
  const picture = () => room.evaluate(canvas => (canvas as HTMLCanvasElement).toDataURL())
  const parked = await picture()
  await ada.runs()
  await expect(adaOnBoard.getByText("running", {exact: true})).toBeVisible()
  await expect.poll(picture).not.toBe(parked)

  await ben.page.getByRole("button", {name: "Raise hand"}).click()
  await expect(benOnBoard.getByText("Raised hand")).toBeVisible()
  await teacher.setViewportSize({width: 390, height: 844})
  await teacher.screenshot({path: screenshot("board-phone")})
  // The board scrolls; who needs help stays in sight, and leads to the card.
  const inNeed = teacher.getByTestId("pupils-in-need").getByRole("link", {name: "Ben"})
  await teacher.mouse.move(195, 600)
  await teacher.mouse.wheel(0, 20_000)
  await expect(benOnBoard.getByRole("button", {name: "Show on the projector: Ben"})).toBeInViewport()
  await teacher.mouse.wheel(0, -20_000)
  await expect(benOnBoard).not.toBeInViewport()
  await inNeed.click()
  await expect(benOnBoard).toBeInViewport()
  await expect(inNeed).toBeInViewport()
  await teacher.setViewportSize({width: 1440, height: 900})
  await teacher.screenshot({path: screenshot("board")})
  expect(await faults(teacher)).toEqual([])
  await benOnBoard.getByRole("button", {name: "I have seen it"}).click()
  await expect(ben.page.getByRole("button", {name: "Raise hand"})).toBeVisible()

  await teacher.getByRole("textbox", {name: "Message to all"}).fill("Look at me")
  await teacher.getByRole("button", {name: "Eyes up"}).click()
  for (const learner of [ada, ben]) await expect(learner.page.getByTestId("eyes-up")).toHaveText("Look at me")
  await teacher.getByRole("button", {name: "Let them go on"}).click()
  for (const learner of [ada, ben]) await expect(learner.page.getByTestId("eyes-up")).toHaveCount(0)
  await ada.stops()

  await benOnBoard.getByRole("checkbox", {name: "Select Ben"}).check()
  const sending = teacher.getByTestId("send")
  await sending.getByRole("combobox", {name: "Send"}).selectOption("A lesson")
  await sending.getByRole("combobox", {name: "Which one"}).selectOption("Bump!")
  await sending.getByRole("button", {name: "Send to one pupil"}).click()
  await expect(sending.getByText("Sent to 1 page")).toBeVisible()
  await expect(ben.page.getByText("Your teacher sent the lesson “Bump!”.")).toBeVisible()
  await teacher.screenshot({path: screenshot("board-send")})
  await ben.page.getByRole("button", {name: "Open it"}).click()
  await expect(ben.page.getByRole("complementary", {name: "Lesson"})).toContainText("Bump!")
  await expect(ada.page.getByText("Your teacher sent")).toHaveCount(0)

  await adaOnBoard.getByRole("button", {name: "Look at the program of Ada <b>"}).click()
  const copy = teacher.frameLocator("iframe")
  await expect(copy.getByTestId("haskell")).toContainText("0.25")
  // The board, and the page embedded in it.
  expect(violations).toEqual([])
  for (const page of [ada.page, ben.page, teacher]) await page.context().close()
})

test("a pupil hands in, hands in again until the teacher ends the task, and reads the comment", async ({
  browser,
}) => {
  const teacher = await device(browser)
  await teacher.goto(running.board)
  const {learner: ada} = await joins(browser, "Ada")
  const {learner: ben} = await joins(browser, "Ben")
  await expect(ada.page.getByRole("button", {name: "Hand in"})).toHaveCount(0)
  await teacher.getByRole("textbox", {name: "Title of an assignment"}).fill("Drive a square")
  await teacher.getByRole("button", {name: "Open the assignment"}).click()
  await expect(teacher.getByTestId("open-task")).toContainText("0 of 2 have handed in.")

  const task = ada.page.getByTestId("class-task")
  await expect(task).toContainText("Drive a square")
  await ada.page.getByRole("button", {name: "Hand in", exact: true}).click()
  await expect(task).toContainText("handed in at")
  await expect(teacher.getByTestId("open-task")).toContainText("1 of 2 have handed in.")
  await expect(teacher.getByTestId("hand-in Ben")).toContainText("not yet")
  await ben.page.getByRole("button", {name: "Hand in", exact: true}).click()
  await expect(teacher.getByTestId("hand-in Ben")).toContainText("The same program as Ada")
  await ada.changesNumber("0.5", "0.25")
  await expect(ada.haskell()).toContainText("0.25")
  const again = ada.page.getByRole("button", {name: "Hand in again"})
  await again.click()
  await expect(again).toBeEnabled()
  await expect(teacher.getByTestId("hand-in Ben")).not.toContainText("The same program")
  const download = teacher.waitForEvent("download")
  await teacher.getByRole("button", {name: "Download all, with a table (ZIP)"}).click()
  expect((await download).suggestedFilename()).toBe("Drive a square.zip")

  const row = teacher.getByTestId("hand-in Ada")
  await row.getByRole("textbox", {name: "Comment for Ada"}).fill("Look at the corner.")
  await row.getByRole("button", {name: "Send"}).click()
  await expect(task).toContainText("Look at the corner.")
  await expect(ben.page.getByTestId("class-task")).not.toContainText("Look at the corner.")
  expect(await faults(teacher)).toEqual([])
  // Of the pupil's page what the class adds to it; `looks.spec.ts` checks the rest.
  expect(await faults(ada.page, "#class-bar")).toEqual([])
  await teacher.screenshot({path: screenshot("board-task")})
  await ada.page.screenshot({path: screenshot("class-task")})
  for (const page of [teacher, ada.page]) await page.setViewportSize({width: 390, height: 844})
  await teacher.screenshot({path: screenshot("board-task-phone"), fullPage: true})
  await ada.page.screenshot({path: screenshot("class-task-phone")})
  for (const page of [teacher, ada.page]) await page.setViewportSize({width: 1440, height: 900})
  await task.getByRole("button", {name: "I have read it"}).click()
  await expect(task).not.toContainText("Look at the corner.")

  await teacher.getByRole("button", {name: "End the assignment"}).click()
  await expect(ben.page.getByTestId("class-task").getByRole("button")).toHaveCount(0)
  await expect(task.getByRole("button")).toHaveCount(0)
  await row.getByRole("button", {name: "Look at what Ada handed in"}).click()
  await expect(teacher.frameLocator("iframe").getByTestId("haskell")).toContainText("0.25")
  await teacher.getByRole("button", {name: "Close"}).click()

  // Both programs are checked in the room that they were handed in with; a tab of its own shows one in its worst room.
  await teacher.getByText("Check all in rooms").click()
  await teacher.getByRole("combobox", {name: "How many"}).selectOption("1")
  await teacher.getByRole("button", {name: "Check all"}).click()
  for (const nickname of ["Ada", "Ben"])
    await expect(teacher.getByTestId(`result ${nickname}`)).toContainText("0 of 1")
  await expect(teacher.getByRole("button", {name: "Check all"})).toBeVisible()
  expect(await faults(teacher)).toEqual([])
  await teacher.screenshot({path: screenshot("board-check"), fullPage: true})
  // The projector shows who did best. Both passed no room, so they share the first place.
  const showing = teacher.waitForEvent("popup")
  await teacher.getByRole("button", {name: "Open the projector page"}).click()
  const projector = await showing
  await teacher
    .getByRole("button", {name: "Show places, rooms and times with nicknames on the projector"})
    .click()
  await expect(projector.getByRole("heading", {name: "Drive a square"})).toBeVisible()
  await expect(projector.getByRole("row")).toHaveText([/Place/, /1Ada0 of 1–/, /1Ben0 of 1–/])
  await expect(teacher.getByTestId("projector-tool")).toContainText("table of “Drive a square”")
  expect(await faults(projector)).toEqual([])
  await projector.screenshot({path: screenshot("projector-standings")})
  await projector.close()
  const opening = teacher.waitForEvent("popup")
  await teacher.getByRole("button", {name: "Open the worst room of Ada"}).click()
  const worst = new Learner(await opening)
  await expect(worst.haskell()).toContainText("0.25")
  expect(new URL(worst.page.url()).searchParams.get("seed")).toMatch(/^\d+$/)
  // It runs without a press of Run.
  await worst.stops()
  await worst.page.close()
  await teacher.setViewportSize({width: 390, height: 844})
  await teacher.screenshot({path: screenshot("board-check-phone"), fullPage: true})
  for (const page of [ada.page, ben.page, teacher]) await page.context().close()
})

test("the board asks for the key, and the card to join is usable by everybody", async ({browser}) => {
  const page = await device(browser)
  await page.goto(`${running.address}/board`)
  await page.getByLabel("Teacher's key").fill("not the key")
  await page.getByRole("button", {name: "Open the board"}).click()
  await expect(page.getByRole("alert")).toContainText("This is not the teacher's key")
  expect(await faults(page)).toEqual([])
  await page.goto(running.address)
  const card = page.getByRole("dialog", {name: "Join your class"})
  await card.getByRole("textbox", {name: "Class code"}).fill("wrong")
  await card.getByRole("textbox", {name: "Nickname"}).fill("Ada")
  await card.getByRole("button", {name: "Join the class"}).click()
  await expect(card.getByRole("alert")).toContainText("This is not the code of the class.")
  expect(await faults(page)).toEqual([])
  await page.screenshot({path: screenshot("class-join")})
  await page.setViewportSize({width: 390, height: 844})
  await page.screenshot({path: screenshot("class-join-phone")})
  await card.getByRole("button", {name: "Without the class"}).click()
  await expect(card).toHaveCount(0)
  await page.context().close()
})
