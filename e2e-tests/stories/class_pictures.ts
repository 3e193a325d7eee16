/// Pictures of "Your first class": the board and pupils' pages of a class of its own, step by step.
///
/// What is drawn by lot in each class is replaced between service and page: the address, the class code and the three words. The pages show
/// those of an example, with a QR code that they make of it.

import {mkdtempSync, rmSync} from "node:fs"
import {tmpdir} from "node:os"
import {join} from "node:path"
import {type Browser, type BrowserContext, expect, type Page} from "@playwright/test"
import {startService} from "./service.ts"

const example = {code: "7bk3x9", address: "http://192.168.4.1:8080", words: "river lamp garden"}

/// Takes the pictures one after the other; `shoot` compares a page with the file of this name.
export async function classPictures(
  browser: Browser,
  shoot: (page: Page, name: string) => Promise<void>,
): Promise<void> {
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
    await expect(teacher.getByText("Raised hand")).toBeVisible()
    await teacher.evaluate(() => window.scrollTo(0, document.body.scrollHeight))
    await shoot(teacher, "class-teach")

    await teacher.getByRole("textbox", {name: "Title of a task"}).fill("Drive a square")
    await teacher.getByRole("button", {name: "Open the task"}).click()
    await ada.getByRole("button", {name: "Hand in", exact: true}).click()
    await expect(teacher.getByTestId("open-task")).toContainText("1 of 2 have handed in.")
    await expect(teacher.getByTestId("hand-in Ben")).toContainText("not yet")
    await teacher.evaluate(() => window.scrollTo(0, 0))
    await shoot(teacher, "class-hand-in")
  } finally {
    for (const context of contexts) await context.close()
    await service.ends()
    rmSync(classes, {recursive: true, force: true})
  }
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
