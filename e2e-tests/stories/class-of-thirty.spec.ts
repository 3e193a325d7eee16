/// A lesson with thirty pupils: some in real browsers (two, nightly eight), the others as protocol clients. A pupil's browser and the service are killed.

import {once} from "node:events"
import {expect, type Page} from "@playwright/test"
import {isNightly} from "../../codegen/test/extent.ts"
import {screenshot} from "./learner.ts"
import {ProtocolPupil} from "./protocol_pupil.ts"
import {device, RunningClass, savedIn} from "./running_class.ts"
import {prepareContexts, test} from "./story.ts"

const pupils = 30

/// Pupils in real browsers beside Ada, whose browser is killed.
const nicknames = isNightly ? ["Ben", "Cem", "Dana", "Emil", "Fay", "Gil", "Hana"] : ["Ben"]

/// Saves of each protocol client that are reported before the service is killed.
const reported = 3

let running: RunningClass

test.beforeEach(async () => {
  running = await RunningClass.start()
})

test.afterEach(() => running.ends())

/// The cards on the board that show these words.
const cards = (board: Page, words: RegExp) => board.getByTestId(/^pupil /).filter({hasText: words})

test("thirty pupils: join, lesson, run, eyes up, hand in; a browser and the service are killed and nothing is missing", async ({
  browser,
  playwright,
  launchOptions,
}) => {
  const teacher = await device(browser)
  await teacher.goto(running.board)
  // Ada's browser is a process of its own.
  const chromium = await playwright.chromium.launchServer(launchOptions)
  const own = await playwright.chromium.connect(chromium.wsEndpoint())
  prepareContexts(own)

  // All join.
  const {learner: ada, words} = await running.joins(own, "Ada")
  const others = []
  for (const nickname of nicknames) others.push((await running.joins(browser, nickname)).learner)
  const names = Array.from({length: pupils - others.length - 1}, (_, n) => `Pupil ${n + 1}`)
  const clients = await Promise.all(names.map(nickname => ProtocolPupil.joins(running, nickname)))
  await expect(teacher.getByTestId(/^pupil /)).toHaveCount(pupils)

  // A lesson for all.
  const sending = teacher.getByTestId("send")
  await sending.getByRole("combobox", {name: "Send"}).selectOption("A lesson")
  await sending.getByRole("combobox", {name: "Which one"}).selectOption("Bump!")
  await sending.getByRole("button", {name: "Send to all"}).click()
  await expect(sending.getByText(`Sent to ${pupils} pages`)).toBeVisible()
  await Promise.all(clients.map(client => client.until(() => client.lesson === "Bump!")))
  for (const {page} of others) {
    await page.getByRole("button", {name: "Open it"}).click()
    await expect(page.getByRole("complementary", {name: "Lesson"})).toContainText("Bump!")
  }
  await ada.page.getByRole("button", {name: "Not now"}).click()
  await expect(cards(teacher, /Bump!: \d of \d/)).toHaveCount(pupils - 1)

  // Robots drive, and the board shows them.
  await Promise.all(clients.map(client => client.runs(running)))
  await ada.runs()
  await expect(
    teacher.getByTestId(/^pupil /).filter({has: teacher.getByText("running", {exact: true})}),
  ).toHaveCount(clients.length + 1)
  await expect(teacher.getByRole("img", {name: /^Room of/})).toHaveCount(pupils)
  const room = teacher.getByRole("img", {name: "Room of Pupil 1", exact: true})
  const picture = () => room.evaluate(canvas => (canvas as HTMLCanvasElement).toDataURL())
  const before = await picture()
  await expect.poll(picture).not.toBe(before)
  await teacher.screenshot({path: screenshot("board-thirty"), fullPage: true})

  // Eyes up.
  await teacher.getByRole("textbox", {name: "Message to all"}).fill("Look at me")
  await teacher.getByRole("button", {name: "Eyes up"}).click()
  for (const {page} of [ada, ...others]) await expect(page.getByTestId("eyes-up")).toHaveText("Look at me")
  await expect(ada.status()).toHaveText("Paused")
  await Promise.all(clients.map(client => client.until(() => client.attention === "Look at me")))
  await teacher.getByRole("button", {name: "Let them go on"}).click()
  for (const {page} of [ada, ...others]) await expect(page.getByTestId("eyes-up")).toHaveCount(0)
  await Promise.all(clients.map(client => client.until(() => client.attention === null)))
  await ada.stops()
  for (const client of clients) client.stops()

  // All hand in.
  await teacher.getByRole("textbox", {name: "Title of an assignment"}).fill("Drive a square")
  await teacher.getByRole("button", {name: "Open the assignment"}).click()
  await Promise.all(clients.map(client => client.handsIn()))
  for (const {page} of [ada, ...others]) {
    await page.getByRole("button", {name: "Hand in", exact: true}).click()
    await expect(page.getByTestId("class-task")).toContainText("handed in at")
  }
  const allHandedIn = `${pupils} of ${pupils} have handed in.`
  await expect(teacher.getByTestId("open-task")).toContainText(allHandedIn)
  // A card does not say both that a program was handed in and that there is none.
  await expect(teacher.getByText("no program saved yet")).toHaveCount(0)

  // Ada's browser is killed after the last letter was saved.
  await ada.changesNumber("0.5", "0.25")
  await expect(ada.haskell()).toContainText("0.25")
  await savedIn(ada)
  const text = await ada.haskellText()
  const killed = once(chromium.process(), "exit")
  chromium.process().kill("SIGKILL")
  await killed
  await expect(teacher.getByTestId("pupil Ada")).toContainText("not connected")
  const tablet = await running.continues(browser, words)
  await expect.poll(() => tablet.haskellText()).toBe(text)

  // The service is killed while the others save.
  const saving = Promise.all(clients.map(client => client.savesUntilCut()))
  await Promise.all(clients.map(client => client.until(() => client.savesReported >= reported)))
  await tablet.changesNumber("0.25", "0.75")
  await expect(tablet.haskell()).toContainText("0.75")
  await savedIn(tablet)
  await running.dies()
  await saving
  await expect(tablet.page.getByTestId("class-saved")).toContainText("No connection to the class")
  running = await running.startsAgain()
  await Promise.all(clients.map(client => client.returns(running)))
  for (const {acknowledged, sent, stored} of clients) expect([acknowledged, sent]).toContain(stored)
  const newest = await ProtocolPupil.resumes(running, words)
  expect(newest.stored).toContain("0.75")
  for (const learner of [tablet, ...others]) await savedIn(learner)
  await expect(cards(teacher, /not connected/)).toHaveCount(0)
  await expect(teacher.getByTestId("open-task")).toContainText(allHandedIn)

  for (const client of [...clients, newest]) client.leaves()
  for (const {page} of [tablet, ...others]) await page.context().close()
  await teacher.context().close()
})
