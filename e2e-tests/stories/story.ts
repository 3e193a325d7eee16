/// Test function of the stories: Playwright's, with pages that draw at most twenty times a second. `ROSY_SLOW=4` gives the
/// pages a processor that is four times as slow, so that stories which depend on timing fail here and not on a busy machine.
/// `ROSY_LATE=2000` delays each answer of the service to a request by a random time of up to so many milliseconds, so that stories
/// which depend on the order of arrivals fail: a program or a list that comes after a click changes the page. Messages of WebSockets
/// are not delayed: passed on one by one, the frames of a run are more than a slow page can take. All of it holds for the browser contexts that a story opens by itself as well.
///
/// Without a GPU each frame is composed by the processor. At 60 frames per second this takes more than the page, the service
/// and the programs together, and no story depends on the rate. The first frame after a pause comes at once, and so do the two that a story waits for (`drawn`).

import {type Browser, type BrowserContext, test as base, expect, type Page} from "@playwright/test"
import {takeViolations, watchOrigins} from "./own_origin.ts"

/// Milliseconds between two frames.
const interval = 50

async function limitFrameRate(context: BrowserContext): Promise<void> {
  await context.addInitScript(milliseconds => {
    const request = window.requestAnimationFrame.bind(window)
    const cancel = window.cancelAnimationFrame.bind(window)
    interface Waiting {
      readonly cancel: () => void
      readonly hurry?: () => void
    }
    const waiting = new Map<number, Waiting>()
    let last = Number.NEGATIVE_INFINITY
    let lastFrame = Number.NEGATIVE_INFINITY
    /// Frames that still come without a pause: a story waits for them.
    let withoutPause = 0
    let count = 0
    window.requestAnimationFrame = callback => {
      const id = ++count
      const onFrame = (time: number): void => {
        waiting.delete(id)
        if (time > lastFrame) withoutPause = Math.max(0, withoutPause - 1)
        lastFrame = time
        last = performance.now()
        callback(time)
      }
      const requestFrame = (): void => {
        const frame = request(onFrame)
        waiting.set(id, {cancel: () => cancel(frame)})
      }
      const pause = last + milliseconds - performance.now()
      if (withoutPause > 0 || pause <= 0) requestFrame()
      else {
        const timer = setTimeout(requestFrame, pause)
        const cancelTimer = () => clearTimeout(timer)
        waiting.set(id, {
          cancel: cancelTimer,
          hurry: () => {
            cancelTimer()
            requestFrame()
          },
        })
      }
      return id
    }
    window.cancelAnimationFrame = id => {
      waiting.get(id)?.cancel()
      waiting.delete(id)
    }
    window.addEventListener("story-looks", () => {
      withoutPause = 2
      for (const {hurry} of [...waiting.values()]) hurry?.()
    })
  }, interval)
}

/// How many times slower pages compute. Chromium throttles the main thread of each page.
const slowness = Number(process.env["ROSY_SLOW"] ?? 1)

async function slowDown(page: Page): Promise<void> {
  const client = await page.context().newCDPSession(page)
  await client.send("Emulation.setCPUThrottlingRate", {rate: slowness})
}

/// The longest delay of an answer of the service, ms.
const lateness = Number(process.env["ROSY_LATE"] ?? 0)

const delay = () => Math.random() * lateness

async function delayAnswers(context: BrowserContext): Promise<void> {
  await context.route("**/api/**", async route => {
    await new Promise(resolve => setTimeout(resolve, delay()))
    // The page may have been closed meanwhile.
    await route.continue().catch(() => {})
  })
}

async function prepare(context: BrowserContext): Promise<BrowserContext> {
  await limitFrameRate(context)
  watchOrigins(context)
  if (lateness > 0) await delayAnswers(context)
  // A page that closes at once needs no throttling.
  if (slowness !== 1) context.on("page", page => void slowDown(page).catch(() => {}))
  return context
}

/// Prepares all contexts that a browser opens from now on; what is returned ends that.
export function prepareContexts(browser: Browser): () => void {
  const open = browser.newContext.bind(browser)
  browser.newContext = async options => prepare(await open(options))
  return () => {
    browser.newContext = open
  }
}

export const test = base.extend<{readonly leftContexts: void}>({
  // The context of a story is one that this opens.
  browser: [
    async ({browser}, use) => {
      const end = prepareContexts(browser)
      await use(browser)
      end()
    },
    {scope: "worker"},
  ],
  // Contexts that a story has opened by itself stay open with the browser: their pages would go on drawing, and looking for a
  // service that has ended, beside the stories that follow. None of them has asked anything of another computer.
  leftContexts: [
    async ({browser}, use) => {
      takeViolations()
      await use()
      await Promise.all(browser.contexts().map(context => context.close()))
      expect(takeViolations()).toEqual([])
    },
    {auto: true},
  ],
})
