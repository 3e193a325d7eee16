/// A running class: a service of its own with a folder of its own, and the devices with which pupils and the teacher open it.

import {mkdtempSync, rmSync} from "node:fs"
import {tmpdir} from "node:os"
import {join} from "node:path"
import {type Browser, expect, type Page} from "@playwright/test"
import {Learner} from "./learner.ts"
import {startService, type Talker} from "./service.ts"

/// A device of its own for a pupil or the teacher.
export async function device(browser: Browser): Promise<Page> {
  const context = await browser.newContext({viewport: {width: 1440, height: 900}})
  return context.newPage()
}

export const savedIn = ({page}: Learner) =>
  expect(page.getByTestId("class-saved")).toHaveText("Saved in the class")

export class RunningClass {
  readonly address: string
  readonly code: string
  /// Address of the teacher's board, with the key.
  readonly board: string
  private readonly folder: string
  private readonly service: Talker

  private constructor(folder: string, service: Talker, address: string, code: string, board: string) {
    this.folder = folder
    this.service = service
    this.address = address
    this.code = code
    this.board = board
  }

  static start(): Promise<RunningClass> {
    return RunningClass.serve(mkdtempSync(join(tmpdir(), "rosy-classes-")), "0")
  }

  private static async serve(folder: string, port: string, name = "7b"): Promise<RunningClass> {
    const options = ["--class", name, "--host", "127.0.0.1", "--port", port]
    const service = startService(options, {...process.env, ROSY_CLASSES: folder})
    const [, address] = await service.says(/Rosy is ready at (\S+)\//)
    const [, code] = await service.says(/Class code +(\S+)/)
    const [, board] = await service.says(/Teacher's board +(\S+)/)
    return new RunningClass(folder, service, address ?? "", code ?? "", board ?? "")
  }

  /// Kills the service as a power failure would.
  async dies(): Promise<void> {
    await this.service.ends("SIGKILL")
  }

  /// The laptop's lid is closed: the service does nothing, and its connections stay.
  standsStill(): void {
    this.service.process.kill("SIGSTOP")
  }

  goesOn(): void {
    this.service.process.kill("SIGCONT")
  }

  /// The same class at the same address, after its service has died.
  startsAgain(): Promise<RunningClass> {
    return RunningClass.serve(this.folder, new URL(this.address).port)
  }

  /// Another class, or this one again, at the same address: the next lesson on the same laptop.
  async gives(name: string): Promise<RunningClass> {
    await this.service.ends()
    return RunningClass.serve(this.folder, new URL(this.address).port, name)
  }

  async ends(): Promise<void> {
    await this.service.ends()
    rmSync(this.folder, {recursive: true, force: true})
  }

  async joins(browser: Browser, nickname: string): Promise<{learner: Learner; words: string}> {
    const page = await device(browser)
    await page.goto(`${this.address}/?example=forwardBackward#class=${this.code}`)
    const card = page.getByRole("dialog", {name: "Join your class"})
    await expect(card.getByRole("textbox", {name: "Class code"})).toHaveValue(this.code)
    await card.getByRole("textbox", {name: "Nickname"}).fill(nickname)
    await card.getByRole("button", {name: "Join the class"}).click()
    await expect(page.getByTestId("three-words")).toBeVisible()
    const words = (await page.getByTestId("three-words").textContent()) ?? ""
    expect(words.trim().split(" ")).toHaveLength(3)
    await page.getByRole("button", {name: "I wrote them down"}).click()
    const learner = new Learner(page)
    await expect(learner.haskell()).toContainText("simulate")
    return {learner, words}
  }

  async continues(browser: Browser, words: string): Promise<Learner> {
    const page = await device(browser)
    await page.goto(`${this.address}/`)
    const card = page.getByRole("dialog", {name: "Join your class"})
    await card.getByRole("button", {name: "I joined before"}).click()
    await card.getByRole("textbox", {name: "Class code"}).fill(this.code.toUpperCase())
    await card.getByRole("textbox", {name: "Your three words"}).fill(` ${words.toUpperCase()} `)
    await card.getByRole("button", {name: "Go on with my work"}).click()
    await page.getByRole("button", {name: "I wrote them down"}).click()
    return new Learner(page)
  }
}
