/// A number or an operator is changed by one key after a run, in five programs, and the path follows: how long after the key it stands in the room.
/// For the story and for `./rosy bench simulator`.

import {expect, type Page} from "@playwright/test"
import {row} from "../bench/service.ts"
import {Learner} from "./learner.ts"

/// An example, words of its program, and the key that takes the place of their last letter: then it drives elsewhere.
const changes = [
  ["move", "Velocity 0.5 0", "1"],
  ["accelerate", "vl +", "-"],
  ["accelerateAndPlay", "vl +", "-"],
  ["randomWalk", "Velocity 0.5 0", "1"],
  ["wander", "Velocity 0.2 0", "1"],
] as const

declare global {
  interface Window {
    /// Milliseconds from the key to the picture with a preview.
    measured: Promise<number>
  }
}

/// Runs in the page, which must show no preview: measures from the next key on.
function watch(): void {
  window.measured = new Promise(done => {
    let began = 0
    const onKey = (event: KeyboardEvent) => {
      began = event.timeStamp
    }
    window.addEventListener("keydown", onKey, {capture: true, once: true})
    const watcher = new MutationObserver(() => {
      if (document.querySelector("[data-testid=preview]") === null) return
      watcher.disconnect()
      setTimeout(() => done(performance.now() - began))
    })
    watcher.observe(document.body, {subtree: true, childList: true})
  })
}

/// Makes so many edits in each of the programs, and prints a row for each.
export async function measureEdits(page: Page, edits: number, service = ""): Promise<void> {
  const learner = new Learner(page)
  const note = page.getByTestId("preview")
  for (const [name, words, key] of changes) {
    await learner.opens(name, service)
    await page.getByLabel("Speed", {exact: true}).selectOption("4")
    await learner.runsUntil("time", seconds => seconds > 3)
    await learner.stops()
    const times: number[] = []
    for (let edit = 0; edit < edits; edit++) {
      await learner.findsInHaskell(words)
      await page.keyboard.press("ArrowRight")
      await page.keyboard.press("Shift+ArrowLeft")
      await page.evaluate(watch)
      await page.keyboard.press(key)
      times.push(await page.evaluate(() => window.measured))
      await expect(note).toHaveText(/the robot would/)
      await page.keyboard.press("Control+z")
      await expect(note).toBeHidden()
    }
    row(`${name}: from a key to the path of 10 s (goal 100 ms)`, times)
  }
}
