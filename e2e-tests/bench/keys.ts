/// What a key costs, told apart: how long a person waits for it, and how long of that the page works.
///
/// A key is shown in a frame of the browser: at once on a page at rest, and when the screen wants the next one (every 16.7 ms at 60 Hz) on a page that draws. Both are read
/// from the browser's own trace: the wait from the press to the picture on the screen, and the tasks of the page's main thread from the key to the end of that frame.

import {setTimeout as pause} from "node:timers/promises"
import type {Browser, Page} from "@playwright/test"

/// Not `devtools.timeline`: with it the browser counts the objects of the page at each layout, 2 ms for 29,000 of them; a bare text area has none.
const categories = ["toplevel", "benchmark", "input", "cc"]

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
  await browser.startTracing(page, {categories})
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
  await browser.startTracing(page, {categories})
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
  readonly cat: string
  readonly ph: string
  readonly pid: number
  readonly tid: number
  readonly ts: number
  readonly dur?: number
  /// What of `dur` the processor was at it.
  readonly tdur?: number
  readonly id2?: {readonly local?: string}
  readonly args: {
    readonly name?: string
    readonly event_latency?: {readonly event_type: string}
  }
}

/// A key on its way: when it was pressed, when the main thread had handed its frame on, and when that was on the screen.
interface KeyTimes {
  readonly pid: number
  readonly pressed: number
  handedOn: number
  shown: number
}

/// The keys of a trace that led to a picture.
function keysIn(events: readonly Traced[]): readonly KeyTimes[] {
  const going = new Map<string, KeyTimes>()
  const keys: KeyTimes[] = []
  const sorted = events
    .filter(e => e.id2?.local !== undefined && /\binput\b/.test(e.cat))
    .sort((a, b) => a.ts - b.ts)
  for (const {name, ph, pid, ts, id2, args} of sorted) {
    const id = `${pid} ${id2?.local}`
    const key = going.get(id)
    if (name === "EventLatency" && ph === "b") {
      going.delete(id)
      if (args.event_latency?.event_type === "KEY_PRESSED")
        going.set(id, {pid, pressed: ts, handedOn: Number.NaN, shown: Number.NaN})
    } else if (key !== undefined && name === "Commit" && ph === "e") key.handedOn = ts
    else if (key !== undefined && name === "EventLatency" && ph === "e") {
      key.shown = ts
      going.delete(id)
      if (!Number.isNaN(key.handedOn)) keys.push(key)
    }
  }
  return keys
}

/// The waits and the work of the last keys in a trace.
function workIn(events: readonly Traced[], count: number): Pick<Keys, "wait" | "work" | "processor"> {
  const keys = keysIn(events).slice(-count)
  const mains = new Map(
    events.flatMap(e =>
      e.name === "thread_name" && e.args.name === "CrRendererMain" ? [[e.pid, e.tid]] : [],
    ),
  )
  const tasks = events.filter(e => e.name === "ThreadControllerImpl::RunTask" && mains.get(e.pid) === e.tid)
  const wait: number[] = []
  const work: number[] = []
  const processor: number[] = []
  for (const {pid, pressed, handedOn, shown} of keys) {
    const own = tasks.filter(t => t.pid === pid && t.ts + (t.dur ?? 0) > pressed && t.ts < handedOn)
    const parts = own.map(t => Math.min(handedOn, t.ts + (t.dur ?? 0)) - Math.max(pressed, t.ts))
    wait.push((shown - pressed) / 1000)
    work.push(parts.reduce((sum, part) => sum + part, 0) / 1000)
    processor.push(own.reduce((sum, t) => sum + (t.tdur ?? 0), 0) / 1000)
  }
  return {wait, work, processor}
}
