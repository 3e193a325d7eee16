/// One finger on the glass, as Chromium hears a touch screen.

import type {CDPSession, Page} from "@playwright/test"
import {whileFingerMoves} from "../../editor/test/long_press.ts"
import {drawn} from "./at_rest.ts"

export interface Spot {
  readonly x: number
  readonly y: number
}

/// Movements of a drag, each a touch event.
const movements = 8

export class Finger {
  private readonly page: Page
  private readonly session: CDPSession

  private constructor(page: Page, session: CDPSession) {
    this.page = page
    this.session = session
  }

  static async on(page: Page): Promise<Finger> {
    return new Finger(page, await page.context().newCDPSession(page))
  }

  /// Takes something up and moves it a little, without a rest: a finger that rests on a block opens its menu.
  async takesUp(from: Spot): Promise<void> {
    await whileFingerMoves(this.page, async () => {
      await this.sends("touchStart", from)
      for (let step = 1; step <= movements; step++)
        await this.sends("touchMove", {x: from.x + 4 * step, y: from.y + 4 * step})
      await drawn(this.page)
    })
  }

  async movesTo(spot: Spot): Promise<void> {
    await this.sends("touchMove", spot)
    await drawn(this.page)
  }

  async letsGo(): Promise<void> {
    await this.sends("touchEnd")
    await drawn(this.page)
  }

  private async sends(type: "touchStart" | "touchMove" | "touchEnd", at?: Spot): Promise<void> {
    await this.session.send("Input.dispatchTouchEvent", {type, touchPoints: at === undefined ? [] : [at]})
  }
}
