/// Pointer and keys in a browser, by what the page shows: words, labels and blocks.

import {expect} from "@playwright/test"
import {whileFingerMoves} from "../../editor/test/long_press.ts"
import type {Browser, KeyAction, PointerAction, PointerMove} from "./browser.ts"

export interface Spot {
  readonly x: number
  readonly y: number
}

export type Pointer = "mouse" | "touch"

/// CSS pixels from the corner of a block where it is taken: on its words.
const grip = {x: 8, y: 10}

/// Code points of WebDriver for keys without a character (https://www.w3.org/TR/webdriver2/#keyboard-actions).
export const keyCodes = {Enter: "\uE007", Delete: "\uE017", Control: "\uE009", Home: "\uE011"}

export class Hand {
  readonly browser: Browser
  private readonly pointer: Pointer

  constructor(browser: Browser, pointer: Pointer = "mouse") {
    this.browser = browser
    this.pointer = pointer
  }

  /// The middle of the first visible element that a selector finds and that reads so; waits until it is there and at rest.
  async finds(selector: string, reads?: string): Promise<Spot> {
    return this.waits(`${selector} ${reads ?? ""}`, () =>
      this.browser.asks(middleOf, selector, reads ?? null),
    )
  }

  /// Where the first block that a selector finds can be taken.
  async findsBlock(selector: string): Promise<Spot> {
    return this.waits(selector, () => this.browser.asks(cornerOf, selector, grip))
  }

  async clicks(spot: Spot): Promise<void> {
    await this.acts([to(spot), {type: "pointerDown", button: 0}, {type: "pointerUp", button: 0}])
  }

  /// Takes something up and carries it to a place; `lit` says when the place shows that it takes it.
  async drags(from: Spot, place: Spot, lit: () => Promise<boolean>): Promise<void> {
    const carries: readonly PointerAction[] = [
      to(from),
      {type: "pointerDown", button: 0},
      to({x: from.x + 40, y: from.y}),
      to({x: place.x + 60, y: place.y + 40}, 200),
      to({x: place.x + grip.x, y: place.y}, 200),
    ]
    // Without a rest: a finger that rests on a block opens its menu.
    const page = {evaluate: this.browser.asks.bind(this.browser)}
    await whileFingerMoves(page, () => this.acts(carries))
    await expect.poll(lit).toBe(true)
    await this.acts([{type: "pointerUp", button: 0}])
  }

  async types(text: string): Promise<void> {
    await this.keys(...[...text].map(key => [key]))
  }

  /// Presses keys, each together with those held down before it.
  async keys(...chords: readonly (readonly string[])[]): Promise<void> {
    const actions = chords.flatMap((chord): KeyAction[] => [
      ...chord.map(value => ({type: "keyDown" as const, value})),
      ...[...chord].reverse().map(value => ({type: "keyUp" as const, value})),
    ])
    await this.browser.acts([{type: "key", id: "keys", actions}])
  }

  /// The text of the first element that a selector finds.
  text(selector: string): Promise<string> {
    return this.browser.asks(of => document.querySelector(of)?.textContent ?? "", selector)
  }

  count(selector: string): Promise<number> {
    return this.browser.asks(of => document.querySelectorAll(of).length, selector)
  }

  private async acts(actions: readonly PointerAction[]): Promise<void> {
    await this.browser.acts([
      {type: "pointer", id: this.pointer, parameters: {pointerType: this.pointer}, actions},
    ])
  }

  /// What two looks in succession find alike: it is there, and at rest.
  private async waits<T>(what: string, look: () => Promise<T | null>): Promise<T> {
    let found: T | null = null
    await expect
      .poll(
        async () => {
          const before = JSON.stringify(found)
          found = await look()
          return found !== null && JSON.stringify(found) === before
        },
        {message: `expected to see ${what}`},
      )
      .toBe(true)
    return found as T
  }
}

function to({x, y}: Spot, duration = 0): PointerMove {
  return {type: "pointerMove", x: Math.round(x), y: Math.round(y), duration}
}

/// Runs in the page.
function middleOf(selector: string, reads: string | null): Spot | null {
  for (const element of document.querySelectorAll(selector)) {
    const box = element.getBoundingClientRect()
    const text = element.textContent?.replace(/\s+/g, " ").trim()
    const isNamed = reads === null || text === reads || element.getAttribute("aria-label") === reads
    if (isNamed && box.width > 0) return {x: box.left + box.width / 2, y: box.top + box.height / 2}
  }
  return null
}

/// Runs in the page.
function cornerOf(selector: string, grip: Spot): Spot | null {
  const box = document.querySelector(selector)?.getBoundingClientRect()
  return box === undefined || box.width === 0 ? null : {x: box.left + grip.x, y: box.top + grip.y}
}
