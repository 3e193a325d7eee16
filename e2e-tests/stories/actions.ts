/// A learner who builds a small program with as few actions as possible, by mouse, touch or keyboard. Every press, tap, key and typed word is one action.

import {expect, type Locator, type Page} from "@playwright/test"
import {atRest, boxAtRest, drawn} from "./at_rest.ts"
import {Learner} from "./learner.ts"

export type Input = "mouse" | "touch" | "keyboard"

/// Pixels from the corner of a block where it is pressed: on its words.
const grip = {x: 8, y: 10}

/// More steps than a small program has parts.
const patience = 40

export class Builder {
  readonly learner: Learner
  readonly page: Page
  /// Since the empty program was opened.
  actions = 0
  private readonly input: Input

  constructor(page: Page, input: Input) {
    this.page = page
    this.input = input
    this.learner = new Learner(page)
  }

  /// An empty program; the keyboard is on its only block.
  async begins(): Promise<void> {
    await this.learner.opens("move")
    await this.page.getByRole("button", {name: "More", exact: true}).click()
    await this.page.getByText("New program").click()
    await expect(this.blocks()).toHaveCount(1)
    if (this.input === "keyboard")
      await this.blocks().first().locator("> .blocklyPath").click({position: grip})
    this.actions = 0
  }

  /// Chooses the next empty place and has what fits there offered, unless it is already.
  async offers(): Promise<void> {
    if (this.input !== "keyboard" && (await this.isOffered())) return
    if (this.input === "keyboard") {
      // After Shift+Enter the search goes on for the next empty place.
      if (!(await this.isSearching())) await this.keys("f")
      await expect(this.page.locator(".blocklyFlyout").getByText("Fits here")).toBeVisible()
    } else {
      await this.presses(this.page.locator(".blocklySvg .rosyHole").first())
    }
    await drawn(this.page)
  }

  /// Opens a category of the toolbox. Keys search in all of them.
  async drawer(name: string): Promise<void> {
    if (this.input === "keyboard") {
      return (await this.isSearching()) ? undefined : this.keys("t")
    }
    await this.presses(this.page.locator(".blocklyToolbox").getByText(name, {exact: true}))
    await drawn(this.page)
  }

  /// Takes a block that is offered, where it is in sight; else it is searched for by these words. By keyboard the first one that is offered needs no words; `next`: the
  /// search goes on for the next empty place.
  async takes(called: RegExp, words: string, next = false): Promise<void> {
    const before = await this.page.locator(".blocklySvg .blocklyBlockCanvas .blocklyDraggable").count()
    const offered = this.page
      .locator(".blocklyFlyout .blocklyBlockCanvas > .blocklyDraggable > .blocklyPath")
      .and(this.page.getByLabel(called))
      .first()
    if (this.input === "keyboard") {
      if (!(await this.isFirst(offered))) await this.types(words)
      await this.keys(next ? "Shift+Enter" : "Enter")
    } else {
      if (!(await this.isInSight(offered))) {
        if (this.input === "touch") await this.presses(this.page.locator(".rosySearch"))
        await this.types(words)
      }
      await this.presses(offered, grip)
    }
    await expect
      .poll(() => this.page.locator(".blocklySvg .blocklyBlockCanvas .blocklyDraggable").count())
      .toBeGreaterThan(before)
    await drawn(this.page)
  }

  /// Presses a small button on a block.
  async grows(label: string): Promise<void> {
    if (this.input === "keyboard") {
      if (label === "run one more") return this.keys("r")
      // The program's first stack is the one that runs the others.
      await this.keys("Control+Home")
      await this.walksTo(new RegExp(`^${label}`))
      return this.keys("Enter")
    }
    await this.presses(this.page.locator(".blocklySvg").getByLabel(label).first())
    await drawn(this.page)
  }

  /// Writes into the last field with this label.
  async writes(label: RegExp, text: string): Promise<void> {
    if (this.input === "keyboard") {
      // A number is typed where it stands.
      await this.walksTo(label, "v")
      await this.page.keyboard.type(text)
    } else {
      await this.presses(this.page.locator(".blocklySvg").getByLabel(label).last())
      await this.page.locator(".blocklyHtmlInput").fill(text)
    }
    await this.page.keyboard.press("Enter")
    this.actions += 1
    await drawn(this.page)
  }

  /// Presses a button of the page.
  async clicks(button: Locator): Promise<void> {
    if (this.input === "keyboard") {
      // Tab leads there; how often depends on what else is on the page.
      await button.focus()
      await this.keys("Enter")
    } else {
      // A long list is scrolled with the wheel or the finger.
      await button.scrollIntoViewIfNeeded()
      await this.presses(button)
    }
  }

  async runs(): Promise<void> {
    if (this.input === "keyboard") await this.keys("Control+Enter")
    else await this.presses(this.learner.runButton())
  }

  /// From one part of the blocks to the next, as one reads, up to the one with this label; `key` leads on.
  private async walksTo(label: RegExp, key = "ArrowRight"): Promise<void> {
    const by: string[] = []
    for (let step = 0; step < patience; step++) {
      const heard = await this.page.evaluate(() => document.activeElement?.getAttribute("aria-label") ?? "")
      if (label.test(heard)) return
      by.push(heard)
      await this.keys(heard !== "" && heard === by.at(-2) ? "ArrowDown" : key)
    }
    throw new Error(`expected to come to ${label}, came by ${by.join(" / ")}`)
  }

  private async presses(target: Locator, position?: {readonly x: number; readonly y: number}): Promise<void> {
    const box = await boxAtRest(target)
    const at = position ?? {x: Math.min(box.width / 2, 30), y: box.height / 2}
    if (this.input === "touch") await this.page.touchscreen.tap(box.x + at.x, box.y + at.y)
    else await this.page.mouse.click(box.x + at.x, box.y + at.y)
    this.actions += 1
  }

  private async keys(...keys: readonly string[]): Promise<void> {
    for (const key of keys) await this.page.keyboard.press(key)
    this.actions += keys.length
  }

  private async types(words: string): Promise<void> {
    await this.page.keyboard.insertText(words)
    this.actions += 1
    await drawn(this.page)
  }

  private blocks(): Locator {
    return this.page.locator(".blocklySvg .blocklyBlockCanvas > .blocklyDraggable")
  }

  private isSearching(): Promise<boolean> {
    return this.page.locator(".rosySearch").evaluate(field => field === document.activeElement)
  }

  private isOffered(): Promise<boolean> {
    return this.page.locator(".blocklyFlyout").getByText("Fits here").isVisible()
  }

  /// Whether a block is the first of those that are offered.
  private async isFirst(block: Locator): Promise<boolean> {
    if ((await block.count()) === 0) return false
    const top = await block.evaluate(path => path.getBoundingClientRect().top)
    const tops = await this.page
      .locator(".blocklyFlyout .blocklyBlockCanvas > .blocklyDraggable > .blocklyPath")
      .evaluateAll(paths => paths.map(path => path.getBoundingClientRect().top))
    return top <= Math.min(...tops)
  }

  /// Whether the place where a hand presses is in the window.
  private async isInSight(block: Locator): Promise<boolean> {
    if ((await block.count()) === 0) return false
    const box = await atRest(this.page, () => block.boundingBox())
    const height = this.page.viewportSize()?.height ?? 0
    return box !== null && box.y > 0 && box.y + 2 * grip.y < height
  }
}
