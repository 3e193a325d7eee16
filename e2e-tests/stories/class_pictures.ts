/// Pictures of "Your first class": the board and pupils' pages of a class of its own, step by step.
///
/// What is drawn by lot in each class is replaced between service and page: the address, the class code and the three words. The pages show
/// those of an example, with a QR code that they make of it.

import {mkdtempSync, rmSync} from "node:fs"
import {tmpdir} from "node:os"
import {join} from "node:path"
import {type Browser, type BrowserContext, expect, type Page} from "@playwright/test"
import {Learner} from "./learner.ts"
import {savedIn} from "./running_class.ts"
import {startService} from "./service.ts"

const example = {code: "7bk3x9", address: "http://192.168.4.1:8080", words: "river lamp garden"}

/// Compares a page with the file of this name.
type Shoot = (page: Page, name: string) => Promise<void>

/// Takes the pictures one after the other.
export async function classPictures(browser: Browser, shoot: Shoot): Promise<void> {
  const classes = mkdtempSync(join(tmpdir(), "rosy-classes-"))
  const service = startService(["--class", "7b", "--host", "127.0.0.1"], {
    ...process.env,
    ROSY_CLASSES: classes,
  })
  const contexts: BrowserContext[] = []
  try {
    const [, address = ""] = await service.says(/Rosy is ready at (\S+)\//)
    const [, code = ""] = await service.says(/Class code +(\S+)/)
    const [, board = ""] = await service.says(/Teacher's board +(\S+)/)
    const device = async () => {
      const context = await browser.newContext({
        viewport: {width: 1200, height: 720},
        deviceScaleFactor: 1.25,
        colorScheme: "light",
        reducedMotion: "reduce",
      })
      contexts.push(context)
      await context.routeWebSocket(/.*/, page => {
        const server = page.connectToServer()
        server.onMessage(message => page.send(typeof message === "string" ? asExample(message) : message))
      })
      return context.newPage()
    }

    const teacher = await device()
    await teacher.goto(board)
    await expect(teacher.getByText(example.address)).toBeVisible()
    await shoot(teacher, "class-start")
    const projector = await opensProjector(teacher)
    await expect(projector.getByText(example.address)).toBeVisible()
    await shoot(projector, "class-invite")
    await projector.close()

    const ada = await device()
    await ada.goto(`${address}/?example=forwardBackward`)
    const card = ada.getByRole("dialog", {name: "Join your class"})
    await card.getByRole("textbox", {name: "Class code"}).fill(example.code)
    await card.getByRole("textbox", {name: "Nickname"}).fill("Ada")
    await shoot(ada, "class-join")
    await joins(ada, code, "Ada")
    const ben = await device()
    await ben.goto(`${address}/?example=move`)
    await joins(ben, code, "Ben")

    await ben.getByRole("button", {name: "Raise hand"}).click()
    await expect(teacher.getByText("Ben", {exact: true}).first()).toBeVisible()
    await expect(teacher.locator("canvas")).toHaveCount(2)
    await expect(teacher.getByTestId("pupil Ben").getByText("Raised hand")).toBeVisible()
    await teacher.evaluate(() => window.scrollTo(0, document.body.scrollHeight))
    await shoot(teacher, "class-teach")
    await worksTogether(teacher, new Learner(ada), shoot)
    await showsOnProjector(teacher, shoot)
    await sendsLesson(teacher, ben, shoot)
    await teacher.getByRole("button", {name: "Eyes up"}).click()
    await expect(ada.getByTestId("eyes-up")).toBeVisible()
    await shoot(ada, "class-eyes-up")
    await teacher.getByRole("button", {name: "Let them go on"}).click()
    await expect(ada.getByTestId("eyes-up")).toHaveCount(0)

    await teacher.getByRole("textbox", {name: "Title of an assignment"}).fill("Drive a square")
    await teacher.getByRole("button", {name: "Open the assignment"}).click()
    await ada.getByRole("button", {name: "Hand in", exact: true}).click()
    await expect(teacher.getByTestId("open-task")).toContainText("1 of 2 have handed in.")
    await expect(teacher.getByTestId("hand-in Ben")).toContainText("not yet")
    await teacher.evaluate(() => window.scrollTo(0, 0))
    await shoot(teacher, "class-hand-in")
    await checksHandIns(teacher)
    await shoot(teacher, "class-check")
    await teacher.getByTestId("backup-tool").evaluate(tool => tool.scrollIntoView({block: "center"}))
    await shoot(teacher, "class-end")
  } finally {
    for (const context of contexts) await context.close()
    await service.ends()
    rmSync(classes, {recursive: true, force: true})
  }
}

/// The teacher comments on a number of Ada's program, and then both edit it.
async function worksTogether(teacher: Page, ada: Learner, shoot: Shoot): Promise<void> {
  await ada.changesNumber("0.5", "0.25")
  await savedIn(ada)
  await teacher.getByRole("button", {name: "Look at the program of Ada"}).click()
  const copy = teacher.frameLocator("iframe")
  await copy.getByTestId("haskell").getByText("0.25", {exact: true}).click()
  const comments = teacher.getByTestId("board-comments")
  await expect(comments.getByRole("status")).toContainText("0.25")
  await comments.getByRole("textbox", {name: "Comment"}).fill("Try it faster.")
  await comments.getByRole("button", {name: "Send the comment"}).click()
  await expect(comments).toContainText("not done yet")
  await expect(copy.getByTestId("comment-in-text")).toBeVisible()
  await shoot(teacher, "class-comment")

  await teacher.getByRole("button", {name: "Ask to edit together"}).click()
  await ada.page.getByTestId("class-sharing").getByRole("button", {name: "Allow"}).click()
  await expect(teacher.getByTestId("board-sharing")).toContainText("editing this program together")
  await ada.entersHaskell()
  await ada.page.keyboard.press("Control+End")
  await ada.page.keyboard.type("\n-- faster now")
  await expect(copy.getByTestId("haskell")).toContainText("-- faster now")
  await expect(copy.getByTestId("other-cursor")).toBeVisible()
  await shoot(teacher, "class-together")
  await ada.page.getByRole("button", {name: "Stop editing together"}).click()
  await expect(teacher.getByTestId("board-sharing")).toContainText("has ended")
  // The dialog covers the tools of the board.
  await teacher.getByRole("button", {name: "Close"}).click()
  await expect(teacher.getByRole("dialog")).toHaveCount(0)
}

async function opensProjector(teacher: Page): Promise<Page> {
  const opening = teacher.waitForEvent("popup")
  await teacher.getByRole("button", {name: "Open the projector page"}).click()
  return opening
}

async function showsOnProjector(teacher: Page, shoot: Shoot): Promise<void> {
  const projector = await opensProjector(teacher)
  await teacher.getByRole("button", {name: "Show on the projector: Ada"}).click()
  await expect(projector.getByRole("img", {name: "Room of A pupil"})).toBeVisible()
  await shoot(projector, "class-projector")
  await projector.close()
  await teacher.getByRole("button", {name: "Show nobody"}).click()
}

/// To one of two pupils.
async function sendsLesson(teacher: Page, ben: Page, shoot: Shoot): Promise<void> {
  await teacher.getByRole("checkbox", {name: "Select Ben"}).check()
  const sending = teacher.getByTestId("send")
  await sending.getByRole("combobox", {name: "Send"}).selectOption("A lesson")
  await sending.getByRole("combobox", {name: "Which one"}).selectOption("Bump!")
  await sending.getByRole("button", {name: "Send to one pupil"}).click()
  await expect(sending).toContainText("Sent to 1 page.")
  await expect(ben.getByText("Your teacher sent the lesson “Bump!”.")).toBeVisible()
  await teacher.evaluate(() => window.scrollTo(0, 0))
  await shoot(teacher, "class-send")
  await sending.getByRole("button", {name: "Select none"}).click()
}

/// In generated rooms; the row of the one pupil who handed in is unfolded.
async function checksHandIns(teacher: Page): Promise<void> {
  await teacher.getByText("Check all in rooms").click()
  await teacher.getByRole("combobox", {name: "Rooms"}).selectOption("obstacles")
  await teacher.getByRole("combobox", {name: "How many"}).selectOption("5")
  await teacher.getByRole("button", {name: "Check all"}).click()
  await expect(teacher.getByTestId("result Ada")).toContainText("of 5")
  await expect(teacher.getByRole("button", {name: "Check all"})).toBeVisible()
  await teacher.getByRole("button", {name: "All rooms of Ada"}).click()
  const rooms = teacher.getByRole("list", {name: "All rooms of Ada"})
  await expect(rooms.getByRole("listitem")).toHaveCount(5)
  await expect(rooms.getByRole("button", {name: "Open room 3 of Ada"})).toBeVisible()
  await teacher.getByTestId("check-results").evaluate(table => table.scrollIntoView({block: "center"}))
  await teacher.mouse.move(0, 0)
}

async function joins(page: Page, code: string, nickname: string): Promise<void> {
  const card = page.getByRole("dialog", {name: "Join your class"})
  await card.getByRole("textbox", {name: "Class code"}).fill(code)
  await card.getByRole("textbox", {name: "Nickname"}).fill(nickname)
  await card.getByRole("button", {name: "Join the class"}).click()
  await expect(page.getByTestId("three-words")).toContainText("river")
  await page.getByRole("button", {name: "I wrote them down"}).click()
  await expect(page.getByTestId("haskell")).toContainText("simulate")
}

/// A message of the service with the example's address, code and words.
function asExample(message: string): string {
  return message
    .replace(/"code":"[a-z0-9]{6}"/g, `"code":"${example.code}"`)
    .replace(/"addresses":\[[^\]]*\]/g, `"addresses":["${example.address}"]`)
    .replace(/"words":"[a-z]+ [a-z]+ [a-z]+"/g, `"words":"${example.words}"`)
}
