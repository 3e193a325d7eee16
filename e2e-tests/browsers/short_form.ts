/// The short form of the first hour for browsers of other engines: a block is dragged and snaps, the robot drives, text becomes blocks.
///
/// A browser that is not installed is left out by name, with what to install.

import {existsSync} from "node:fs"
import {writeFile} from "node:fs/promises"
import {expect, test} from "@playwright/test"
import {screenshot} from "../stories/learner.ts"
import type {Browser} from "./browser.ts"
import {Hand, keyCodes, type Pointer} from "./hand.ts"

export interface Kind {
  readonly name: string
  /// The programs that it needs, and the Debian packages that hold them.
  readonly programs: readonly string[]
  readonly packages: string
  start(): Promise<Browser>
}

const pointers: readonly Pointer[] = ["mouse", "touch"]

const program = ["turning :: Velocity", "turning = Velocity 0 1", "", "main = simulate turning"]

export function shortForm({name, programs, packages, start}: Kind): void {
  const missing = programs.filter(path => !existsSync(path))
  const reason = `left out: no ${missing.join(", no ")} (apt-get install ${packages})`
  test.describe(missing.length === 0 ? name : `${name} ${reason}`, () => {
    test.skip(missing.length > 0, reason)
    let browser: Browser
    test.beforeAll(async () => {
      browser = await start()
    })
    test.afterEach(async () => {
      const info = test.info()
      if (info.status === info.expectedStatus) return
      await writeFile(info.outputPath("window.png"), await browser.picture())
    })
    test.afterAll(() => browser.closes())

    for (const pointer of pointers)
      test(`a block dragged by ${pointer} snaps, and the robot drives`, async ({baseURL}) => {
        const hand = new Hand(browser, pointer)
        await browser.opens(`${baseURL}/?example=move`)
        await expect.poll(() => hand.text("[data-testid=haskell]")).toContain("simulate")
        await hand.clicks(await hand.finds("button", "More"))
        await hand.clicks(await hand.finds("button", "New program"))
        await expect.poll(() => hand.text("[data-testid=haskell]")).not.toContain("move")
        await hand.clicks(await hand.finds(".rosySearch"))
        await hand.types("velocity")
        const value = ".blocklyFlyout .blocklyBlockCanvas > .blocklyDraggable > [aria-label^='Velocity, 0']"
        const block = await hand.findsBlock(value)
        await hand.drags(
          block,
          await hand.finds(".blocklySvg .rosyHole"),
          async () => (await hand.count(".blocklyHighlightedConnectionPathVisible")) > 0,
        )
        await expect
          .poll(() => hand.text("[data-testid=haskell]"))
          .toMatch(/main = simulate \(Velocity 0\.\d+ 0\)/)
        const before = await browser.asks(roomPicture)
        await hand.clicks(await hand.finds("[data-testid=run]"))
        await expect
          .poll(async () => Number.parseFloat(await hand.text("[data-testid=robot-speed]")))
          .toBeGreaterThan(0.1)
        await expect.poll(async () => (await browser.asks(roomPicture)) !== before).toBe(true)
        await hand.clicks(await hand.finds("[data-testid=run]"))
        await expect.poll(() => hand.text("[data-testid=run]")).toBe("Run")
      })

    test("typed text becomes blocks, and the robot turns", async ({baseURL}) => {
      const hand = new Hand(browser)
      await browser.opens(`${baseURL}/?example=move`)
      await expect.poll(() => hand.text("[data-testid=haskell]")).toContain("simulate")
      await hand.clicks(await hand.finds("[data-testid=haskell] .cm-line"))
      await hand.keys([keyCodes.Control, "a"], [keyCodes.Delete])
      for (const line of program) {
        await hand.types(line)
        await hand.keys([keyCodes.Enter])
      }
      await expect.poll(() => hand.count(".blocklySvg .blocklyBlockCanvas > .blocklyDraggable")).toBe(2)
      await hand.finds(".blocklySvg .blocklyBlockCanvas .blocklyField", "turning")
      await hand.clicks(await hand.finds("[data-testid=run]"))
      await expect
        .poll(async () => Math.abs(Number.parseFloat(await hand.text("[data-testid=robot-heading]"))))
        .toBeGreaterThan(10)
      await writeFile(screenshot(name.toLowerCase()), await browser.picture())
    })
  })
}

/// Runs in the page: what the canvas of the room shows.
function roomPicture(): string {
  return document.querySelector<HTMLCanvasElement>("canvas")?.toDataURL() ?? ""
}
