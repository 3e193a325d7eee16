/// A learner who follows a lesson: what the lesson panel shows, and what is done there.

import {expect, type Locator} from "@playwright/test"
import {boxAtRest} from "./at_rest.ts"
import {Learner} from "./learner.ts"
import type {HandMovement} from "./lesson_files.ts"

export class Pupil extends Learner {
  panel(): Locator {
    return this.page.getByRole("complementary", {name: "Lesson", exact: true})
  }

  async opensLesson(name: string): Promise<void> {
    await this.page.goto("/")
    await expect(this.haskell()).toContainText("simulate")
    await this.choosesLesson(name)
    // Lessons take their time in seconds of the run: the clock goes faster here.
    await this.drivesAt("4")
  }

  /// Opens a lesson from the list.
  async choosesLesson(name: string): Promise<void> {
    await this.page.getByRole("button", {name: "Lessons"}).click()
    await this.page.getByRole("dialog").getByRole("button", {name}).click()
    await expect(this.panel().getByRole("heading", {name})).toBeVisible()
  }

  async drivesAt(speed: string): Promise<void> {
    await this.page.getByRole("combobox", {name: "Speed"}).selectOption(speed)
  }

  async answers(text: string): Promise<void> {
    // By its text: the name of a button with code in it has a space around the code.
    await this.panel()
      .locator(".answers button")
      .filter({hasText: new RegExp(`^${text.replace(/[.*+?^${}()|[\]\\]/g, "\\$&")}$`)})
      .click()
  }

  async goesOn(): Promise<void> {
    await this.panel().getByRole("button", {name: "Next step"}).click()
  }

  check(text: string): Locator {
    return this.panel().locator(".check", {hasText: text})
  }

  /// Runs the program, from a stand.
  async tries(): Promise<void> {
    await this.stands()
    await this.runs()
  }

  /// Stops the run if it goes on.
  async stands(): Promise<void> {
    // A run may end by itself between a look at the button and the press.
    await expect(async () => {
      if ((await this.runButton().textContent()) === "Stop") await this.runButton().click()
      await expect(this.runButton()).toHaveText("Run", {timeout: 1000})
    }).toPass()
  }

  /// Runs the program slowly, touches the robot meanwhile, and lets the rest of the `seconds` of the step pass quickly. On a busy machine
  /// the time may be over before the last touch: then it is run again.
  async triesWithHands(hands: readonly HandMovement[], seconds: number): Promise<void> {
    do {
      await this.stands()
      await this.drivesAt("0.25")
      const before = await this.clock()
      await this.runs()
      // To 0 while the program is compiled, and on from there when it runs.
      await this.clockLeaves(before)
      await this.passesTime()
      for (const hand of hands) await this.touches(hand)
    } while ((await this.clock()) >= seconds)
    await this.drivesAt("16")
  }

  private async touches({press, lift, lower}: HandMovement): Promise<void> {
    if (press !== undefined) {
      const button = this.page.getByRole("button", {name: `Press button ${press.slice(-1)} of the robot`})
      const {x, y, width, height} = await boxAtRest(button)
      await this.page.mouse.move(x + width / 2, y + height / 2)
      await this.page.mouse.down()
      await this.passesTime()
      await this.page.mouse.up()
      await this.passesTime()
    } else if (lift !== undefined || lower !== undefined) {
      await this.page.getByRole("button", {name: "Lift", exact: true}).click()
      await this.passesTime()
    }
  }

  /// Until the clock of the run has gone on: a button that is pressed and released within one step was not pressed.
  private async passesTime(): Promise<void> {
    await this.clockLeaves(await this.clock())
  }

  /// The clock of a run that is over stands, and that of the next one begins at 0.
  private async clockLeaves(time: number): Promise<void> {
    await expect.poll(() => this.clock(), {intervals: [50]}).not.toBe(time)
  }

  private async clock(): Promise<number> {
    return Number.parseFloat((await this.page.getByTestId("clock").textContent()) ?? "")
  }

  /// Replaces the program at once, as by pasting.
  async writes(program: string): Promise<void> {
    await this.emptiesHaskell()
    await this.page.keyboard.insertText(program)
  }

  /// Replaces the lines of the program that differ, with keys: those of `wanted` for those of `now`.
  async rewrites(now: string, wanted: string): Promise<void> {
    const [from, to] = [now.trimEnd().split("\n"), wanted.trimEnd().split("\n")]
    const first = from.findIndex((line, i) => line !== to[i])
    if (first === -1 && from.length === to.length) return
    const begin = first === -1 ? from.length : first
    const same = Math.min(from.length, to.length) - begin
    let last = 0
    while (last < same && from.at(-1 - last) === to.at(-1 - last)) last += 1
    const {keyboard} = this.page
    await this.entersHaskell()
    await keyboard.press("Control+Home")
    for (let line = 0; line < begin; line++) await keyboard.press("ArrowDown")
    for (let line = begin; line < from.length - last; line++) await keyboard.press("Shift+ArrowDown")
    const text = to.slice(begin, to.length - last).map(line => `${line}\n`)
    if (text.length > 0) await keyboard.insertText(text.join(""))
    else await keyboard.press("Delete")
  }
}
