/// What a learner sees and does, in the page's own words. Stories speak through this and never through the page's insides.

import {fileURLToPath} from "node:url"
import {expect, type Locator, type Page} from "@playwright/test"

/// The file of a picture, for people who want to look at the pages.
export const screenshot = (name: string) =>
  fileURLToPath(new URL(`../screenshots/${name}.png`, import.meta.url))

export class Learner {
  readonly page: Page
  constructor(page: Page) {
    this.page = page
  }

  /// Opens the page with an example and waits until it can be run; of the shared service unless another is named.
  async opens(example: string, service = ""): Promise<void> {
    await this.page.goto(`${service}/?example=${example}`)
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

  /// Puts the cursor into the Haskell, which takes no keys before the first program is open.
  async entersHaskell(): Promise<void> {
    await expect(this.haskell()).toBeEditable()
    await this.haskell().click()
  }

  async emptiesHaskell(): Promise<void> {
    await this.entersHaskell()
    await this.page.keyboard.press("Control+a")
    await this.page.keyboard.press("Delete")
  }

  /// Types a program as at a keyboard: what the editor indents by itself is not typed again.
  async types(text: string): Promise<void> {
    for (const line of text.trimEnd().split("\n")) {
      await this.page.keyboard.type(line.trimStart())
      await this.page.keyboard.press("Enter")
    }
  }

  /// Selects the first place in the Haskell that reads so, with the editor's own search.
  async findsInHaskell(words: string): Promise<void> {
    await this.entersHaskell()
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

  /// Runs, and waits until a number of the readout has satisfied these claims one after the other. It is watched from before
  /// the press of Run: on a busy machine the robot may be at the wall before the story looks.
  async runsUntil(what: string, ...claims: readonly ((n: number) => boolean)[]): Promise<void> {
    const satisfied = until(this.robot(what), ...claims)
    await Promise.all([satisfied, this.runs()])
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
    const input = this.page.locator(".blocklyHtmlInput")
    // The editor of a number closes when the blocks are laid out again, as on a busy machine right after a click: it is clicked once more.
    await expect(async () => {
      await this.number(from).click({timeout: 30_000})
      await input.fill(to, {timeout: 30_000})
    }).toPass()
    // It also closes when a notice takes room from the blocks; what was typed stays.
    await expect(async () => {
      if ((await input.count()) > 0) await input.press("Enter", {timeout: 30_000})
    }).toPass()
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
    await this.page.screenshot({path: screenshot(name)})
  }
}

/// Waits until a number on the page has satisfied claims one after the other, if only for a frame: what it says between two
/// looks is kept. Values from before the call do not count; `runsUntil` is for what a run does at its beginning.
export async function until(value: Locator, ...claims: readonly ((n: number) => boolean)[]): Promise<void> {
  const call = ++calls
  const open = [...claims]
  await expect
    .poll(
      async () => {
        for (const said of await value.evaluate(sinceLook, call))
          while (open[0]?.(Number.parseFloat(said))) open.shift()
        return open.length
      },
      {intervals: [100]},
    )
    .toBe(0)
}

let calls = 0

/// In the page: all that an element has said since the last look of the same call of `until`; at the first look, what it says.
function sinceLook(element: Element & {rosySaid?: Map<number, string[]>}, call: number): readonly string[] {
  const now = () => element.textContent ?? ""
  element.rosySaid ??= new Map()
  let said = element.rosySaid.get(call)
  if (said === undefined) {
    const kept = [now()]
    element.rosySaid.set(call, kept)
    const changes = {characterData: true, childList: true, subtree: true}
    new MutationObserver(() => kept.push(now())).observe(element, changes)
    said = kept
  }
  return said.splice(0)
}
