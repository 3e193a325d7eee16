/// Class mode: the teacher comments on a block of a pupil's program, and shows a pupil's room on the projector.

import {mkdtempSync, rmSync} from "node:fs"
import {tmpdir} from "node:os"
import {join} from "node:path"
import {AxeBuilder} from "@axe-core/playwright"
import {type Browser, expect, type Page} from "@playwright/test"
import {Learner, screenshot} from "./learner.ts"
import {startService, type Talker} from "./service.ts"
import {test} from "./story.ts"

let classes: string
let service: Talker
let address: string
let code: string
let board: string

test.beforeEach(async () => {
  classes = mkdtempSync(join(tmpdir(), "rosy-classes-"))
  service = startService(["--class", "7b", "--host", "127.0.0.1"], {...process.env, ROSY_CLASSES: classes})
  address = (await service.says(/Rosy is ready at (\S+)\//))[1] ?? ""
  code = (await service.says(/Class code +(\S+)/))[1] ?? ""
  board = (await service.says(/Teacher's board +(\S+)/))[1] ?? ""
})

test.afterEach(async () => {
  await service.ends()
  rmSync(classes, {recursive: true, force: true})
})

async function device(browser: Browser): Promise<Page> {
  const context = await browser.newContext({viewport: {width: 1440, height: 900}})
  return context.newPage()
}

/// A pupil with a program of their own, which is saved in the class.
async function pupil(browser: Browser, nickname: string): Promise<Learner> {
  const page = await device(browser)
  await page.goto(`${address}/?example=forwardBackward#class=${code}`)
  const card = page.getByRole("dialog", {name: "Join your class"})
  await card.getByRole("textbox", {name: "Nickname"}).fill(nickname)
  await card.getByRole("button", {name: "Join the class"}).click()
  await page.getByRole("button", {name: "I wrote them down"}).click()
  const learner = new Learner(page)
  await learner.changesNumber("0.5", "0.25")
  await expect(learner.haskell()).toContainText("0.25")
  await expect(page.getByTestId("class-saved")).toHaveText("Saved in the class")
  return learner
}

/// What axe-core finds wrong with a part of a page (WCAG 2.2 A and AA).
async function faults(page: Page, part: string): Promise<unknown[]> {
  const {violations} = await new AxeBuilder({page})
    .withTags(["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"])
    .include(part)
    .exclude("iframe")
    .analyze()
  return violations.map(violation => [violation.id, violation.nodes.map(node => node.html)])
}

test("the teacher comments on a number of a pupil's program, and sees that the pupil is done with it", async ({
  browser,
}) => {
  const ada = await pupil(browser, "Ada")
  const teacher = await device(browser)
  await teacher.goto(board)
  await teacher.getByRole("button", {name: "Look at the program of Ada"}).click()
  const copy = teacher.frameLocator("iframe")
  const comments = teacher.getByTestId("board-comments")
  await expect(comments).toContainText("Choose a block or a line in the program")
  await copy.getByTestId("haskell").getByText("0.25", {exact: true}).click()
  await expect(comments.getByRole("status")).toContainText(/About line \d+: 0\.25/)
  await comments.getByRole("textbox", {name: "Comment"}).fill("Try it faster.")
  await comments.getByRole("button", {name: "Send the comment"}).click()
  await expect(comments).toContainText("not done yet")
  await expect(copy.getByTestId("comment-in-text")).toContainText("Try it faster.")
  expect(await faults(teacher, ".board-program")).toEqual([])
  await teacher.screenshot({path: screenshot("board-comments")})

  const bar = ada.page.getByTestId("class-comments")
  await expect(bar).toContainText(/Your teacher says:.*Try it faster\..*line \d+: 0\.25/)
  await expect(ada.page.getByTestId("comment-in-text")).toHaveText("Your teacher says: Try it faster.")
  await expect(ada.page.locator(".rosyTeacherComment")).toHaveCount(1)
  expect(await faults(ada.page, ".class-bar")).toEqual([])
  await ada.page.screenshot({path: screenshot("class-comments")})

  // It follows an edit above it, and stays after a reload.
  await ada.entersHaskell()
  await ada.page.keyboard.press("Control+Home")
  await ada.page.keyboard.type("-- mine\n\n")
  await expect(ada.haskell()).toContainText("-- mine")
  await expect(bar).toContainText("0.25")
  await expect(ada.page.getByTestId("class-saved")).toHaveText("Saved in the class")
  await ada.page.reload()
  await expect(bar).toContainText("0.25")
  await expect(ada.page.getByTestId("comment-in-text")).toHaveText("Your teacher says: Try it faster.")
  await ada.page.setViewportSize({width: 390, height: 844})
  await ada.page.screenshot({path: screenshot("class-comments-phone")})
  await bar.getByRole("button", {name: "Done: “Try it faster.”"}).click()
  await expect(bar).toHaveCount(0)
  await expect(ada.page.getByTestId("comment-in-text")).toHaveCount(0)
  await expect(comments).toContainText("The pupil has done it.")
  for (const page of [ada.page, teacher]) await page.context().close()
})

test("the projector shows a pupil's room, first without the name, then with it and the program", async ({
  browser,
}) => {
  const ada = await pupil(browser, "Ada")
  const teacher = await device(browser)
  await teacher.goto(board)
  const opening = teacher.waitForEvent("popup")
  await teacher.getByRole("button", {name: "Open the projector page"}).click()
  const screen = await opening
  // How pupils join, until a pupil is shown.
  await expect(screen.getByTestId("class-code")).toHaveText(/^[a-z0-9]{6}$/)
  await expect(screen.getByRole("img", {name: "QR code of the address with the class code"})).toBeVisible()
  expect(await faults(screen, "body")).toEqual([])
  expect(screen.url()).not.toContain("key")
  await teacher.getByRole("button", {name: "Show on the projector: Ada"}).click()
  await expect(screen.getByRole("heading", {name: "A pupil"})).toBeVisible()
  await expect(screen.getByText("Ada")).toHaveCount(0)
  const room = screen.getByRole("img", {name: "Room of A pupil"})
  await expect(room).toBeVisible()
  const picture = () => room.evaluate(canvas => (canvas as HTMLCanvasElement).toDataURL())
  const parked = await picture()
  await ada.runs()
  await expect(screen.getByRole("status")).toHaveText("running")
  await expect.poll(picture).not.toBe(parked)

  const tool = teacher.getByTestId("projector-tool")
  await tool.getByRole("checkbox", {name: "With the nickname"}).check()
  await tool.getByRole("checkbox", {name: "With the program"}).check()
  await expect(screen.getByRole("heading", {name: "Ada"})).toBeVisible()
  await expect(screen.getByRole("textbox", {name: "Program"})).toHaveValue(/0\.25/)
  expect(await faults(screen, "body")).toEqual([])
  await screen.screenshot({path: screenshot("projector")})
  await screen.setViewportSize({width: 390, height: 844})
  await screen.screenshot({path: screenshot("projector-phone")})
  await expect(tool).toContainText("The projector shows the room of Ada.")
  await tool.scrollIntoViewIfNeeded()
  await teacher.screenshot({path: screenshot("board-projector")})
  expect(await faults(teacher, "body")).toEqual([])
  await tool.getByRole("button", {name: "Show nobody"}).click()
  await expect(screen.getByTestId("class-code")).toBeVisible()
  await ada.stops()
  for (const page of [ada.page, teacher]) await page.context().close()
})
