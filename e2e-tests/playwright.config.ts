/// How the stories are played: the real service on a free port, the system's Chromium, one page at a time.

import {defineConfig} from "@playwright/test"

// Set once by the first process that reads this file; Playwright's workers inherit it.
process.env["ROSY_E2E_PORT"] ??= String(20_000 + Math.floor(Math.random() * 10_000))
const port = process.env["ROSY_E2E_PORT"]
const root = new URL("..", import.meta.url).pathname
const reports = process.env["ROSY_REPORTS"] ?? `${root}.rosy/reports`

export default defineConfig({
  testDir: "stories",
  outputDir: "test-results",
  fullyParallel: false,
  workers: 1,
  // For stories that hang; a slow machine needs its time.
  timeout: 240_000,
  expect: {timeout: 60_000},
  retries: process.env["CI"] ? 1 : 0,
  reporter: [["list"], ["json", {outputFile: `${reports}/e2e.json`}]],
  use: {
    baseURL: `http://127.0.0.1:${port}`,
    viewport: {width: 1440, height: 900},
    actionTimeout: 120_000,
    trace: "retain-on-failure",
    launchOptions: {
      timeout: 240_000,
      executablePath: process.env["ROSY_CHROMIUM"] ?? "/usr/bin/chromium",
      args: [
        "--no-sandbox",
        "--disable-gpu",
        "--disable-quic",
        "--no-first-run",
        "--disable-background-networking",
        "--disable-component-update",
        "--disable-sync",
      ],
    },
  },
  webServer: {
    command: `${root}rosy start --no-browser --port ${port}`,
    url: `http://127.0.0.1:${port}/api/health`,
    timeout: 600_000,
    stdout: "ignore",
    stderr: "pipe",
    gracefulShutdown: {signal: "SIGTERM", timeout: 5_000},
  },
})
