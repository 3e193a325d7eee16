/// What every benchmark in a real browser needs: Rosy's service on a free port, Chromium, and a table of what was measured.
///
/// In: what to measure with a page. Out: its numbers, in rows of one form. Nothing is asserted: machines differ.

import {type ChildProcess, spawn} from "node:child_process"
import {once} from "node:events"
import {loadavg} from "node:os"
import {createInterface} from "node:readline"
import {fileURLToPath} from "node:url"
import {type Browser, type BrowserContextOptions, chromium, type Page} from "@playwright/test"
import {chromiumFlags, wholeChromium} from "../../editor/test/chromium.ts"

export const root = fileURLToPath(new URL("../..", import.meta.url))

/// A number from the environment, so that a benchmark can be asked for more or fewer.
export function setting(name: string, otherwise: number): number {
  return Number(process.env[name] ?? otherwise)
}

/// Starts the service and the browser, hands both over, and ends both whatever happens.
export async function withPage(measure: (browser: Browser, address: string) => Promise<void>): Promise<void> {
  const service = spawn(`${root}rosy`, ["start", "--no-browser", "--port", "0"], {
    stdio: ["ignore", "pipe", "inherit"],
  })
  try {
    const address = await announced(service)
    const browser = await chromium.launch({
      timeout: 0,
      executablePath: wholeChromium,
      args: chromiumFlags,
    })
    try {
      console.log(`  (Chromium ${browser.version()}; load of the machine ${loadavg()[0]?.toFixed(1)})`)
      await measure(browser, address)
    } finally {
      await browser.close()
    }
  } finally {
    const ended = once(service, "exit")
    if (service.kill("SIGTERM")) await ended
  }
}

/// A page in which nothing has a limit of time: a busy machine takes long, and `scripts/bench.py` ends what hangs.
export async function openPage(
  browser: Browser,
  options: BrowserContextOptions = {viewport: {width: 1440, height: 900}},
): Promise<Page> {
  const page = await browser.newPage(options)
  page.setDefaultTimeout(0)
  return page
}

/// The address that the service prints when it is ready.
async function announced(service: ChildProcess): Promise<string> {
  if (service.stdout === null) throw new Error("expected the service to print, found no pipe")
  const lines = createInterface(service.stdout)
  for await (const line of lines) {
    const address = /ready at (\S+)/.exec(line)?.[1]
    if (address !== undefined) {
      // What it prints from here on is discarded, and must not stop it.
      service.stdout.resume()
      return address.replace(/\/?$/, "/")
    }
  }
  throw new Error("the service ended before it was ready")
}

/// Lets a file fall onto the page. Answers the milliseconds until the frame that shows what `selector` finds with these words in it.
export function openFile(
  page: Page,
  name: string,
  text: string,
  shown: {readonly selector: string; readonly words: string},
): Promise<number> {
  return page.evaluate(
    ([name, text, selector, words]) =>
      new Promise<number>(done => {
        const dataTransfer = new DataTransfer()
        dataTransfer.items.add(new File([text], name))
        const began = performance.now()
        document.body.dispatchEvent(new DragEvent("drop", {dataTransfer, bubbles: true, cancelable: true}))
        const look = () => {
          if (document.querySelector(selector)?.textContent?.includes(words))
            setTimeout(() => done(performance.now() - began))
          else requestAnimationFrame(look)
        }
        requestAnimationFrame(look)
      }),
    [name, text, shown.selector, shown.words] as const,
  )
}

/// The value below which a share of all values lies.
export function percentile(values: readonly number[], share: number): number {
  const sorted = [...values].sort((a, b) => a - b)
  return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] ?? Number.NaN
}

const ms = (time: number) => `${time.toFixed(1).padStart(8)} ms`

/// Prints median and 95th percentile of milliseconds; what was measured once is printed once.
export function row(name: string, times: readonly number[], more = ""): void {
  const numbers =
    times.length === 1
      ? `once   ${ms(times[0] ?? Number.NaN)}`
      : `median ${ms(percentile(times, 0.5))}   p95 ${ms(percentile(times, 0.95))}   (${times.length})`
  console.log(`  ${name.padEnd(62)} ${numbers}${more === "" ? "" : `   ${more}`}`)
}
