/// What a key costs, told apart: how long a person waits for it, and how long of that the page works.
///
/// A key is shown in the browser's next frame, which comes when the screen wants it (every 16.7 ms at 60 Hz), so a part of every wait is no work; a bare
/// text area waits as long. Both are read from the browser's own trace: the wait from the key's arrival to the picture on the screen, and the tasks of
/// the page's main thread from the key to the end of that frame.

import {setTimeout as pause} from "node:timers/promises"
import type {Browser, Page} from "@playwright/test"

/// Milliseconds from one key to the next at 80 words a minute.
const gap = 150

export interface Keys {
  /// Milliseconds from each key to the picture that shows it, as the browser tells it.
  readonly wait: readonly number[]
  /// Milliseconds that the page's main thread works from the key to the end of that frame, by the clock and by the processor.
  readonly work: readonly number[]
  readonly processor: readonly number[]
  /// Milliseconds from each key to the frame in which what follows from it is seen elsewhere.
  readonly followed: readonly number[]
  /// How many keys had what they should show, with its colour, in the first frame after them.
  readonly atOnce: number
}

export interface Looks {
  /// What the key writes into is there, in the first frame after it: `text` with the key.
  readonly shows: string
  /// Where else on the page it is seen later; nowhere if absent.
  readonly follows?: string
}

/// Presses a key `count` times at a fixed interval, without waiting for the page, as in fluent typing.
export async function typedOn(
  browser: Browser,
  page: Page,
  key: string,
  count: number,
): Promise<Pick<Keys, "wait" | "work" | "processor">> {
  await browser.startTracing(page, {
    categories: ["devtools.timeline", "disabled-by-default-devtools.timeline"],
  })
  for (let i = 0; i < count; i++) await Promise.all([page.keyboard.press(key), pause(gap)])
  return workIn(JSON.parse((await browser.stopTracing()).toString()).traceEvents, count)
}

/// Presses a key `count` times behind `text`, as a typist would, each when what the one before changed has been seen.
export async function pressed(
  browser: Browser,
  page: Page,
  key: string,
  text: (pressed: number) => string,
  count: number,
  {shows, follows}: Looks,
): Promise<Keys> {
  const followed: number[] = []
  let atOnce = 0
  await browser.startTracing(page, {
    categories: ["devtools.timeline", "disabled-by-default-devtools.timeline"],
  })
  for (let i = 1; i <= count; i++) {
    await page.evaluate(
      ([wanted, shows, follows, gap]) => {
        const holds = (selector: string, exactly: boolean) =>
          Array.from(document.querySelectorAll(selector)).some(e =>
            exactly ? e.textContent === wanted : e.textContent?.includes(wanted),
          )
        const painted = () => new Promise<void>(done => requestAnimationFrame(() => setTimeout(done)))
        const later = async (began: number) => {
          if (follows === "") return 0
          // Only what changes is looked at: looking through thousands of blocks in each frame would be work of its own.
          await new Promise<void>(done => {
            const found = (nodes: Iterable<Node>) => {
              for (const node of nodes) if (node.textContent?.includes(wanted)) return true
              return false
            }
            const observer = new MutationObserver(records => {
              if (!records.some(r => found(r.type === "characterData" ? [r.target] : r.addedNodes))) return
              observer.disconnect()
              done()
            })
            for (const there of document.querySelectorAll(follows))
              observer.observe(there, {childList: true, characterData: true, subtree: true})
          })
          await painted()
          return performance.now() - began
        }
        const typed = new Promise<{followed: number; atOnce: boolean}>((done, lost) => {
          setTimeout(
            () => lost(new Error(`expected ${follows} to follow with ${wanted}, but it did not`)),
            20_000,
          )
          addEventListener(
            "keydown",
            () => {
              const began = performance.now()
              const first = new Promise<boolean>(seen =>
                requestAnimationFrame(() => seen(holds(shows, true))),
              )
              void Promise.all([first, later(began), painted()]).then(([atOnce, followed]) =>
                setTimeout(() => done({followed, atOnce}), Math.max(0, gap - (performance.now() - began))),
              )
            },
            {capture: true, once: true},
          )
        })
        Object.assign(window, {typed})
      },
      [text(i), shows, follows ?? "", gap] as const,
    )
    await page.keyboard.press(key)
    const one = await page.evaluate(
      () => (window as unknown as {typed: Promise<{followed: number; atOnce: boolean}>}).typed,
    )
    followed.push(one.followed)
    if (one.atOnce) atOnce += 1
  }
  const trace = JSON.parse((await browser.stopTracing()).toString())
  return {...workIn(trace.traceEvents, count), followed, atOnce}
}

/// One line of Chromium's trace; times in microseconds.
interface Traced {
  readonly name: string
  readonly pid: number
  readonly tid: number
  readonly ts: number
  readonly dur?: number
  /// What of `dur` the processor was at it.
  readonly tdur?: number
  readonly args: {
    readonly data?: {
      readonly type: string
      /// Milliseconds on the page's clock: the key arrives, and its frame is handed on by the main thread.
      readonly timeStamp: number
      readonly commitFinishTime: number
      /// Milliseconds from `timeStamp` to the picture on the screen.
      readonly duration: number
    }
  }
}

/// The waits and the work of the last keys in a trace.
function workIn(events: readonly Traced[], count: number): Pick<Keys, "wait" | "work" | "processor"> {
  const tasks = events.filter(e => e.name === "RunTask")
  const keys = events.filter(e => e.name === "EventTiming" && e.args.data?.type === "keydown").slice(-count)
  const wait: number[] = []
  const work: number[] = []
  const processor: number[] = []
  for (const {ts, pid, tid, args} of keys) {
    if (args.data === undefined) continue
    const {timeStamp, commitFinishTime, duration} = args.data
    const end = ts + 1000 * (commitFinishTime - timeStamp)
    const own = tasks.filter(t => t.pid === pid && t.tid === tid && t.ts + (t.dur ?? 0) > ts && t.ts < end)
    wait.push(duration)
    work.push(own.reduce((sum, t) => sum + Math.min(end, t.ts + (t.dur ?? 0)) - Math.max(ts, t.ts), 0) / 1000)
    processor.push(own.reduce((sum, t) => sum + (t.tdur ?? 0), 0) / 1000)
  }
  return {wait, work, processor}
}
