/// What a learner sees and does, in the page's own words. Stories speak through this and never through the page's insides.

import {expect, type Locator, type Page} from "@playwright/test"

export class Learner {
  readonly page: Page
  constructor(page: Page) {
    this.page = page
  }

  /// Opens the page with an example and waits until it can be run.
  async opens(example: string): Promise<void> {
    await this.page.goto(`/?example=${example}`)
    await expect(this.haskell()).toContainText("simulate")
    await expect(this.runButton()).toHaveText("Run")
  }

  runButton(): Locator {
    return this.page.getByTestId("run")
  }

  haskell(): Locator {
    return this.page.getByRole("region", {name: "Haskell"}).locator(".cm-content")
  }

  status(): Locator {
    return this.page.getByRole("region", {name: "Room"}).getByRole("status")
  }

  console(): Locator {
    return this.page.getByTestId("console")
  }

  /// What the robot's readout says: `x`, `y`, `heading`, `speed`, `bumpers`, `cliffs`, `led1`, `led2`, `time`.
  robot(what: string): Locator {
    return this.page.getByTestId(`robot-${what}`)
  }

  async runs(): Promise<void> {
    await this.runButton().click()
  }

  async stops(): Promise<void> {
    await expect(this.runButton()).toHaveText("Stop")
    await this.runButton().click()
    await expect(this.runButton()).toHaveText("Run")
  }

  /// The block with this id-independent label, as a screen reader names it.
  block(name: string | RegExp): Locator {
    return this.page.getByRole("region", {name: "Blocks"}).getByLabel(name)
  }

  async keeps(name: string): Promise<void> {
    await this.page.screenshot({path: `screenshots/${name}.png`})
  }
}

/// Waits until a number on the page satisfies a claim.
export async function until(value: Locator, claim: (n: number) => boolean): Promise<void> {
  await expect.poll(async () => claim(Number.parseFloat((await value.textContent()) ?? "NaN"))).toBe(true)
}
