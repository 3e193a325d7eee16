/// A learner drives a real robot from the page: chooses it, sees it connect, runs, watches, and stops it in every way.

import {execFileSync} from "node:child_process"
import {join} from "node:path"
import {expect} from "@playwright/test"
import {Learner, until} from "./learner.ts"
import {openRig, type Rig} from "./robot.ts"
import {root} from "./service.ts"
import {test} from "./story.ts"

const rosy = join(root, "rosy")

// One robot for all stories of this file: one at a time.
test.describe.configure({mode: "default"})

let rig: Rig
test.beforeAll(async () => {
  rig = await openRig()
})
test.afterAll(() => rig.close())

class Driver extends Learner {
  /// Opens the page with the code in its address, as the operator's terminal prints it.
  async arrives(): Promise<void> {
    await this.page.goto(rig.opened.replace("#", "?example=move#"))
    await expect(this.haskell()).toContainText("simulate")
    expect(this.page.url()).not.toContain(rig.code)
  }

  async takes(who: string): Promise<void> {
    await this.page.getByTestId("robot-choice").click()
    await this.page.getByLabel("Your name").fill(who)
    await this.page.getByRole("button", {name: "Take it: Kitchen"}).click()
    await expect(this.page.getByTestId("robot-link")).toHaveText("Connected")
  }

  async drives(): Promise<void> {
    await this.runs()
    await expect(this.status()).toHaveText("Running")
    await rig.base.says(/^control 0\.[1-9]/)
  }
}

test("chooses a robot, sees it connect, runs, watches it move, and stops it", async ({page}) => {
  const learner = new Driver(page)
  await learner.arrives()
  await learner.takes("Anna")
  await expect(page.getByTestId("robot-safety")).toHaveText("Backs off by itself")
  await learner.drives()
  await until(learner.robot("x"), x => x > 0.05)
  await until(learner.robot("speed"), v => v > 0.1)
  rig.base.ask("bump 4")
  await expect(page.getByTestId("robot-safety")).toHaveText("Backing off…")
  await expect(learner.console()).toContainText("Bumper LeftBumper Pressed")
  rig.base.ask("bump 0")
  // The program on the robot tells its firings: values in place, and why.
  await page.getByRole("button", {name: "Trail, picture and film"}).click()
  await page.getByRole("checkbox", {name: "Show values in the program"}).check()
  await page.keyboard.press("Escape")
  await expect(page.locator(".cm-line", {hasText: "move ::"}).locator(".hs-value")).toContainText(
    "Velocity 0.5 0.0",
  )
  await page.getByRole("button", {name: "Why does the robot move like this?"}).click()
  const answer = page.getByTestId("why-answer")
  await expect(answer).toContainText(/^At \d+\.\d\d s move sent Velocity 0\.5 0\.0/)
  await expect(answer).toContainText("because it runs ten times a second")
  await expect(page.locator(".rosyWhy")).toHaveCount(1)
  await learner.keeps("robot-why")
  await page.getByRole("button", {name: "Close the answer"}).click()
  await learner.definition("move").locator(".blocklyField").first().click({button: "right"})
  await page.getByRole("menuitem", {name: "Why did move run?"}).click()
  await expect(answer).toContainText(/^At \d+\.\d\d s move ran and gave Velocity 0\.5 0\.0\./)
  await page.getByRole("button", {name: "Close the answer"}).click()
  await page.getByRole("tab", {name: "Charts"}).click()
  await learner.keeps("robot")
  rig.base.ask("mark")
  await learner.stops()
  await rig.base.says(/^stood /)
  await page.getByRole("button", {name: "Let go"}).press("Enter")
  await expect(page.getByTestId("robotbar")).toHaveCount(0)
  await expect(page.getByTestId("robot-choice")).toBeFocused()
})

test("sees the simulated robot drive beside the real one, and reads what was different", async ({page}) => {
  const learner = new Driver(page)
  await learner.arrives()
  await learner.takes("Anna")
  // A worn robot: it drives a third less than it is told, and to the left.
  rig.base.ask("slip 0.67 1 0.5")
  await page.getByRole("checkbox", {name: "Simulator beside it"}).check()
  await expect(page.getByRole("button", {name: "Room to drive in: A room"})).toBeVisible()
  await learner.drives()
  await expect(page.getByRole("checkbox", {name: "Simulator beside it"})).toBeDisabled()
  await until(learner.robot("x"), x => x > 2)
  rig.base.ask("bump 4")
  await expect(learner.console()).toContainText("Bumper LeftBumper Pressed")
  rig.base.ask("bump 0")
  await page.getByRole("tab", {name: "Charts"}).click()
  await expect(page.getByTestId("compared-charts")).toHaveText(
    "Run 1, real: solid line · Run 1, simulated: dotted line",
  )
  await learner.stops()
  const note = page.getByTestId("twin-note")
  await expect(note).toHaveText(
    /^After \d+\.\d s: the real robot turned \d+° further to the (left|right), drove (\d+ cm|[\d.]+ m) less, and had its bumper pressed at \d+\.\d s, the simulated one (never|at \d+\.\d s)\.$/,
  )
  await learner.keeps("twin")
  await page.emulateMedia({colorScheme: "dark"})
  await learner.keeps("twin-dark")
  // The simulated run is looked at like any other one.
  await page.getByRole("tab", {name: "Runs"}).click()
  await page.getByRole("treeitem", {name: /Run 1, simulated/}).click()
  await expect(page.getByTestId("run-facts")).toContainText("Run 1, simulated (solid line)")
  await expect(note).toContainText("the real robot")
  rig.base.ask("slip 1 1 0")
  await page.getByRole("button", {name: "Let go"}).press("Enter")
  await expect(page.getByTestId("robotbar")).toHaveCount(0)
})

test("looks at a recorded run again, scrubs it and asks why, and opens its file in another page", async ({
  page,
  browser,
}) => {
  const learner = new Driver(page)
  await learner.arrives()
  await learner.takes("Anna")
  await learner.drives()
  await until(learner.robot("x"), x => x > 0.3)
  rig.base.ask("bump 4")
  await expect(learner.console()).toContainText("Bumper LeftBumper Pressed")
  rig.base.ask("bump 0")
  await learner.stops()
  const again = page.getByTestId("robotbar").getByRole("button", {name: "Look at this run again"})
  await expect(again).toHaveAttribute("title", /\/recordings\/.*-Kitchen\.mcap$/)
  const file = /(\/\S+\.mcap)$/.exec((await again.getAttribute("title")) ?? "")?.[1] ?? ""
  await again.click()
  await asksOfRecording(learner)
  await learner.keeps("recording")
  await page.getByRole("button", {name: "Let go"}).press("Enter")

  // Without a robot, and with another program open.
  const other = new Driver(await browser.newPage())
  await other.page.goto(rig.address)
  await expect(other.haskell()).toContainText("simulate")
  await other.page.getByRole("button", {name: "More", exact: true}).click()
  await opensFile(other, file)
  await expect(other.page.getByText("Run 1 had another program.")).toBeVisible()
  await other.page.getByRole("button", {name: "Show its program"}).click()
  await expect(other.haskell()).toContainText("move ::")
  await asksOfRecording(other)
  await other.keeps("recording-file")
  // What is no recording, is said so.
  await other.page.getByRole("tab", {name: "Runs"}).click()
  await opensFile(other, join(root, "LICENSE"))
  await expect(other.page.getByTestId("notice")).toContainText(
    "LICENSE is no recording of a run, or is damaged. Choose an .mcap file that Rosy has stored.",
  )
  await other.page.close()
})

async function opensFile(learner: Driver, file: string): Promise<void> {
  const chosen = learner.page.waitForEvent("filechooser")
  await learner.page.getByRole("button", {name: "Open a recording…"}).click()
  await (await chosen).setFiles(file)
}

/// A recording is shown: its console and path, a moment of it, and why.
async function asksOfRecording(learner: Driver): Promise<void> {
  const {page} = learner
  await page.getByRole("tab", {name: "Runs"}).click()
  const run = page.getByRole("treeitem", {name: /Run 1, recorded on the robot Kitchen/})
  await expect(run).toHaveAttribute("aria-selected", "true")
  await expect(learner.status()).toHaveText("Stopped")
  await page.getByRole("tab", {name: "Console"}).click()
  await expect(learner.console()).toContainText("Bumper LeftBumper Pressed")
  await until(learner.robot("x"), x => x > 0.2)
  const seek = page.getByRole("slider", {name: "Look back in the run"})
  await seek.press("Home")
  await until(learner.robot("x"), x => Math.abs(x) < 2)
  await expect(page.getByTestId("clock")).toHaveText(/^0\.0\d s$/)
  await seek.press("End")
  for (let n = 0; n < 20; n += 1) await seek.press("ArrowLeft")
  await page.getByRole("button", {name: "Why does the robot move like this?"}).click()
  const answer = page.getByTestId("why-answer")
  await expect(answer).toContainText(/^At \d+\.\d\d s move sent Velocity 0\.5 0\.0/)
  await expect(answer).toContainText("because it runs ten times a second")
  await expect(page.locator(".rosyWhy")).toHaveCount(1)
}

test("another page sees who has the robot, and takes it when it is free", async ({page, browser}) => {
  const learner = new Driver(page)
  await learner.arrives()
  await learner.takes("Anna")
  const other = new Driver(await browser.newPage())
  // The first program arrives after the dialog is open, which stays open.
  let arrive = () => {}
  const dialogIsOpen = new Promise<void>(resolve => {
    arrive = resolve
  })
  await other.page.route("**/api/examples/*", async route => {
    await dialogIsOpen
    await route.continue()
  })
  await other.page.goto(rig.address)
  await other.page.getByTestId("robot-choice").click()
  await expect(other.page.getByLabel("Code")).toBeVisible()
  arrive()
  await expect(other.haskell()).toContainText("simulate")
  await other.page.getByLabel("Code").fill("12345678")
  await other.page.getByRole("button", {name: "Open", exact: true}).click()
  await expect(other.page.getByRole("alert")).toContainText("not the code")
  await other.page.getByLabel("Code").fill(rig.code)
  await other.page.getByLabel("Code").press("Enter")
  await expect(other.page.getByLabel("Your name")).toBeFocused()
  const kitchen = other.page.getByTestId("robot Kitchen")
  await expect(kitchen).toContainText("Anna has it")
  await expect(kitchen.getByRole("button")).toHaveCount(0)
  await page.close()
  await expect(kitchen).toContainText("free")
  await kitchen.getByRole("button").click()
  await expect(other.page.getByTestId("robot-link")).toHaveText("Connected")
  await other.page.close()
})

test("the emergency stop works on its button, on the space bar, and from a terminal", async ({page}) => {
  const learner = new Driver(page)
  await learner.arrives()
  await learner.takes("Anna")
  const stops: readonly (() => Promise<void> | void)[] = [
    // A frightened finger presses long, and once more.
    async () => {
      await page.getByTestId("estop").hover()
      await page.mouse.down()
      await expect(page.getByTestId("robot-link")).toHaveText("It was stopped and stands.")
      await page.mouse.up()
      await page.mouse.down()
      await page.mouse.up()
    },
    () => page.keyboard.press("Space"),
    () => {
      execFileSync(rosy, ["estop"], {env: rig.environment})
    },
  ]
  for (const stop of stops) {
    await learner.drives()
    rig.base.ask("mark")
    await stop()
    await rig.base.says(/^stood /)
    await expect(page.getByTestId("robot-link")).toHaveText("It was stopped and stands.")
    await expect(learner.status()).toHaveText("Stopped")
    await page.getByRole("button", {name: "Let it drive again"}).click()
    await expect(page.getByTestId("robot-link")).toHaveText("Connected")
  }
})

test("the robot stands when the page hangs, and the emergency stop of a terminal still reaches it", async ({
  page,
}) => {
  const learner = new Driver(page)
  await learner.arrives()
  await learner.takes("Anna")
  await learner.drives()
  rig.base.ask("mark")
  // The page answers no more requests, until its tab is closed.
  void page
    .evaluate(() => {
      for (;;);
    })
    .catch(() => {})
  await rig.base.says(/^stood /)
  execFileSync(rosy, ["estop"], {env: rig.environment})
  await page.close()
})

test("the robot stands when the page is closed", async ({page}) => {
  const learner = new Driver(page)
  await learner.arrives()
  await learner.takes("Anna")
  await learner.drives()
  rig.base.ask("mark")
  await page.close()
  await rig.base.says(/^stood /)
})
