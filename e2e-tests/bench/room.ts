/// How smoothly the room is drawn when there is much to draw: 30 obstacles, ten minutes of trail and three strip charts,
/// in a real browser on the real service, while a program drives. And how many bytes a second the page is sent.
///
/// Prints the time between two pictures, median and 95th percentile, and the page's own work for one. The ten minutes
/// are played to the page beforehand, frame by frame as the service writes them. Nothing is asserted: machines differ.

import type {Page} from "@playwright/test"
import {openFile, openPage, percentile, setting, withPage} from "./service.ts"

const SECONDS = setting("ROSY_BENCH_SECONDS", 10)

const world = {
  name: "thirty obstacles",
  size: [12, 9],
  start: {x: 6, y: 4.5, theta: 0.3},
  boxes: Array.from({length: 20}, (_, i) => ({
    x: 1 + (i % 5) * 2.5,
    y: [0.6, 2.6, 6.4, 8.4][Math.floor(i / 5)],
    w: 0.4,
    h: 0.3,
    theta: i * 0.4,
    movable: i % 2 === 0,
  })),
  rounds: Array.from({length: 10}, (_, i) => ({
    x: 0.7 + i * 1.15,
    y: i % 2 ? 3.4 : 5.6,
    r: 0.14,
    movable: i % 3 === 0,
  })),
}
const program =
  "drive :: Velocity -> Velocity\ndrive (Velocity v _) = Velocity (v + 0.1) 0.9\n\nmain = simulate drive\n"
const project = {
  rosy: 1,
  name: "bench",
  haskell: program,
  layout: {declarations: [], loose: []},
  world,
  settings: {},
}

/// Runs in the page before it: plays ten minutes when the first frame of a run comes, moves the rest behind them, and
/// counts what arrives and how long each picture takes.
function watch(): void {
  const earlier = 600
  const seen = {bytes: 0, frames: 0, played: false, gaps: [] as number[]}
  Object.assign(window, {seen})
  const Real = window.WebSocket
  const past = (message: {run: number}) =>
    Array.from({length: earlier * 50}, (_, step) => {
      const time = step / 50
      const x = 6 + 5 * Math.sin(time * 0.11) * Math.cos(time * 0.013)
      const y = 4.5 + 3.8 * Math.sin(time * 0.17)
      const v = 0.35 + 0.3 * Math.sin(time * 0.9)
      const still = {Cliff: [0, 0, 0], Wheel: [0, 0], Button: [0, 0, 0], Led1: [0], Led2: [0]}
      return JSON.stringify({
        op: "frame",
        run: message.run,
        step,
        time,
        pose: {x, y, theta: time},
        channels: {Velocity: [v, 0.4], Bumper: [0, step % 700 < 20 ? 1 : 0, 0], ...still},
        fired: ["drive"],
        sensed: [],
      })
    })
  window.WebSocket = class extends Real {
    override set onmessage(handler: ((event: MessageEvent) => void) | null) {
      super.onmessage = event => {
        const text = String(event.data)
        seen.bytes += text.length
        const message = JSON.parse(text)
        if (message.op !== "frame" || message.step === 0) return handler?.(event)
        seen.frames += 1
        if (!seen.played) for (const data of past(message)) handler?.(new MessageEvent("message", {data}))
        seen.played = true
        const moved = {...message, step: message.step + earlier * 50, time: message.time + earlier}
        handler?.(new MessageEvent("message", {data: JSON.stringify(moved)}))
      }
    }
  }
  let last = 0
  const beat = (now: number) => {
    if (last > 0) seen.gaps.push(now - last)
    last = now
    requestAnimationFrame(beat)
  }
  requestAnimationFrame(beat)
}

type Seen = {bytes: number; frames: number; played: boolean; gaps: number[]}

function told(times: readonly number[]): string {
  const at = (share: number) => percentile(times, share).toFixed(1).padStart(5)
  return `median ${at(0.5)} ms   p95 ${at(0.95)} ms`
}

async function measure(page: Page, name: string): Promise<void> {
  const devtools = await page.context().newCDPSession(page)
  await devtools.send("Performance.enable")
  /// Milliseconds that the page's main thread has worked since: script, style, layout and painting.
  const busy = async (): Promise<number> => {
    const {metrics} = await devtools.send("Performance.getMetrics")
    return 1000 * (metrics.find(m => m.name === "TaskDuration")?.value ?? Number.NaN)
  }
  const before = await busy()
  const seen = await page.evaluate(async ms => {
    const {seen} = window as unknown as {seen: Seen}
    Object.assign(seen, {bytes: 0, frames: 0, gaps: []})
    await new Promise(resolve => setTimeout(resolve, ms))
    return {...seen, gaps: [...seen.gaps]}
  }, SECONDS * 1000)
  const work = ((await busy()) - before) / seen.gaps.length
  await devtools.detach()
  console.log(
    `  ${name.padEnd(40)} between two pictures ${told(seen.gaps)}   work for one ${work.toFixed(1)} ms`,
  )
  console.log(
    `  ${"".padEnd(40)} ${(seen.gaps.length / SECONDS).toFixed(0)} pictures/s, ${(seen.frames / SECONDS).toFixed(0)} frames/s, ` +
      `${(seen.bytes / SECONDS / 1000).toFixed(1)} kB/s to the page`,
  )
}

await withPage(async (browser, address) => {
  const page = await openPage(browser)
  await page.addInitScript(watch)
  await page.goto(`${address}?example=move`)
  await page.getByTestId("run").filter({hasText: "Run"}).waitFor()
  await openFile(page, "bench.rosy", JSON.stringify(project), {
    selector: ".cm-content",
    words: "drive (Velocity",
  })
  await page.getByTestId("run").click()
  await page.getByRole("tab", {name: "Charts"}).click()
  await page.getByRole("button", {name: "x", exact: true}).click()
  await page.waitForFunction(() => (window as unknown as {seen: Seen}).seen.played)
  await measure(page, "all of the room, curves of 20 s")
  const menu = page.getByRole("button", {name: "Trail, picture and film"})
  const setValues = async (shown: boolean) => {
    await menu.click()
    await page.getByRole("checkbox", {name: "Show values in the program"}).setChecked(shown)
    await page.keyboard.press("Escape")
  }
  await setValues(true)
  await measure(page, "the same, values in the program")
  await setValues(false)
  await page.getByRole("button", {name: "All", exact: true}).click()
  await measure(page, "all of the room, curves of all the run")
  await menu.click()
  await page.getByRole("group", {name: "Trail"}).getByRole("button", {name: "Speed"}).click()
  await page.keyboard.press("Escape")
  await page.getByRole("button", {name: "Follow the robot"}).click()
  await measure(page, "following, trail by speed")
  if (process.env["ROSY_BENCH_PICTURE"]) await page.screenshot({path: process.env["ROSY_BENCH_PICTURE"]})
})
