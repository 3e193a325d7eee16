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
    await expect(this.page.locator(".blocklyBlockCanvas > .blocklyDraggable").first()).toBeVisible()
    await expect(this.runButton()).toHaveText("Run")
  }

  runButton(): Locator {
    return this.page.getByTestId("run")
  }

  haskell(): Locator {
    return this.page.getByTestId("haskell")
  }

  /// The whole text, line by line, as far as it is in sight.
  async haskellText(): Promise<string> {
    const lines = await this.haskell().locator(".cm-line").allTextContents()
    return lines.join("\n").trimEnd()
  }

  /// The whole text, in sight or not, the way it comes to another program: by the clipboard.
  async wholeHaskell(): Promise<string> {
    await this.page.context().grantPermissions(["clipboard-read", "clipboard-write"])
    await this.haskell().focus()
    await this.page.keyboard.press("Control+a")
    await this.page.keyboard.press("Control+c")
    return this.page.evaluate(() => navigator.clipboard.readText())
  }

  async emptiesHaskell(): Promise<void> {
    await this.haskell().click()
    await this.page.keyboard.press("Control+a")
    await this.page.keyboard.press("Delete")
  }

  /// Types a program as somebody at the keyboard does: what the editor indents by itself is not typed again.
  async types(text: string): Promise<void> {
    for (const line of text.trimEnd().split("\n")) {
      await this.page.keyboard.type(line.trimStart())
      await this.page.keyboard.press("Enter")
    }
  }

  /// Selects the first place in the Haskell that reads so, with the editor's own search.
  async findsInHaskell(words: string): Promise<void> {
    await this.haskell().click()
    await this.page.keyboard.press("Control+Home")
    await this.page.keyboard.press("Control+f")
    const field = this.page.getByRole("textbox", {name: "Find"})
    await field.pressSequentially(words)
    await field.press("Enter")
    await field.press("Escape")
  }

  /// The block that defines a function or a type.
  definition(name: string): Locator {
    return this.page
      .locator(".blocklyBlockCanvas > .blocklyDraggable")
      .filter({has: this.page.locator(".blocklyField").getByText(name, {exact: true})})
      .first()
  }

  /// Definitions whose text is broken just now.
  dimmed(): Locator {
    return this.page.locator(".blocklyBlockCanvas .rosyDim")
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

  /// The number block that shows this number.
  number(shown: string): Locator {
    return this.page
      .locator(".blocklyBlockCanvas .blocklyField", {
        hasText: new RegExp(`^\\s*${shown.replace(".", "\\.")}\\s*$`),
      })
      .first()
  }

  async changesNumber(from: string, to: string): Promise<void> {
    await this.number(from).click()
    const input = this.page.locator(".blocklyHtmlInput")
    await input.fill(to)
    await input.press("Enter")
  }

  /// A step in the blocks of accelerateAndPlay; tells the Haskell before it and after.
  async takesAStep(): Promise<readonly [string, string]> {
    const before = await this.haskellText()
    await this.changesNumber("0.5", "0.25")
    await expect(this.haskell()).toContainText("vl + 0.25")
    return [before, await this.haskellText()]
  }

  /// Does the same again and again, and comes by these texts.
  async comesBy(act: () => Promise<void>, ...texts: readonly string[]): Promise<void> {
    for (const text of texts) {
      await act()
      await expect.poll(() => this.haskellText()).toBe(text)
    }
  }

  async deletesNumber(shown: string): Promise<void> {
    await this.number(shown).click()
    await this.page.keyboard.press("Escape")
    await this.page.keyboard.press("Delete")
  }

  /// Presses a small button on a block, by the name a screen reader says.
  async presses(label: string): Promise<void> {
    await this.page.getByRole("region", {name: "Blocks"}).getByLabel(label).first().click()
  }

  /// Chooses another word in a menu on a block.
  async chooses(shown: string, wanted: string): Promise<void> {
    await this.page.locator(".blocklyBlockCanvas .blocklyField", {hasText: shown}).first().click()
    await this.page.locator(".blocklyDropDownDiv .blocklyMenuItem", {hasText: wanted}).click()
  }

  /// Opens a file from this machine, with the page's menu.
  async opensFile(path: string): Promise<void> {
    const chooser = this.page.waitForEvent("filechooser")
    await this.page.getByRole("button", {name: "More", exact: true}).click()
    await this.page.getByText("Open a file").click()
    await (await chooser).setFiles(path)
  }

  async seesProblem(words: RegExp): Promise<void> {
    await this.page.getByRole("tab", {name: /Problems/}).click()
    await expect(this.page.getByTestId("problems")).toContainText(words)
  }

  /// A button that mends a problem.
  async seesFix(name: string): Promise<void> {
    await this.page.getByRole("tab", {name: /Problems/}).click()
    await expect(this.page.getByTestId("problems").getByRole("button", {name})).toBeVisible()
  }

  /// Blocks that wear a problem.
  wrongBlocks(): Locator {
    return this.page.locator(".blocklyBlockCanvas .rosyWrong")
  }

  async keeps(name: string): Promise<void> {
    await this.page.screenshot({path: new URL(`../screenshots/${name}.png`, import.meta.url).pathname})
  }
}

/// Waits until a number on the page satisfies a claim, if only for a frame: what it says between two looks is kept.
export async function until(value: Locator, claim: (n: number) => boolean): Promise<void> {
  await value.evaluate(sinceLook)
  await expect
    .poll(async () => (await value.evaluate(sinceLook)).some(said => claim(Number.parseFloat(said))))
    .toBe(true)
}

/// In the page: all that an element has said since the last look, and says now.
function sinceLook(element: Element & {rosySaid?: string[]}): readonly string[] {
  const now = () => element.textContent ?? ""
  if (element.rosySaid === undefined) {
    const said: string[] = []
    element.rosySaid = said
    const changes = {characterData: true, childList: true, subtree: true}
    new MutationObserver(() => said.push(now())).observe(element, changes)
  }
  return [...element.rosySaid.splice(0), now()]
}
