/// How long from pressing Run to a robot that has moved, in a real browser on the real service; and beside it, in the same run, how long `runghc` and
/// `ghc -O0` need for the same program before it does anything.
///
/// Prints median and 95th percentile over RUNS runs. A frame counts when the page has been told of a pose other than the start's. Nothing is asserted: machines differ.

import {execFileSync, spawn} from "node:child_process"
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs"
import {tmpdir} from "node:os"
import {join} from "node:path"
import {chromium} from "@playwright/test"

const RUNS = Number(process.env["ROSY_BENCH_RUNS"] ?? 50)
const root = new URL("../..", import.meta.url).pathname
const port = 20_000 + Math.floor(Math.random() * 10_000)

function row(name: string, times: readonly number[]): void {
  const sorted = [...times].sort((a, b) => a - b)
  const at = (q: number) => sorted[Math.min(sorted.length - 1, Math.floor(q * sorted.length))] ?? Number.NaN
  console.log(
    `  ${name.padEnd(58)} median ${at(0.5).toFixed(1).padStart(8)} ms   p95 ${at(0.95).toFixed(1).padStart(8)} ms   (${times.length} runs)`,
  )
}

async function answers(url: string): Promise<void> {
  for (let i = 0; i < 600; i++) {
    try {
      const health = (await (await fetch(url)).json()) as {worker: string}
      if (health.worker === "ready") return
    } catch {
      // Not listening yet.
    }
    await new Promise(resolve => setTimeout(resolve, 100))
  }
  throw new Error("the service did not start")
}

const service = spawn(`${root}rosy`, ["start", "--no-browser", "--port", String(port)], {
  stdio: ["ignore", "ignore", "inherit"],
})
try {
  await answers(`http://127.0.0.1:${port}/api/health`)
  const browser = await chromium.launch({
    executablePath: process.env["ROSY_CHROMIUM"] ?? "/usr/bin/chromium",
    args: ["--no-sandbox", "--disable-gpu"],
  })
  const page = await browser.newPage({viewport: {width: 1440, height: 900}})
  // Listens to the page's own socket from the moment it opens.
  await page.addInitScript(() => {
    const Real = window.WebSocket
    const seen = {running: 0, moved: 0, startX: Number.NaN}
    Object.assign(window, {seen})
    window.WebSocket = class extends Real {
      constructor(url: string | URL, protocols?: string | string[]) {
        super(url, protocols)
        this.addEventListener("message", event => {
          const m = JSON.parse(String(event.data))
          if (m.op === "state" && m.state === "running" && seen.running === 0)
            seen.running = performance.now()
          if (m.op === "frame" && seen.moved === 0 && m.v !== 0 && m.step > 0) seen.moved = performance.now()
        })
      }
    }
  })
  await page.goto(`http://127.0.0.1:${port}/?example=accelerate`)
  const run = page.getByTestId("run")
  await run.filter({hasText: "Run"}).waitFor()
  const running: number[] = []
  const moved: number[] = []
  for (let i = 0; i < RUNS; i++) {
    const times = await page.evaluate(async () => {
      const seen = (window as unknown as {seen: {running: number; moved: number}}).seen
      seen.running = 0
      seen.moved = 0
      const began = performance.now()
      ;(document.querySelector("[data-testid=run]") as HTMLElement).click()
      while (seen.moved === 0) await new Promise(requestAnimationFrame)
      return {running: seen.running - began, moved: seen.moved - began}
    })
    running.push(times.running)
    moved.push(times.moved)
    await run.filter({hasText: "Stop"}).click()
    await page.getByRole("button", {name: "Reset"}).click()
    await run.filter({hasText: "Run"}).waitFor()
  }
  await browser.close()
  row("click Run to running (worker: source to main)", running)
  row("click Run to first frame in which the robot has moved", moved)
} finally {
  service.kill("SIGTERM")
}

// The peers do the same work for the same text: parse, type-check, link the library, and begin `main`, which has no robot and ends at once.
const scratch = mkdtempSync(join(tmpdir(), "rosy-bench-"))
try {
  const program = readFileSync(join(root, "examples/accelerate/Main.hs"), "utf8")
  writeFileSync(join(scratch, "Main.hs"), `module Main (main) where\nimport Rosy\n${program}`)
  const version = execFileSync("ghc", ["--numeric-version"], {encoding: "utf8"}).trim()
  const packages = ["-package-db", join(root, `dist-newstyle/packagedb/ghc-${version}`), "-package", "rosy"]
  const time = (command: string, args: string[]): number => {
    const began = performance.now()
    try {
      execFileSync(command, args, {cwd: scratch, stdio: "ignore"})
    } catch {
      // Without a robot the program ends with a sentence and a status; what counts is that it began.
    }
    return performance.now() - began
  }
  const peers = Math.max(3, Math.floor(RUNS / 5))
  row(
    "runghc",
    Array.from({length: peers}, () => time("runghc", [...packages.map(p => `--ghc-arg=${p}`), "Main.hs"])),
  )
  row(
    "ghc -O0, then the program",
    Array.from({length: peers}, () => {
      const compile = time("ghc", [
        "-O0",
        "-dynamic",
        "-fforce-recomp",
        "-v0",
        ...packages,
        "Main.hs",
        "-o",
        "program",
      ])
      return compile + time("./program", [])
    }),
  )
} finally {
  rmSync(scratch, {recursive: true, force: true})
}
