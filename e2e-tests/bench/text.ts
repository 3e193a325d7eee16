/// What typing costs in a program of 1,000 lines: from a key to its coloured text on the screen, and from a key to blocks that have followed, in a
/// real browser on the built page; beside it, from a key to the screen in a bare text area of the same text, the peer that no editor can beat.
///
/// Prints median and 95th percentile over KEYS keys. Nothing is asserted: machines differ.

import {spawn} from "node:child_process"
import {chromium, type Page} from "@playwright/test"

const KEYS = Number(process.env["ROSY_BENCH_KEYS"] ?? 40)
const root = new URL("../..", import.meta.url).pathname
const port = 20_000 + Math.floor(Math.random() * 10_000)

function row(name: string, times: readonly number[]): void {
  const sorted = [...times].sort((a, b) => a - b)
  const at = (q: number) => sorted[Math.min(sorted.length - 1, Math.floor(q * sorted.length))] ?? Number.NaN
  const numbers = `median ${at(0.5).toFixed(1).padStart(8)} ms   p95 ${at(0.95).toFixed(1).padStart(8)} ms`
  console.log(`  ${name.padEnd(58)} ${numbers}   (${times.length} keys)`)
}

/// 1,000 lines in the manner of a pupil's program.
function program(): string {
  const one = (i: number) =>
    `-- number ${i}\nmove${i} :: Velocity -> Bumper -> Maybe Velocity\nmove${i} (Velocity v w) (Bumper _ Pressed)\n` +
    `  | v > 0.${i} = Just (Velocity (v + 0.5) w)\n  | otherwise = Nothing\n\n`
  return `${Array.from({length: 166}, (_, i) => one(i)).join("")}main = simulate move0\n`
}

/// Milliseconds from each key to the frame after it. Two frames are waited for: the second is drawn after the first is on the screen.
async function keys(page: Page, key: string): Promise<number[]> {
  await page.evaluate(() => {
    const times: number[] = []
    Object.assign(window, {times})
    addEventListener(
      "keydown",
      () => {
        const began = performance.now()
        requestAnimationFrame(() => setTimeout(() => times.push(performance.now() - began)))
      },
      true,
    )
  })
  for (let i = 0; i < KEYS; i++) {
    await page.keyboard.press(key)
    await page.waitForTimeout(60)
  }
  return page.evaluate(() => (window as unknown as {times: number[]}).times)
}

const service = spawn(`${root}rosy`, ["start", "--no-browser", "--port", String(port)], {
  stdio: ["ignore", "ignore", "inherit"],
})
try {
  const address = `http://127.0.0.1:${port}/`
  for (let i = 0; i < 600; i++) {
    const up = await fetch(`${address}api/health`).then(
      () => true,
      () => false,
    )
    if (up) break
    await new Promise(resolve => setTimeout(resolve, 100))
  }
  const browser = await chromium.launch({
    executablePath: process.env["ROSY_CHROMIUM"] ?? "/usr/bin/chromium",
    args: ["--no-sandbox", "--disable-gpu"],
  })
  const page = await browser.newPage({viewport: {width: 1440, height: 900}})
  await page.goto(address)
  await page.getByTestId("haskell").filter({hasText: "simulate"}).waitFor()
  await page.getByRole("button", {name: "More", exact: true}).click()
  const [chooser] = await Promise.all([
    page.waitForEvent("filechooser"),
    page.getByRole("button", {name: "Open a file…"}).click(),
  ])
  await chooser.setFiles({name: "big.hs", mimeType: "text/plain", buffer: Buffer.from(program())})
  await page.getByTestId("haskell").filter({hasText: "number 0"}).waitFor()
  await page.locator(".cm-line").nth(0).click()
  await page.keyboard.press("End")
  row("key to coloured text, 1,000 lines", await keys(page, "x"))

  // A new definition each time, and how long until its block is there.
  const followed: number[] = []
  for (let i = 0; i < Math.max(5, KEYS / 4); i++) {
    await page.keyboard.press("Control+Home")
    const before = await page.locator(".blocklyBlockCanvas > .blocklyDraggable").count()
    await page.keyboard.insertText(`extra${i} = `)
    followed.push(
      await page.evaluate(async count => {
        const blocks = () => document.querySelectorAll(".blocklyBlockCanvas > .blocklyDraggable").length
        const began = performance.now()
        document.execCommand("insertText", false, "1\n\n")
        while (blocks() === count && performance.now() - began < 20_000)
          await new Promise(requestAnimationFrame)
        return performance.now() - began
      }, before),
    )
    await page.waitForTimeout(500)
  }
  row("key to blocks that have followed, 1,000 lines", followed)

  const bare = await browser.newPage()
  await bare.setContent("<textarea rows=40 cols=80></textarea>")
  await bare.locator("textarea").fill(program())
  await bare.locator("textarea").focus()
  row("key to the screen in a bare text area of the same text", await keys(bare, "x"))
  await browser.close()
} finally {
  service.kill("SIGTERM")
}
