/// Settings of the stories: the real service on a free port, the system's Chromium (its headless shell where that is installed), two stories at a time.

import {fileURLToPath} from "node:url"
import {defineConfig} from "@playwright/test"
import {chromiumFlags, chromiumPath} from "../editor/test/chromium.ts"

// Set once by the first process that reads this file; Playwright's workers inherit it.
process.env["ROSY_E2E_PORT"] ??= String(20_000 + Math.floor(Math.random() * 10_000))
const port = process.env["ROSY_E2E_PORT"]
const root = fileURLToPath(new URL("..", import.meta.url))
export const reports = process.env["ROSY_REPORTS"] ?? `${root}.rosy/reports`

export default defineConfig({
  testDir: "stories",
  outputDir: "test-results",
  // Stories do not depend on each other. Two at a time keep one and a half of two cores busy beside the Python tests: a third one
  // made pauses of several seconds on a slow machine, as no learner has them.
  fullyParallel: true,
  workers: 2,
  // Limits for stories that hang. A busy machine may take minutes for what takes seconds.
  timeout: 1_800_000,
  expect: {timeout: Number(process.env["ROSY_EXPECT"] ?? 180_000)},
  // The pictures of the guide.
  snapshotPathTemplate: `${root}docs/pictures/{arg}{ext}`,
  // A story that passes on its second attempt only has failed.
  retries: 0,
  reporter: [["list"], ["json", {outputFile: `${reports}/e2e.json`}]],
  use: {
    baseURL: `http://127.0.0.1:${port}`,
    viewport: {width: 1440, height: 900},
    actionTimeout: 180_000,
    // A trace makes building by mouse two and a half times as slow: ROSY_TRACE=1 records one of each story that fails.
    trace: process.env["ROSY_TRACE"] === "1" ? "retain-on-failure" : "off",
    screenshot: "only-on-failure",
    launchOptions: {
      timeout: 240_000,
      executablePath: chromiumPath,
      args: chromiumFlags,
    },
  },
  webServer: {
    command: `"${root}rosy" start --no-browser --port ${port}`,
    url: `http://127.0.0.1:${port}/api/health`,
    timeout: 600_000,
    stdout: "ignore",
    stderr: "pipe",
    gracefulShutdown: {signal: "SIGTERM", timeout: 5_000},
  },
})
