/// How long until the page can be used, and how long from pressing Run to a robot that has moved, in a real browser on the real service; and beside
/// the latter, in the same run, how long `runghc` and `ghc -O0` need for the same program before it does anything.
///
/// A frame counts when the page has been told of a pose other than the start's. Nothing is asserted: machines differ.

import {execFileSync} from "node:child_process"
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs"
import {tmpdir} from "node:os"
import {join} from "node:path"
import type {Browser} from "@playwright/test"
import {openPage, root, row, setting, withPage} from "./service.ts"

const RUNS = setting("ROSY_BENCH_RUNS", 50)
const OPENINGS = setting("ROSY_BENCH_OPENINGS", 10)

/// From the address to a page on which a program can be run, read and edited; with nothing of it in the browser, and again with what it keeps.
async function openings(browser: Browser, address: string): Promise<void> {
  const cold: number[] = []
  const warm: number[] = []
  const kilobytes = new Set<string>()
  for (let i = 0; i < OPENINGS; i++) {
    const page = await openPage(browser)
    for (const times of [cold, warm]) {
      await page.goto(`${address}?example=accelerate`, {waitUntil: "commit"})
      const {took, bytes} = await page.evaluate(
        () =>
          new Promise<{took: number; bytes: number}>(done => {
            const look = () => {
              const blocks = document.querySelectorAll(".blocklyBlockCanvas > .blocklyDraggable")
              const text = document.querySelector(".cm-content")?.textContent ?? ""
              const run = document.querySelector("[data-testid=run]")?.textContent ?? ""
              if (blocks.length === 0 || !text.includes("simulate") || !run.includes("Run"))
                return void requestAnimationFrame(look)
              setTimeout(() => {
                const got = performance.getEntriesByType("resource") as PerformanceResourceTiming[]
                done({took: performance.now(), bytes: got.reduce((sum, r) => sum + r.transferSize, 0)})
              })
            }
            look()
          }),
      )
      times.push(took)
      kilobytes.add(`${times === cold ? "first" : "again"} ${Math.round(bytes / 1000)} kB`)
    }
    await page.close()
  }
  row("the address to a program that can be run, the first time", cold)
  row("the same again", warm, [...kilobytes].join(", "))
}

await withPage(async (browser, address) => {
  await openings(browser, address)
  const page = await openPage(browser)
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
  await page.goto(`${address}?example=accelerate`)
  const run = page.getByTestId("run")
  // A program can be run once the page has heard from the service; until then the button is disabled and a click is lost.
  const ready = page.locator("[data-testid=run]:enabled", {hasText: "Run"})
  await ready.waitFor()
  const running: number[] = []
  const moved: number[] = []
  // The first run waits until the worker has warmed up; it is not counted.
  for (let i = -1; i < RUNS; i++) {
    const times = await page.evaluate(async () => {
      const seen = (window as unknown as {seen: {running: number; moved: number}}).seen
      seen.running = 0
      seen.moved = 0
      const began = performance.now()
      ;(document.querySelector("[data-testid=run]") as HTMLElement).click()
      while (seen.moved === 0) await new Promise(requestAnimationFrame)
      return {running: seen.running - began, moved: seen.moved - began}
    })
    if (i >= 0) {
      running.push(times.running)
      moved.push(times.moved)
    }
    await run.filter({hasText: "Stop"}).click()
    await page.getByRole("button", {name: "Reset"}).click()
    await ready.waitFor()
  }
  row("click Run to running (worker: source to main)", running)
  row("click Run to first frame in which the robot has moved", moved)
})

// The peers do the same work for the same text: parse, type-check, link the library, and begin `main`, which has no robot and ends at once.
const scratch = mkdtempSync(join(tmpdir(), "rosy-bench-"))
try {
  const program = readFileSync(join(root, "examples/accelerate/Main.hs"), "utf8")
  writeFileSync(join(scratch, "Main.hs"), `module Main (main) where\nimport Rosy\n${program}`)
  const version = execFileSync("ghc", ["--numeric-version"], {encoding: "utf8"}).trim()
  // All packages of a database are visible. `-package rosy` would be one of its three libraries to GHC 9.10.
  const packages = ["-package-db", join(root, `dist-newstyle/packagedb/ghc-${version}`)]
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
