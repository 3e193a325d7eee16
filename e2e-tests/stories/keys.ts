/// Building by keyboard alone: keys, and what a screen reader would say about where the focus is. The mouse is never touched.

import type {Page} from "@playwright/test"
import type {Hands, Of} from "./hands.ts"

/// More steps than any story needs from one place to another.
const patience = 120

interface Heard {
  readonly label: string
  /// What the block with the focus, or the one that the focus is on, is called, and which it is.
  readonly called: string
  readonly block: string
}

export class Keys implements Hands {
  private readonly page: Page
  private root = ""
  private stacked = ""
  private last = ""

  constructor(page: Page) {
    this.page = page
  }

  async begins(): Promise<void> {
    await this.page.getByRole("button", {name: "More", exact: true}).focus()
    await this.press("Enter")
    await this.tabTo(/^New program/)
    await this.press("Enter")
    await this.tabTo(/stack of blocks$/)
  }

  async starts(found: string): Promise<void> {
    await this.finds(found)
    this.root = this.stacked = this.last = (await this.heard()).block
  }

  async takesUp(called: string): Promise<void> {
    await this.press("w", "ArrowDown")
    const tops = new Set<string>()
    for (let step = 0; step < patience; step++) {
      const now = await this.heard()
      if (now.called === called) {
        this.root = now.block
        return
      }
      if (tops.has(now.block)) break
      tops.add(now.block)
      await this.press("n")
    }
    // Inside another: the last that reads so.
    throw new Error(`expected to come to ${called}`)
  }

  async puts(...found: readonly string[]): Promise<void> {
    for (const words of found) {
      await this.press("e")
      await this.finds(words)
      this.last = (await this.heard()).block
    }
  }

  async stacks(found: string, under?: string): Promise<void> {
    if (under === undefined) await this.backTo(this.stacked)
    else await this.goTo(/steps|definitions/, () => this.press("e"))
    await this.finds(found)
    this.stacked = this.last = (await this.heard()).block
  }

  async throws(label: RegExp, of?: Of): Promise<void> {
    await this.find(label, of)
    await this.press("Delete")
  }

  async writes(label: RegExp, text: string, of?: Of): Promise<void> {
    await this.find(label, of)
    await this.press("Enter", "Control+a")
    await this.page.keyboard.insertText(text)
    await this.press("Enter")
  }

  async chooses(label: RegExp, option: string, of?: Of): Promise<void> {
    await this.find(label, of)
    await this.press("Enter")
    await this.pick(option)
  }

  async presses(label: RegExp, times = 1, of?: Of): Promise<void> {
    await this.find(label, of)
    for (let time = 0; time < times; time++) await this.press("Enter")
  }

  async asks(entry: string, of?: Of): Promise<void> {
    await this.backTo(of === "last" ? this.last : this.root)
    await this.press("Shift+F10")
    await this.pick(entry)
  }

  async remarks(text: string): Promise<void> {
    await this.asks("Add Comment")
    await this.page.keyboard.insertText(text)
    await this.press("Escape", "Escape")
  }

  private async press(...keys: readonly string[]): Promise<void> {
    for (const key of keys) {
      await this.page.keyboard.press(key)
      await this.drawn()
    }
  }

  private drawn(): Promise<void> {
    return this.page.evaluate(
      () => new Promise<void>(done => requestAnimationFrame(() => requestAnimationFrame(() => done()))),
    )
  }

  private heard(): Promise<Heard> {
    return this.page.evaluate(() => {
      const focus = document.activeElement
      const block = focus?.closest(".blocklyDraggable")
      return {
        label: focus?.getAttribute("aria-label") ?? focus?.textContent ?? "",
        called: focus?.getAttribute("aria-roledescription") ?? "",
        block: block?.getAttribute("data-id") ?? "",
      }
    })
  }

  /// T, some words, and the first block found; it goes to the chosen place, or stands free.
  private async finds(words: string): Promise<void> {
    await this.press("t")
    await this.page.keyboard.insertText(words)
    await this.press("Enter", "Enter", "Enter")
  }

  /// Steps until something is read that sounds like `label`.
  private async goTo(label: RegExp, step: () => Promise<void>): Promise<void> {
    const by: string[] = []
    for (let count = 0; count < patience; count++) {
      const now = (await this.heard()).label
      if (label.test(now)) return
      by.push(now)
      await step()
    }
    throw new Error(`expected to come to ${label}, came by ${[...new Set(by)].join(" / ")}`)
  }

  private async find(label: RegExp, of?: Of): Promise<void> {
    await this.backTo(of === "last" ? this.last : this.root)
    await this.goTo(label, () => this.press("ArrowRight"))
  }

  private async tabTo(label: RegExp): Promise<void> {
    await this.goTo(label, () => this.press("Tab"))
  }

  /// Left until the block itself has the focus.
  private async backTo(block: string): Promise<void> {
    for (let count = 0; count < patience; count++) {
      const now = await this.heard()
      if (now.block === block && now.called !== "") return
      await this.press("ArrowLeft")
    }
    throw new Error("expected to come back to the block")
  }

  /// Down the open menu to an entry, and Enter.
  private async pick(entry: string): Promise<void> {
    for (let count = 0; count < patience; count++) {
      const at = await this.page.evaluate(
        () => document.querySelector(".blocklyMenuItemHighlight")?.textContent ?? "",
      )
      if (at.includes(entry)) {
        await this.press("Enter")
        return
      }
      await this.press("ArrowDown")
    }
    throw new Error(`expected ${entry} in the menu, at ${JSON.stringify(await this.heard())}: ${await this.page.evaluate(() => document.querySelector(".blocklyMenu")?.textContent)}`)
  }
}
