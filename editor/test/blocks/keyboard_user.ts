/// A learner without a mouse: only keys, and what a screen reader would say about where the focus is.

import type {Page} from "playwright-core"
import {type Stage, settled} from "./browser.ts"

/// More steps than any story needs from one place of a block to another.
const patience = 80

export class Keys {
  readonly page: Page

  constructor(page: Page) {
    this.page = page
  }

  /// On a workspace with nothing but an empty `simulate`.
  static async onEmpty(stage: Stage): Promise<Keys> {
    const page = await stage.open("empty")
    await page.evaluate(() => {
      window.blocks.load(window.codegen.newWorkspace())
      window.blocks.focus()
    })
    await settled(page)
    return new Keys(page)
  }

  async press(...keys: readonly string[]): Promise<void> {
    for (const key of keys) {
      await this.page.keyboard.press(key)
      // Arrows only move the focus; a frame later Blockly has brought the block to the front, which must not
      // happen to one that has lost the focus to the next already.
      if (key.startsWith("Arrow")) await this.page.evaluate(() => new Promise(requestAnimationFrame))
      else await settled(this.page)
    }
  }

  /// What has the focus, as it is read aloud.
  heard(): Promise<string> {
    return this.page.evaluate(() => document.activeElement?.getAttribute("aria-label") ?? "")
  }

  /// T, some words, Enter: the best that is found goes to the chosen place, or stands free.
  async take(words: string): Promise<void> {
    await this.press("t")
    await this.find(words)
  }

  /// On to the next empty place, Enter, some words, Enter.
  async fill(words: string): Promise<void> {
    await this.press("e", "Enter")
    await this.find(words)
  }

  /// Words in one event, as dictation enters them: the toolbox draws what it finds after each event, so letter by letter
  /// took two thirds of a test. `view.web.test.ts` types letters.
  private async find(words: string): Promise<void> {
    await this.page.keyboard.insertText(words)
    await settled(this.page)
    await this.press("Enter")
  }

  /// Right, until something is read that sounds like `label`.
  async goTo(label: string | RegExp): Promise<void> {
    const heard: string[] = []
    for (let step = 0; step < patience; step++) {
      await this.press("ArrowRight")
      const now = await this.heard()
      if (typeof label === "string" ? now === label : label.test(now)) return
      heard.push(now)
    }
    throw new Error(`expected to come to ${label}, came by ${[...new Set(heard)].join(" / ")}`)
  }

  /// The top-level block whose label has these words.
  async choose(words: string): Promise<void> {
    await this.press("w")
    const heard: string[] = []
    for (let step = 0; step < patience; step++) {
      await this.press(step === 0 ? "ArrowDown" : "n")
      const now = await this.heard()
      // The program is read with the names of what it runs.
      if (now.includes(words) && (words === "simulate" || !now.includes("simulate"))) return
      heard.push(now)
    }
    throw new Error(`expected a stack with ${words}, heard ${[...new Set(heard)].join(" / ")}`)
  }

  /// Opens the field that has the focus, types into it, and closes it.
  async write(text: string): Promise<void> {
    await this.press("Enter")
    await this.page.keyboard.press("Control+a")
    await this.page.keyboard.type(text)
    await this.press("Enter")
  }

  haskell(): Promise<string> {
    return this.page.evaluate(() => window.codegen.toHaskell(window.blocks.save()).text)
  }
}
