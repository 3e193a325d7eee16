/// What typing costs in a program of 1,000 lines, in a real browser on the built page: until it is open, from a key to its coloured text on the
/// screen, and from a key to blocks that have followed; beside it, from a key to the screen in a bare text area of the same text, the peer that no
/// editor can beat.
///
/// Prints median and 95th percentile over KEYS keys. Nothing is asserted: machines differ. Nothing waits for time to pass: each key waits until
/// what it does is seen, and then as long again as a quick typist's next key would.

import {spawn} from "node:child_process"
import {type Browser, chromium, type Page} from "@playwright/test"

const KEYS = Number(process.env["ROSY_BENCH_KEYS"] ?? 40)
/// Milliseconds from one key to the next of somebody who types 80 words a minute.
const GAP = 150
const root = new URL("../..", import.meta.url).pathname
const port = 20_000 + Math.floor(Math.random() * 10_000)

function row(name: string, times: readonly number[]): void {
  const sorted = [...times].sort((a, b) => a - b)
  const at = (q: number) => sorted[Math.min(sorted.length - 1, Math.floor(q * sorted.length))] ?? Number.NaN
  const numbers = `median ${at(0.5).toFixed(1).padStart(8)} ms   p95 ${at(0.95).toFixed(1).padStart(8)} ms`
  console.log(`  ${name.padEnd(58)} ${numbers}   (${times.length})`)
}

/// 1,000 lines in the manner of a pupil's program.
function program(): string {
  const one = (i: number) =>
    `-- number ${i}\nmove${i} :: Velocity -> Bumper -> Maybe Velocity\nmove${i} (Velocity v w) (Bumper _ Pressed)\n` +
    `  | v > 0.${i} = Just (Velocity (v + 0.5) w)\n  | otherwise = Nothing\n\n`
  return `${Array.from({length: 166}, (_, i) => one(i)).join("")}main = simulate move0\n`
}

interface Once {
  readonly shown: number
  readonly followed: number
}

interface Typed {
  /// Milliseconds from a key to the frame that shows it.
  readonly shown: number[]
  /// Milliseconds from a key until what it changes elsewhere was seen.
  readonly followed: number[]
}

/// Presses a key again and again. `follows` finds what changes elsewhere on the page: its text is another one when the key has arrived there.
async function type(page: Page, key: string, follows: string): Promise<Typed> {
  const typed: Typed = {shown: [], followed: []}
  for (let i = 0; i < KEYS; i++) {
    await page.evaluate(
      ([selector, gap]) => {
        const look = () =>
          Array.from(document.querySelectorAll<HTMLElement>(selector))
            .map(e => (e instanceof HTMLTextAreaElement ? e.value.length : e.textContent))
            .join(" ")
        const before = look()
        const pressed = () =>
          new Promise<{shown: number; followed: number}>(done => {
            const began = performance.now()
            let shown = 0
            requestAnimationFrame(() =>
              setTimeout(() => {
                shown = performance.now() - began
              }),
            )
            const again = () => {
              const took = performance.now() - began
              if (look() === before && took < 20_000) requestAnimationFrame(again)
              else setTimeout(() => done({shown, followed: took}), Math.max(0, gap - took))
            }
            requestAnimationFrame(again)
          })
        const typed = new Promise<{shown: number; followed: number}>(done =>
          addEventListener("keydown", () => void pressed().then(done), {capture: true, once: true}),
        )
        Object.assign(window, {typed})
      },
      [follows, GAP] as const,
    )
    await page.keyboard.press(key)
    const {shown, followed} = await page.evaluate(() => (window as unknown as {typed: Promise<Once>}).typed)
    typed.shown.push(shown)
    typed.followed.push(followed)
  }
  return typed
}

async function answers(address: string): Promise<void> {
  for (;;) {
    const up = await fetch(`${address}api/health`).then(
      () => true,
      () => false,
    )
    if (up) return
    await new Promise(resolve => setTimeout(resolve, 100))
  }
}

async function opened(browser: Browser, address: string): Promise<Page> {
  const page = await browser.newPage({viewport: {width: 1440, height: 900}})
  await page.goto(address)
  await page.getByTestId("haskell").filter({hasText: "simulate"}).waitFor()
  await page.getByRole("button", {name: "More", exact: true}).click()
  const [chooser] = await Promise.all([
    page.waitForEvent("filechooser"),
    page.getByText("Open a file").click(),
  ])
  const began = performance.now()
  await chooser.setFiles({name: "big.hs", mimeType: "text/plain", buffer: Buffer.from(program())})
  await page
    .locator(".blocklyBlockCanvas > .blocklyDraggable")
    .filter({hasText: "move0"})
    .first()
    .waitFor({state: "attached"})
  row("a file of 1,000 lines, until its blocks are there", [performance.now() - began])
  return page
}

const service = spawn(`${root}rosy`, ["start", "--no-browser", "--port", String(port)], {
  stdio: ["ignore", "ignore", "inherit"],
})
try {
  const address = `http://127.0.0.1:${port}/`
  await answers(address)
  const browser = await chromium.launch({
    executablePath: process.env["ROSY_CHROMIUM"] ?? "/usr/bin/chromium",
    args: ["--no-sandbox", "--disable-gpu"],
  })
  const page = await opened(browser, address)
  // A digit behind the number in the first condition: its block says the same number.
  await page.locator(".cm-line").filter({hasText: "Velocity (v + 0.5) w"}).first().click()
  await page.keyboard.press("Home")
  for (let i = 0; i < "  | v > 0.".length; i++) await page.keyboard.press("ArrowRight")
  const typed = await type(page, "1", ".blocklyBlockCanvas .rosyEntry")
  row("key to coloured text, 1,000 lines", typed.shown)
  row("key to blocks that have followed, 1,000 lines", typed.followed)

  const bare = await browser.newPage()
  await bare.setContent("<textarea rows=40 cols=80></textarea>")
  await bare.locator("textarea").fill(program())
  await bare.locator("textarea").focus()
  row("key to the screen in a bare text area of the same text", (await type(bare, "x", "textarea")).shown)
  await browser.close()
} finally {
  service.kill("SIGTERM")
}
