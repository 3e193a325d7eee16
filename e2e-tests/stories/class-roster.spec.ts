/// The teacher's side of a class of thirty: a list of names beforehand, changed entries, a locked door, the overview, and a laptop whose lid is closed.

import {AxeBuilder} from "@axe-core/playwright"
import {expect} from "@playwright/test"
import {screenshot} from "./learner.ts"
import {device, RunningClass} from "./running_class.ts"
import {test} from "./story.ts"

let running: RunningClass

test.beforeEach(async () => {
  running = await RunningClass.start()
})

test.afterEach(() => running.ends())

const names = ["Ada", "Benn", "Ada Lovelace", ...Array.from({length: 27}, (_, n) => `Pupil ${n + 1}`)]

/// As the lesson editor stores it.
const draft = {
  name: "lesson-1",
  language: "en",
  title: {en: "To the ring"},
  idea: {en: "Faster goes farther."},
  learned: {en: "You have guessed."},
  room: {name: "room", size: [6, 4], start: {x: 1, y: 2}},
  start: "main = simulate (Velocity 0.1 0)\n",
  steps: [
    {
      id: "guess",
      kind: "predict",
      say: {en: "Where to?"},
      after: {},
      seconds: 10,
      checks: [],
      answers: [
        {id: "wall", text: {en: "To the wall"}, reply: {}},
        {id: "door", text: {en: "To the door"}, reply: {}},
      ],
      right: "wall",
    },
  ],
}

test("a list becomes thirty pupils, entries change, and one screen shows who needs help", async ({
  browser,
}) => {
  const teacher = await device(browser)
  await teacher.goto(running.board)
  // A list beforehand; each of it has three words.
  await teacher.getByText("Add a list of names").click()
  await teacher.getByRole("textbox", {name: "Names, one a line"}).fill(names.join("\n"))
  await teacher.getByRole("button", {name: "Add 30 names"}).click()
  await expect(teacher.getByText("30 pupils were added.")).toBeVisible()
  const card = (nickname: string) => teacher.getByTestId(`pupil ${nickname}`)
  const words = await card("Ada").locator("details", {hasText: "Three words"}).locator("p").textContent()

  // The door is locked: a stranger stays out, a pupil of the list gets in.
  await teacher.getByRole("button", {name: "Lock the door"}).click()
  await expect(teacher.getByTestId("door-locked")).toBeVisible()
  const ada = await running.continues(browser, words ?? "")
  await expect(ada.page.getByTestId("class-bar")).toContainText("Ada")
  const stranger = await device(browser)
  await stranger.goto(`${running.address}/#class=${running.code}`)
  const joining = stranger.getByRole("dialog", {name: "Join your class"})
  await joining.getByRole("textbox", {name: "Nickname"}).fill("Zoe")
  await joining.getByRole("button", {name: "Join the class"}).click()
  await expect(joining.getByRole("alert")).toContainText("The class door is locked")
  await stranger.context().close()

  // Entries are renamed, merged, removed and brought back.
  await card("Benn").getByText("Change").click()
  await card("Benn").getByRole("textbox", {name: "New name for Benn"}).fill("Ben")
  await card("Benn").getByRole("button", {name: "Rename"}).click()
  await expect(card("Ben")).toBeVisible()
  await card("Ada Lovelace").getByText("Change").click()
  await card("Ada Lovelace")
    .getByRole("combobox", {name: "Ada Lovelace is the same child as"})
    .selectOption("Ada")
  await card("Ada Lovelace").getByRole("button", {name: "Make them one"}).click()
  await expect(card("Ada Lovelace")).toHaveCount(0)
  await card("Ada").getByText("Change").click()
  await card("Ada").getByRole("button", {name: "Remove from the class"}).click()
  await card("Ada").getByRole("button", {name: "Remove this pupil"}).click()
  const removed = ada.page.getByRole("dialog", {name: "Join your class"})
  await expect(removed.getByRole("alert")).toContainText("Your teacher has taken you out of the class")
  await teacher.getByText("Removed", {exact: true}).click()
  await expect(teacher.getByTestId("roster")).toContainText(/Ada kept until .*\d.*, then deleted/)
  await teacher.getByRole("button", {name: "Bring Ada back"}).click()
  await expect(card("Ada")).toBeVisible()
  await ada.page.context().close()
  const again = await running.continues(browser, words ?? "")
  await expect(card("Ada")).toContainText("not running")

  // A lesson that the teacher has written in this browser is sent.
  await teacher.evaluate(draft => localStorage.setItem("rosy.lesson.drafts", JSON.stringify([draft])), draft)
  const sending = teacher.getByTestId("send")
  await sending.getByRole("combobox", {name: "Send"}).selectOption("A lesson")
  await sending.getByRole("combobox", {name: "Which one"}).selectOption("To the ring")
  await sending.getByRole("button", {name: "Send to all"}).click()
  await again.page.getByRole("button", {name: "Open it"}).click()
  await expect(again.page.getByRole("complementary", {name: "Lesson"})).toContainText("To the ring")
  await again.page.getByRole("button", {name: "To the wall"}).click()
  await expect(teacher.getByText("To the ring: 1 of 1")).toBeVisible()

  // The overview: nothing to scroll on a small laptop, and who needs help is first.
  await teacher.setViewportSize({width: 1366, height: 768})
  await teacher.getByRole("button", {name: "Overview"}).click()
  const tiles = teacher.getByTestId(/^tile /)
  await expect(tiles).toHaveCount(names.length - 1)
  await again.page.getByRole("button", {name: "Raise hand"}).click()
  await expect(tiles.first()).toContainText("Ada")
  await expect(tiles.first()).toContainText("Raised hand")
  await expect(tiles.last()).toBeInViewport({ratio: 1})
  const height = await teacher.evaluate(() => document.documentElement.scrollHeight)
  expect(height).toBeLessThanOrEqual(768)
  const {violations} = await new AxeBuilder({page: teacher})
    .withTags(["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"])
    .analyze()
  expect(violations.map(violation => [violation.id, violation.nodes.map(node => node.html)])).toEqual([])
  await teacher.screenshot({path: screenshot("board-overview")})
  await teacher.getByRole("button", {name: "Card of Ada"}).click()
  const opened = teacher.getByRole("dialog", {name: "Ada"})
  await opened.getByRole("button", {name: "I have seen it"}).click()
  await expect(again.page.getByRole("button", {name: "Raise hand"})).toBeVisible()
  await opened.getByRole("button", {name: "Close"}).click()
  for (const page of [again.page, teacher]) await page.context().close()
})
