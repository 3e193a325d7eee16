/// Presses, drags and types at random places: the page never breaks, and a reload keeps what came of it.
/// `./rosy test nightly` plays twice as many. `SEEDS=1,2,3 GESTURES=300` plays others, for longer; the seed is in the story's name.

import {expect, type Page} from "@playwright/test"
import {isNightly} from "../../codegen/test/extent.ts"
import {atRest} from "./at_rest.ts"
import {Learner} from "./learner.ts"
import {test} from "./story.ts"

const given = process.env["SEEDS"]
const seeds = given === undefined ? [8, 12] : given.split(",").map(Number)
const gestures = Number(process.env["GESTURES"] ?? (isNightly ? 120 : 60))
const programs = ["drawSquare", "mux", "randomWalk", "accelerateAndPlay", "safeRandomWalk", "move"]

// Keys that mean something in the blocks, in the text, or in both.
const keys =
  "Tab Shift+Tab Enter Escape Space ArrowDown ArrowRight ArrowUp ArrowLeft Delete Backspace Control+z Control+y Control+c Control+v Control+x Control+d Control+a Control+f Control+Space F2 a 5 / m t w i".split(
    " ",
  )
const typed = ["play x = 1\n", "where", "(", "foo", "-- hi\n", "data A = A Int", "1.5"]

/// Below the bar at the top and left of the room: toolbox, blocks and Haskell. Pixels of the page.
const hands = {left: 0, top: 60, right: 1020, bottom: 900}

/// Numbers below `n`, the same for the same seed (mulberry32).
function chance(seed: number): (n: number) => number {
  let state = Math.imul(seed, 2654435761)
  return n => {
    state = (state + 0x6d2b79f5) | 0
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state)
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed
    return Math.floor((((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32) * n)
  }
}

function carelessly(page: Page, pick: (n: number) => number): () => Promise<string> {
  const spot = (): [number, number] => [
    hands.left + pick(hands.right - hands.left),
    hands.top + pick(hands.bottom - hands.top),
  ]
  return async () => {
    const kind = pick(10)
    const [x, y] = spot()
    if (kind < 3) {
      await page.mouse.click(x, y, {button: pick(8) === 0 ? "right" : "left"})
      return `press ${x},${y}`
    }
    if (kind < 5) {
      const [toX, toY] = spot()
      await page.mouse.move(x, y)
      await page.mouse.down()
      await page.mouse.move(toX, toY, {steps: 6})
      await page.mouse.up()
      return `drag ${x},${y} to ${toX},${toY}`
    }
    if (kind < 9) {
      const key = keys[pick(keys.length)]!
      await page.keyboard.press(key)
      return key
    }
    const words = typed[pick(typed.length)]!
    await page.keyboard.type(words)
    return `type ${words.trim()}`
  }
}

for (const seed of seeds) {
  test(`careless hands break nothing, and a reload keeps what they made (seed ${seed})`, async ({page}) => {
    // Longer ones take longer than a story may.
    test.setTimeout(Math.max(test.info().timeout, 240_000 + gestures * 1600))
    const learner = new Learner(page)
    const broken: string[] = []
    const done: string[] = []
    const remember = (what: string) => broken.push(`${what}\nafter: ${done.slice(-12).join(" | ")}`)
    page.on("pageerror", error => remember(error.stack ?? error.message))
    page.on("console", line => {
      if (line.type() === "error") remember(line.text())
    })
    await learner.opens(programs[seed % programs.length]!)
    const careless = carelessly(page, chance(seed))
    for (let i = 0; i < gestures && broken.length === 0; i++) done.push(await careless())
    expect(broken).toEqual([])

    await page.keyboard.press("Escape")
    await expect(page.getByTestId("saved")).toHaveText("saved")
    // The last change of the blocks may not be in the text yet.
    const text = await atRest(page, () => learner.wholeHaskell())
    await page.reload()
    await expect(learner.runButton()).toBeVisible()
    await expect.poll(() => learner.wholeHaskell()).toBe(text)
    expect(broken).toEqual([])
  })
}
