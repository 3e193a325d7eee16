/// How smoothly a page shows a program think: a diagram of 60 nodes while 20 functions fire 50 times a second, in a real browser on the real service;
/// how soon a drag in it is answered; the bytes a second with values in the program and without; and how soon a click on "Why?" highlights the path of its answer.
///
/// Prints the time between two pictures and the page's own work for one, beside the same page without the diagram; a picture every 16.7 ms leaves
/// the work as many milliseconds. Nothing is asserted: machines differ.
///
/// Two busy cores: 16.7 ms between two pictures, 4.8 ms of work for one, 8.3 ms with values in the program; 36 ms of work for an answer (95 %: 81 ms;
/// the goal is an answer within 100 ms).

import type {CDPSession, Page} from "@playwright/test"
import {openFile, openPage, percentile, row, setting, withPage} from "./service.ts"

const SECONDS = setting("ROSY_BENCH_SECONDS", 10)
const QUESTIONS = setting("ROSY_BENCH_KEYS", 20)

/// Ten functions of the position, which arrives 50 times a second, each with an event that one more function takes; and one that drives.
const chains = Array.from({length: 10}, (_, i) => i + 1)
const program = `${chains
  .map(
    i => `data Count${i} = Count${i} Int

data Sum${i} = Sum${i} Double

data Moved${i} = Moved${i} Double

data Added${i} = Added${i}

move${i} :: Position -> Memory Count${i} -> (Moved${i}, Memory Count${i})
move${i} (Position x _) (Memory (Count${i} n)) = (Moved${i} x, Memory (Count${i} (n + 1)))

add${i} :: Moved${i} -> Memory Sum${i} -> (Added${i}, Memory Sum${i})
add${i} (Moved${i} x) (Memory (Sum${i} s)) = (Added${i}, Memory (Sum${i} (s + x)))
`,
  )
  .join("\n")}
drive :: Position -> Memory Count1 -> Velocity
drive _ (Memory (Count1 n))
  | even n = Velocity 0.1 0.5
  | otherwise = Velocity 0.1 0.4

main = simulate ((${chains
  .map(i => `move${i}`)
  .slice(0, 5)
  .join(", ")}), (${chains
  .map(i => `move${i}`)
  .slice(5)
  .join(", ")}), (${chains
  .map(i => `add${i}`)
  .slice(0, 5)
  .join(", ")}), (${chains
  .map(i => `add${i}`)
  .slice(5)
  .join(", ")}), drive)
`

/// Runs in the page before it: counts what arrives, and how long each picture takes.
function watch(): void {
  const seen = {bytes: 0, frames: 0, gaps: [] as number[]}
  Object.assign(window, {seen})
  const Real = window.WebSocket
  window.WebSocket = class extends Real {
    override set onmessage(handler: ((event: MessageEvent) => void) | null) {
      super.onmessage = event => {
        const text = String(event.data)
        seen.bytes += text.length
        if (text.includes('"op":"frame"')) seen.frames += 1
        handler?.(event)
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

type Seen = {bytes: number; frames: number; gaps: number[]}

/// Milliseconds of the processor that the page's main thread has taken: script, style, layout and painting. The clock is that of the thread
/// (`threadTicks`), so what other programs do meanwhile does not count.
async function worked(devtools: CDPSession): Promise<number> {
  const {metrics} = await devtools.send("Performance.getMetrics")
  return 1000 * (metrics.find(m => m.name === "TaskDuration")?.value ?? Number.NaN)
}

async function measure(page: Page, devtools: CDPSession, name: string): Promise<void> {
  const before = await worked(devtools)
  const seen = await page.evaluate(async ms => {
    const {seen} = window as unknown as {seen: Seen}
    Object.assign(seen, {bytes: 0, frames: 0, gaps: []})
    await new Promise(resolve => setTimeout(resolve, ms))
    return {...seen, gaps: [...seen.gaps]}
  }, SECONDS * 1000)
  const work = ((await worked(devtools)) - before) / seen.gaps.length
  const at = (share: number) => percentile(seen.gaps, share).toFixed(1).padStart(5)
  console.log(
    `  ${name.padEnd(44)} between two pictures median ${at(0.5)} ms   p95 ${at(0.95)} ms   work for one ${work.toFixed(1)} ms`,
  )
  console.log(
    `  ${"".padEnd(44)} ${(seen.gaps.length / SECONDS).toFixed(0)} pictures/s, ${(seen.frames / SECONDS).toFixed(0)} frames/s, ` +
      `${(seen.bytes / SECONDS / 1000).toFixed(1)} kB/s to the page`,
  )
}

/// Milliseconds from a click on "Why?" to the picture in which the path is highlighted in diagram, blocks and text.
function answered(page: Page): Promise<number> {
  return page.evaluate(
    () =>
      new Promise<number>(done => {
        const robot = document.querySelector<HTMLElement>(".robot-why")
        if (robot === null) throw new Error("expected the button that asks why, found none")
        const began = performance.now()
        robot.click()
        const look = () => {
          const all = ["svg.diagram .node.why", ".rosyWhy", ".hs-why"]
          if (all.every(one => document.querySelector(one) !== null))
            setTimeout(() => done(performance.now() - began))
          else requestAnimationFrame(look)
        }
        requestAnimationFrame(look)
      }),
  )
}

/// Closes the answer, and waits until nothing is highlighted. Playwright's own search for a button takes longer than an answer.
function closed(page: Page): Promise<void> {
  return page.evaluate(
    () =>
      new Promise<void>(done => {
        const button = document.querySelector<HTMLElement>(
          '[data-testid="why"] [aria-label="Close the answer"]',
        )
        if (button === null) throw new Error("expected the button that closes the answer, found none")
        button.click()
        const look = () => {
          if (document.querySelector(".rosyWhy, .hs-why, .node.why") === null) setTimeout(() => done())
          else requestAnimationFrame(look)
        }
        requestAnimationFrame(look)
      }),
  )
}

/// Milliseconds from each move of a pointer that drags from one node to others, one after the other, to the picture that answers it: the node that
/// follows, or the line and what the connection would be.
function dragged(page: Page): Promise<number[]> {
  return page.evaluate(async moves => {
    const nodes = [...document.querySelectorAll<SVGGElement>("svg.diagram .node.function")]
    const middle = (node: Element) => {
      const {left, top, width, height} = node.getBoundingClientRect()
      return {clientX: left + width / 2, clientY: top + height / 2}
    }
    const seen = nodes.filter(node => {
      const {clientX, clientY} = middle(node)
      return document.elementFromPoint(clientX, clientY)?.closest(".node") === node
    })
    const [first, ...others] = seen
    if (first === undefined || others.length === 0) throw new Error("expected two functions to be seen")
    const send = (to: EventTarget, type: string, at: {clientX: number; clientY: number}) =>
      to.dispatchEvent(
        new PointerEvent(type, {...at, bubbles: true, isPrimary: true, pointerId: 1, button: 0}),
      )
    const capture = Element.prototype.setPointerCapture
    // No pointer of the hardware has this number.
    Element.prototype.setPointerCapture = () => {}
    send(first, "pointerdown", middle(first))
    const times: number[] = []
    for (let i = 0; i < moves; i++) {
      const began = performance.now()
      send(window, "pointermove", middle(others[i % others.length] as Element))
      await new Promise<void>(done => requestAnimationFrame(() => setTimeout(done)))
      times.push(performance.now() - began)
    }
    window.dispatchEvent(new KeyboardEvent("keydown", {key: "Escape"}))
    Element.prototype.setPointerCapture = capture
    return times
  }, QUESTIONS)
}

await withPage(async (browser, address) => {
  const page = await openPage(browser, {viewport: {width: 1900, height: 1100}})
  await page.addInitScript(watch)
  await page.goto(`${address}?example=move`)
  await page.getByTestId("run").filter({hasText: "Run"}).waitFor()
  await openFile(page, "think.hs", program, {selector: ".cm-content", words: "move1 ::"})
  const devtools = await page.context().newCDPSession(page)
  await devtools.send("Performance.enable", {timeDomain: "threadTicks"})
  const setValues = async (shown: boolean) => {
    await page.getByRole("button", {name: "Trail, picture and film"}).click()
    await page.getByRole("checkbox", {name: "Show values in the program"}).setChecked(shown)
    await page.keyboard.press("Escape")
  }
  await page.getByTestId("run").click()
  // The readout is for screen readers, and out of sight.
  await page.getByTestId("robot-speed").filter({hasText: /[1-9]/}).waitFor({state: "attached"})
  await measure(page, devtools, "without the diagram")
  await page.getByRole("button", {name: "Diagram", exact: true}).click()
  const nodes = page.locator("svg.diagram .node")
  await nodes.first().waitFor()
  console.log(
    `  ${await nodes.count()} nodes, of which ${await page.locator("svg.diagram .node.function").count()} functions`,
  )
  await measure(page, devtools, "with the diagram")
  row("from a move of the pointer to the connection that it would be", await dragged(page))
  await page.getByRole("button", {name: "Move", exact: true}).click()
  row("from a move of the pointer to the node there", await dragged(page))
  await page.getByRole("button", {name: "Move", exact: true}).click()
  await setValues(true)
  await measure(page, devtools, "with the diagram, and values in the program")
  await page.getByRole("button", {name: "Pause", exact: true}).click()
  const [waits, works]: [number[], number[]] = [[], []]
  for (let i = 0; i < QUESTIONS; i++) {
    const before = await worked(devtools)
    waits.push(await answered(page))
    works.push((await worked(devtools)) - before)
    await closed(page)
  }
  row('from a click on "Why?" to the highlighted path', waits)
  row("the page's work for it", works)
})
