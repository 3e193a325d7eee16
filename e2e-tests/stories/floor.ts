/// Floor of the room in metres: where its points are on the page, and what a pointer does there.

import type {Page} from "@playwright/test"
import {boxAtRest, drawn} from "./at_rest.ts"

/// Pixels that the page leaves free around a room (`camera.ts`).
const margin = 18

export type Place = readonly [number, number]

/// Drags by mouse from one pixel to others, and waits until the page has drawn what came of it.
export async function drags(page: Page, from: Place, ...path: readonly Place[]): Promise<void> {
  await page.mouse.move(...from)
  await page.mouse.down()
  for (const to of path) await page.mouse.move(...to)
  await page.mouse.up()
  await drawn(page)
}

/// The room's canvas, in metres: what hands do to the robot and to things.
export class Floor {
  readonly page: Page
  readonly size: Place
  constructor(page: Page, size: Place) {
    this.page = page
    this.size = size
  }

  canvas() {
    return this.page.getByRole("application", {name: /^The room/})
  }

  async pixel(x: number, y: number): Promise<Place> {
    const box = await boxAtRest(this.canvas())
    const [w, h] = this.size
    const scale = Math.min((box.width - 2 * margin) / w, (box.height - 2 * margin) / h)
    return [box.x + (box.width - w * scale) / 2 + x * scale, box.y + (box.height + h * scale) / 2 - y * scale]
  }

  async drags(from: Place, to: Place): Promise<void> {
    const middle = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2] as const
    await drags(this.page, await this.pixel(...from), await this.pixel(...middle), await this.pixel(...to))
  }
}
