/// Building by keyboard alone: keys, and what a screen reader would say about where the focus is. The mouse is never touched.

import {expect, type Page} from "@playwright/test"
import type {Hands, Of} from "./hands.ts"

/// More steps than any story needs from one place to another.
const patience = 150

interface Heard {
  /// How what has the focus is read.
  readonly label: string
  /// What the block that has the focus is called; empty when something on a block has it.
  readonly called: string
  /// The block that has the focus, or that what has it is on; and those around it.
  readonly block: string
  readonly within: readonly string[]
  /// Whether it is a socket, which is read with what it wants.
  readonly socket: boolean
}

export class Keys implements Hands {
  private readonly page: Page
  private root = ""
  private stacked = ""
  private last = ""
  /// The block whose first empty place is filled next; undefined: the next from here.
  private from: string | undefined

  constructor(page: Page) {
    this.page = page
  }

  async begins(): Promise<void> {
    await this.page.getByRole("button", {name: "More", exact: true}).focus()
    await this.press("Enter")
    await this.steps(/^New program/, "Tab")
    await this.press("Enter")
    // The focus is where the menu was.
    expect((await this.heard()).label).toBe("More")
    await expect(this.page.locator(".blocklySvg .blocklyBlockCanvas > .blocklyDraggable")).toHaveCount(1)
    await this.steps(/stack of blocks$/, "Tab")
  }

  /// From anywhere on the page into the blocks of a program that is there already.
  async enters(): Promise<void> {
    await this.page.getByRole("button", {name: "Blocks", exact: true}).focus()
    await this.press("Enter")
    const isThere = () =>
      this.page.evaluate(() => document.activeElement?.closest(".blocklySvg .blocklyWorkspace") != null)
    for (let count = 0; !(await isThere()); count++) {
      if (count > patience) throw new Error("expected to come to the blocks")
      await this.press("Tab")
    }
    await this.press("Control+Home")
  }

  async starts(found: string): Promise<void> {
    // Where nothing is chosen, what is found stands alone.
    await this.press("w")
    await this.finds("t", found)
    this.root = this.stacked = this.last = (await this.heard()).block
  }

  async takesUp(called: string): Promise<void> {
    await this.comesTo(called)
    this.from = this.root
    this.last = this.root
  }

  private async comesTo(called: string): Promise<void> {
    if ((await this.heard()).within.includes(this.root)) {
      await this.backTo(this.root)
      if (await this.walk(now => now.called === called)) {
        this.root = (await this.heard()).block
        return
      }
    }
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
    throw new Error(`expected to come to ${called}`)
  }

  async puts(...found: readonly string[]): Promise<void> {
    for (const words of found) {
      // What was thrown away has left its socket chosen.
      if (this.from !== undefined) await this.backTo(this.from)
      if (!(await this.heard()).socket) await this.press("e")
      await this.finds("Enter", words)
      this.from = undefined
      this.last = (await this.heard()).block
    }
  }

  async stacks(found: string, under?: string): Promise<void> {
    // What is found goes into the empty stack of what is chosen, or below it.
    if (under === undefined) await this.backTo(this.stacked)
    await this.finds("t", found)
    this.stacked = this.last = (await this.heard()).block
  }

  async throws(label: RegExp, of?: Of): Promise<void> {
    await this.find(label, of)
    const before = (await this.heard()).label
    await this.press("Delete")
    // From a menu on the block to the block.
    if ((await this.heard()).label === before) await this.press("Home", "Delete")
    this.from = undefined
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
    this.from = of === "last" ? this.last : this.root
    await this.backTo(this.from)
    await this.press("Shift+F10")
    await this.pick(entry)
  }

  async remarks(text: string): Promise<void> {
    await this.asks("Add Comment")
    await this.page.waitForFunction(() => document.activeElement?.matches(".blocklyBubble textarea"))
    await this.page.keyboard.insertText(text)
    await this.press("Escape")
    await this.steps(/^Close Comment/, "ArrowLeft")
    await this.press("Enter")
  }

  private async press(...keys: readonly string[]): Promise<void> {
    for (const key of keys) {
      await this.page.keyboard.press(key)
      if (process.env.LOUD) console.log(key, JSON.stringify(await this.heard()))
    }
  }

  private heard(): Promise<Heard> {
    return this.page.evaluate(() => {
      const focus = document.activeElement
      const within: string[] = []
      for (let at = focus?.closest(".blocklyDraggable"); at != null; ) {
        within.push(at.getAttribute("data-id") ?? "")
        at = at.parentElement?.closest(".blocklyDraggable") ?? null
      }
      return {
        label: focus?.getAttribute("aria-label") ?? focus?.textContent ?? "",
        called: (focus?.matches(".blocklyPath") && focus.getAttribute("aria-roledescription")) || "",
        socket: focus?.matches(".blocklyHighlightedConnectionPath") ?? false,
        block: within[0] ?? "",
        within,
      }
    })
  }

  /// A key that leads to the search, some words, and Enter: the best that is found goes to its place.
  private async finds(key: string, words: string): Promise<void> {
    const before = await this.heard()
    await this.press(key)
    await this.page.keyboard.insertText(words)
    await this.press("Enter")
    if ((await this.heard()).block === "") {
      throw new Error(`expected to find ${words} from ${before.label || before.called}`)
    }
  }

  /// Presses a key until something is read that sounds like `label`.
  private async steps(label: RegExp, key: string): Promise<void> {
    const by: string[] = []
    for (let count = 0; count < patience; count++) {
      const now = (await this.heard()).label
      if (label.test(now)) return
      by.push(now)
      await this.press(key)
    }
    throw new Error(`expected to come to ${label}, came by ${[...new Set(by)].join(" / ")}`)
  }

  /// From the block to something on it.
  private async find(label: RegExp, of?: Of): Promise<void> {
    this.from = of === "last" ? this.last : this.root
    await this.backTo(this.from)
    const by: string[] = []
    if (await this.walk(now => label.test(now.label) || by.push(now.label) === 0)) return
    throw new Error(`expected to come to ${label}, came by ${by.join(" / ")}`)
  }

  /// Onward from here, as one reads, until something is there that is wanted or nothing new comes.
  private async walk(wanted: (now: Heard) => boolean): Promise<boolean> {
    let before = ""
    const start = (await this.heard()).block
    for (let count = 0; count < patience; count++) {
      const now = await this.heard()
      if (!now.within.includes(start)) return false
      if (wanted(now)) return true
      const here = JSON.stringify(now)
      if (here === before) {
        await this.press("ArrowDown")
        if (JSON.stringify(await this.heard()) === here) return false
        before = ""
      } else {
        before = here
        await this.press("ArrowRight")
      }
    }
    return false
  }

  /// Left until the block itself has the focus.
  private async backTo(block: string): Promise<void> {
    const by: string[] = []
    for (let count = 0; count < patience; count++) {
      const now = await this.heard()
      if (now.block === block && now.called !== "") return
      by.push(now.called === "" ? now.label : now.called)
      await this.press(now.called === "" ? "Home" : "ArrowLeft")
      if (JSON.stringify(await this.heard()) === JSON.stringify(now)) await this.press("ArrowUp")
    }
    throw new Error(`expected to come back to the block, came by ${[...new Set(by)].join(" / ")}`)
  }

  /// Down the open menu to an entry, and Enter.
  private async pick(entry: string): Promise<void> {
    await this.press("Home")
    for (let count = 0; count < patience; count++) {
      const at = await this.page.evaluate(
        () => document.querySelector(".blocklyMenuItemHighlight")?.textContent ?? "",
      )
      if (at.includes(entry)) {
        await this.press("Enter")
        // Blockly carries an entry out after the next picture (contextmenu.ts); a person's next key comes later than that.
        await this.page.evaluate(
          () => new Promise(done => requestAnimationFrame(() => setTimeout(() => setTimeout(done)))),
        )
        return
      }
      await this.press("ArrowDown")
    }
    const entries = await this.page.locator(".blocklyMenuItem").allTextContents()
    throw new Error(`expected ${entry} in the menu of ${entries.join(" / ")}`)
  }
}
